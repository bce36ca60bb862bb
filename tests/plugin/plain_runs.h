// How mjData end that only step: the oracle of all that copies, restores and resets them.
#pragma once

#include <cstddef>
#include <cstring>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "plugin/host.h"
#include "tests/plugin/simulation.h"

namespace softsoil {

using Controls = std::vector<int>;  // by step
using Numbers = std::vector<double>;

// A wheel with two motors that is pressed into soil that compacts, on a coarse grid.
inline std::string TwoMotors(const std::string& integrator, bool sync, int nuserdata) {
  OneWheel model;
  model.wheel_geom = R"(type="cylinder" zaxis="0 1 0" size=".4 .05")";
  model.timestep = "0.004";
  model.option = "integrator=\"" + integrator + "\"";
  model.custom = R"(<text name="softsoil_soil" data="upland_sandy_loam"/>
                    <numeric name="softsoil_grid_spacing" data="0.1"/>
                    <numeric name="softsoil_volume_height" data="0.1"/>
                    <numeric name="softsoil_volumes" data="6"/>
                    <numeric name="softsoil_threads" data="1"/>
                    <numeric name="softsoil_sync" data=")" +
                 std::to_string(sync) + R"("/>)";
  model.others = "<size nuserdata=\"" + std::to_string(nuserdata) + R"("/>
    <actuator><motor joint="spin"/><motor joint="along"/></actuator>)";
  std::string mjcf = model.Mjcf();
  mjcf.replace(mjcf.find("pos=\"0 0 .4\""), 12, "pos=\"0 0 .35\"");
  mjcf.replace(mjcf.find("mass=\"190\""), 10, "mass=\"900\"");
  const std::string joint = "<joint type=\"slide\" axis=\"1 0 0\"";
  mjcf.replace(mjcf.find(joint), joint.size(), joint + " name=\"along\"");
  return mjcf;
}

constexpr int kControls = 3;
constexpr double kTorque[kControls] = {0, 300, -100};   // [N m]
constexpr double kForce[kControls] = {4000, 0, -3000};  // [N]

// What must be the same to the bit.
struct Outcome {
  Numbers numbers;  // motion, results of the wheel, heights
  std::uint64_t hash = 0;
  bool operator==(const Outcome& other) const {
    return numbers == other.numbers && hash == other.hash;
  }
};

// A model, its mjData on soil, and how plain runs on it end.
class PlainRuns {
 public:
  explicit PlainRuns(const std::string& mjcf)
      : m(Load(mjcf)), plan_(std::make_shared<SoilPlan>(MakePlan(m.get(), SettingsOf(m.get())))) {
    InstallCallbacks();
  }

  Data Make() const {
    Data d = MakeData(m);
    GiveSoil(m.get(), d.get(), plan_);
    return d;
  }

  void Step(mjData* d, int control) const {
    d->ctrl[0] = kTorque[control];
    d->ctrl[1] = kForce[control];
    mj_step(m.get(), d);
  }

  Outcome Ask(mjData* d) const {
    mj_forward(m.get(), d);
    Outcome outcome;
    Numbers& numbers = outcome.numbers;
    numbers.assign(d->qpos, d->qpos + m->nq);
    numbers.insert(numbers.end(), d->qvel, d->qvel + m->nv);
    softsoilWheel wheel = {};
    EXPECT_EQ(softsoil_wheel(d, 0, &wheel), 0) << softsoil_error();
    constexpr std::size_t kFirst = offsetof(softsoilWheel, load);  // numbers from here on
    Numbers results((sizeof wheel - kFirst) / sizeof(double));
    std::memcpy(results.data(), reinterpret_cast<const char*>(&wheel) + kFirst,
                sizeof wheel - kFirst);
    numbers.insert(numbers.end(), results.begin(), results.end());
    for (double x = -0.6; x < 0.6; x += 0.07) {
      double height = 1;
      EXPECT_EQ(softsoil_height(d, x, 0.03, &height), 0) << softsoil_error();
      numbers.push_back(height);
    }
    EXPECT_EQ(softsoil_hash(d, &outcome.hash), 0) << softsoil_error();
    return outcome;
  }

  const Outcome& Run(const Controls& controls) {
    const auto [it, is_new] = plain_runs_.try_emplace(controls);
    if (is_new) {
      const Data d = Make();
      for (const int control : controls) Step(d.get(), control);
      it->second = Ask(d.get());
    }
    return it->second;
  }

  const Model m;

 private:
  std::shared_ptr<const SoilPlan> plan_;
  std::map<Controls, Outcome> plain_runs_;
};

}  // namespace softsoil
