// A simulation on soft soil, through the C API.
#pragma once

#include <functional>

#include "plugin/softsoil.h"
#include "tests/plugin/one_wheel.h"

namespace softsoil {

// A mjData on soil.
struct Simulation {
  Model m;
  Data d;

  explicit Simulation(const OneWheel& model, const char* settings = nullptr)
      : m(Load(model.Mjcf())), d(MakeData(m)) {
    EXPECT_EQ(softsoil_attach(m.get(), d.get(), settings), 0) << softsoil_error();
  }
  Simulation(Simulation&&) = default;
  ~Simulation() {
    if (d != nullptr) ExpectNoWarnings(d);
  }

  void Run(
      double seconds, const std::function<void()>& before_step = [] {}) {
    for (double end = d->time + seconds; d->time < end - 1e-9;) {
      before_step();
      mj_step(m.get(), d.get());
    }
  }
  softsoilWheel Wheel() const {
    softsoilWheel wheel = {};
    EXPECT_EQ(softsoil_wheel(d.get(), 0, &wheel), 0) << softsoil_error();
    return wheel;
  }
  double Height(double x = 0) const {
    double height = 1;
    EXPECT_EQ(softsoil_height(d.get(), x, 0, &height), 0) << softsoil_error();
    return height;
  }
  int WheelBody() const { return mj_name2id(m.get(), mjOBJ_BODY, "wheel"); }
  double* Row() const { return d->xfrc_applied + 6 * WheelBody(); }
};

}  // namespace softsoil
