// A file of softsoil_save_simulation(), damaged. An input is a list of edits of a sound file: five
// bytes each, where (32 bits) and what (8 bits). A first byte that is odd mends the checksum
// afterwards, so that what stands behind it is reached; the next two cut the file off.
#include <cstring>
#include <memory>
#include <vector>

#include "plugin/state_file.h"
#include "tests/fuzz/fuzz_target.h"

namespace softsoil {
namespace {

constexpr std::size_t kChecksum = sizeof(std::uint64_t);

Soil LooseSoil() {
  Soil soil{};
  soil.name = "loose";
  soil.bearing = {6800, 1134e3, 0.85};
  soil.shear = {7100, 0.37, 0.0106};
  soil.compaction = {500, 1200, 96e3, 1200, 20, 0.2, 0.004, 0};
  soil.concentration_factor = 5;
  return soil;
}

std::shared_ptr<const SoilPlan> OneWheelPlan() {
  const auto plan = std::make_shared<SoilPlan>();
  plan->soils = LooseSoil();
  plan->terrain.grid_spacing = 0.1;
  plan->terrain.volume_height = 0.1;
  plan->terrain.volumes = 1;
  plan->ground = {0, [](double, double) { return 0.0; }};
  plan->wheels.push_back(
      {1, "wheel", 0, {0, 0, 0}, {0, 1, 0}, WheelOutline::kCylinder, 0.4, 0.1, 0});
  Tire tire;
  tire.name = "stiff";
  tire.shape = {0.4, 10, 0.2};
  tire.spring.linear = 2e7;
  tire.damping = 0;
  tire.soil_friction = 0.6;
  plan->tires = {tire};
  plan->nq = plan->nv = 1;
  return plan;
}

// A mjData of one degree of freedom, as far as its state goes.
struct FakeData {
  mjModel m{};
  mjData d{};
  std::vector<char> names = {'f', '\0'};
  std::vector<mjtNum> numbers = std::vector<mjtNum>(100);

  FakeData() {
    m.nq = m.nv = m.nu = m.nbody = 1;
    m.names = names.data();
    m.nnames = static_cast<int>(names.size());
    mjtNum* next = numbers.data();
    for (mjtNum** array : {&d.qpos, &d.qvel, &d.act, &d.qacc_warmstart, &d.ctrl, &d.qfrc_applied,
                           &d.xfrc_applied, &d.qacc, &d.mocap_pos, &d.mocap_quat, &d.userdata}) {
      *array = next;
      next += 6;
    }
  }
};

// A wheel that has pressed the ground, with a soil job in flight.
struct Case {
  std::shared_ptr<const SoilPlan> plan = OneWheelPlan();
  SoftWheels wheels{plan->soils, plan->terrain, plan->ground.height, plan->tires};
  FakeData fake;
  ModelData data{&fake.m, &fake.d};
  SoilState undisturbed{plan, wheels.Undisturbed(), {}, {}, std::vector<OwnShare>(1), {}};
  std::vector<unsigned char> file;

  Case() {
    SoilState pressed = undisturbed;
    const TirePose pose{{0.8, 0.8, 0.35}, Eigen::Matrix3d::Identity(), {1, 0, 0}, {0, 2, 0}};
    for (int step = 0; step < 25; ++step) Press(wheels, pose);
    pressed.wheels = wheels.State();
    pressed.pending = {{pose}, 0.001};
    pressed.watch.See(&fake.m, &fake.d);
    WriteState(pressed, &data, [this](const void* bytes, std::size_t count) {
      const auto* first = static_cast<const unsigned char*>(bytes);
      file.insert(file.end(), first, first + count);
    });
  }

  static void Press(SoftWheels& wheels, const TirePose& pose) {
    std::vector<PatchForces> forces(1);
    wheels.Evaluate(0, pose, 0.001, &forces[0]);
    wheels.Commit({pose}, forces, 0.001);
  }
};

std::vector<unsigned char> Damaged(std::vector<unsigned char> file, const std::string& edits) {
  std::size_t at = 3;
  for (; at + 5 <= edits.size(); at += 5) {
    std::uint32_t where = 0;
    std::memcpy(&where, &edits[at], sizeof where);
    file[where % file.size()] = static_cast<unsigned char>(edits[at + 4]);
  }
  if (edits.size() < 3) return file;
  std::uint16_t cut = 0;
  std::memcpy(&cut, &edits[1], sizeof cut);
  file.resize(file.size() - std::min<std::size_t>(cut, file.size()));
  if (edits[0] % 2 == 0 || file.size() < kChecksum) return file;
  StateWriter hash;
  hash.PutBytes(file.data(), file.size() - kChecksum);
  const std::uint64_t checksum = hash.Finish();
  std::memcpy(&file[file.size() - kChecksum], &checksum, kChecksum);
  return file;
}

}  // namespace

// What is taken for sound must be so: a wheel goes on driving on it.
void Read(const std::string& edits) {
  static Case sound;
  const auto file = Damaged(sound.file, edits);
  SavedState saved = ParseState(file, sound.wheels, sound.undisturbed, &sound.fake.m);
  Exchange(&saved.mujoco, &sound.fake.m, &sound.fake.d);
  const SoilState& state = saved.soil;
  if (state.pending.poses.empty()) return;
  sound.wheels.SetState(state.wheels);
  for (int step = 0; step < 2; ++step) Case::Press(sound.wheels, state.pending.poses[0]);
}

}  // namespace softsoil
