// The folder that a command fills with its results.
#pragma once

#include <string>
#include <vector>

namespace softsoil {

// Held by one program at a time for as long as it lives: the results of two that run at once would
// be mixed.
class ResultFolder {
 public:
  // Makes the folder if it is not there, and takes away what an earlier run has left under `names`,
  // as it would be taken for results of a run that is killed. Throws InputError if files cannot be
  // written in it, if another program holds it, or if one of the `inputs` would be taken away.
  ResultFolder(const std::string& path, const std::vector<std::string>& names,
               const std::vector<std::string>& inputs = {});
  ~ResultFolder();
  ResultFolder(const ResultFolder&) = delete;
  ResultFolder& operator=(const ResultFolder&) = delete;

  // Takes away what this run has left, complete or not.
  void Clear() const;

 private:
  std::string path_;
  std::vector<std::string> names_;
  int lock_;
};

}  // namespace softsoil
