// How far a run is, on one line of a terminal; silent elsewhere.
#pragma once

namespace softsoil {

class Progress {
 public:
  explicit Progress(double end);  // [s]  simulated time of the whole run
  ~Progress();                    // leaves the line empty
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  // simulated and wall time [s] since the start. Cheap: writes a few times a second.
  void Show(double simulated, double wall);

 private:
  double end_;
  double next_ = 0;  // [s]  wall time of the next line
  bool terminal_;
};

}  // namespace softsoil
