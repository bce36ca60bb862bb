// Which of 16 ways to drive the wheels brings a rover on soft sand nearest to its goal? Each is
// tried from the same instant on a copy of the simulation, rut and all; then the rover takes the
// best: rollouts MODEL.xml
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <thread>
#include <vector>

#include "../host.h"

namespace {

constexpr double kGoal[2] = {1.1, 0.08};  // [m]
constexpr double kApproach = 0.5;         // [s]  until the rover decides
constexpr double kHorizon = 1;            // [s]  that it looks ahead
constexpr int kThreads = 2;

struct Candidate {
  double left, right;  // [rad/s]  set speed of the wheels
  Data d;              // a simulation of its own
};

void Drive(const mjModel* m, mjData* d, const std::array<double, 2>& speeds, double until) {
  for (int wheel = 0; wheel < m->nu; ++wheel) d->ctrl[wheel] = speeds[wheel % 2];
  while (d->time < until) mj_step(m, d);
}

Data Copy(const mjModel* m, const mjData* d) {
  Data copy = MakeData(m);
  mj_copyData(copy.get(), m, d);
  Check(softsoil_copy(copy.get(), d));  // ground is shared until one of the two changes it
  return copy;
}

std::vector<Candidate> Candidates(const mjModel* m, const mjData* d) {
  std::vector<Candidate> candidates;
  for (const double speed : {3.0, 5.0, 7.0, 9.0}) {
    for (const double turn : {-0.3, 0.0, 0.3, 0.6}) {
      candidates.push_back({speed * (1 - turn), speed * (1 + turn), Copy(m, d)});
    }
  }
  return candidates;
}

// Different mjData may step in different threads.
void RollOut(const mjModel* m, std::vector<Candidate>& candidates, double until) {
  std::vector<std::thread> threads;
  for (int first = 0; first < kThreads; ++first) {
    threads.emplace_back([&, first] {
      for (std::size_t i = first; i < candidates.size(); i += kThreads) {
        Candidate& c = candidates[i];
        Drive(m, c.d.get(), {c.left, c.right}, until);
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
}

double DistanceToGoal(const mjData* d) {
  return std::hypot(d->qpos[0] - kGoal[0], d->qpos[1] - kGoal[1]);
}

const Candidate& Nearest(const std::vector<Candidate>& candidates) {
  const Candidate* best = &candidates[0];
  for (const Candidate& c : candidates) {
    if (DistanceToGoal(c.d.get()) < DistanceToGoal(best->d.get())) best = &c;
  }
  return *best;
}

std::uint64_t Hash(const mjData* d) {
  std::uint64_t hash = 0;
  Check(softsoil_hash(d, &hash));
  return hash;
}

void Print(const Candidate& c, bool is_best) {
  softsoilWheel wheel;
  Check(softsoil_wheel(c.d.get(), softsoil_wheel_count(c.d.get()) - 1, &wheel));
  std::printf("%8.1f %7.1f %7.2f %6.2f %8.2f %9.0f %8.0f %s\n", c.left, c.right, c.d->qpos[0],
              c.d->qpos[1], DistanceToGoal(c.d.get()), 1000 * wheel.rut_depth,
              100 * wheel.slip_ratio, is_best ? "<- best" : "");
}

bool IsSame(const mjModel* m, const mjData* a, const mjData* b) {
  return std::memcmp(a->qpos, b->qpos, m->nq * sizeof *a->qpos) == 0 &&
         std::memcmp(a->qvel, b->qvel, m->nv * sizeof *a->qvel) == 0 && Hash(a) == Hash(b);
}

}  // namespace

int main(int argc, char** argv) {
  Require(argc == 2, "usage: rollouts MODEL.xml");
  const Model m = Load(argv[1]);
  const Data rover = MakeData(m.get());
  Check(softsoil_attach(m.get(), rover.get(), "sync=1 threads=1"));  // the threads are ours
  Drive(m.get(), rover.get(), {4, 4}, kApproach);

  std::vector<Candidate> candidates = Candidates(m.get(), rover.get());
  const double until = rover->time + kHorizon;
  RollOut(m.get(), candidates, until);
  const Candidate& best = Nearest(candidates);

  std::printf(
      "From %.2f, %.2f m to %.2f, %.2f m: wheels [rad/s], place after %g s [m], last wheel\n",
      rover->qpos[0], rover->qpos[1], kGoal[0], kGoal[1], kHorizon);
  std::printf("    left   right       x      y  to goal  rut [mm] slip [%%]\n");
  for (const Candidate& c : candidates) Print(c, &c == &best);

  Drive(m.get(), rover.get(), {best.left, best.right}, until);
  const bool same = IsSame(m.get(), rover.get(), best.d.get());
  std::printf("The rover went to %.2f, %.2f m: %s\n", rover->qpos[0], rover->qpos[1],
              same ? "the same bits as foretold" : "not what was foretold");
  return same ? 0 : 1;
}
