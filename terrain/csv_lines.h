// Reads CSV files line by line: cells between commas, blanks around them dropped, lines that start
// with # and empty lines skipped. Errors name file and line.
#pragma once

#include <fstream>
#include <string>
#include <vector>

namespace softsoil {

class CsvLines {
 public:
  // Throws InputError if the file cannot be read.
  explicit CsvLines(const std::string& file);

  // The cells of the next line that says something; false at the end.
  bool Next(std::vector<std::string>* cells);

  // Number, from 1, of the line that Next() gave last.
  int line() const { return number_; }

  // The number in a cell of the column `name`. Throws InputError.
  double Number(const std::string& name, const std::string& cell) const;

  // Throws InputError unless there are as many cells as in the header.
  void RequireWidth(const std::vector<std::string>& cells, std::size_t width) const;

  // Throws InputError with the place of the current line, or of another.
  [[noreturn]] void Refuse(const std::string& rule) const { Refuse(number_, rule); }
  [[noreturn]] void Refuse(int line, const std::string& rule) const;

 private:
  std::string file_;
  std::ifstream stream_;
  int number_ = 0;
};

}  // namespace softsoil
