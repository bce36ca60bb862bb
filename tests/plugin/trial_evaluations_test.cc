// Whatever a host tries between the steps of a drive, the drive goes on to the bit as if nothing
// had been tried.
#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "tests/plugin/simulation.h"

namespace softsoil {
namespace {

using Numbers = std::vector<double>;

// A vehicle on soil with motors that follow a fixed course.
struct Drive {
  Model m;
  Data d;
  int steps = 0;

  explicit Drive(Model model) : m(std::move(model)), d(MakeData(m)) {
    EXPECT_EQ(softsoil_attach(m.get(), d.get(), nullptr), 0) << softsoil_error();
  }
  ~Drive() { ExpectNoWarnings(d); }

  void Step() {
    for (int u = 0; u < m->nu; ++u) d->ctrl[u] = 5 + u + steps % 7;
    ++steps;
    mj_step(m.get(), d.get());
  }
};

using Trial = std::function<void(Drive&)>;

// Tries before every step.
void Go(Drive* drive, int steps, const Trial& trial) {
  for (int i = 0; i < steps; ++i) {
    trial(*drive);
    drive->Step();
  }
}

Numbers Motion(const Drive& drive) {
  Numbers motion(drive.d->qpos, drive.d->qpos + drive.m->nq);
  motion.insert(motion.end(), drive.d->qvel, drive.d->qvel + drive.m->nv);
  return motion;
}

Numbers Heights(const Drive& drive) {
  Numbers heights;
  for (double x = -0.8; x < 0.8; x += 0.04) {
    for (double y = -0.48; y < 0.48; y += 0.04) {
      double height = 1;
      EXPECT_EQ(softsoil_height(drive.d.get(), x, y, &height), 0);
      heights.push_back(height);
    }
  }
  return heights;
}

Numbers Wheels(const Drive& drive) {
  Numbers results;
  for (int i = 0; i < softsoil_wheel_count(drive.d.get()); ++i) {
    softsoilWheel wheel = {};
    EXPECT_EQ(softsoil_wheel(drive.d.get(), i, &wheel), 0);
    for (const double value : {wheel.load, wheel.sinkage, wheel.slip_ratio, wheel.thrust,
                               wheel.drawbar_pull, wheel.compaction_energy}) {
      results.push_back(value);
    }
  }
  return results;
}

Numbers AppliedForces(const Drive& drive) {
  return Numbers(drive.d->xfrc_applied, drive.d->xfrc_applied + 6 * drive.m->nbody);
}

// Says nothing, and moves, sinks and pulls as a drive that tried nothing.
void ExpectNoTrace(const std::function<Model()>& load, int steps, const Trial& trial) {
  Drive plain(load()), tried(load());
  Go(&plain, steps, [](Drive&) {});
  testing::internal::CaptureStderr();
  Go(&tried, steps, trial);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  for (Drive* drive : {&plain, &tried}) mj_forward(drive->m.get(), drive->d.get());
  ASSERT_NE(Heights(plain), Heights(Drive(load()))) << "there is a rut to compare";
  EXPECT_EQ(Motion(tried), Motion(plain));
  EXPECT_EQ(Heights(tried), Heights(plain));
  EXPECT_EQ(Wheels(tried), Wheels(plain));
  EXPECT_EQ(AppliedForces(tried), AppliedForces(plain));
}

const char* const kMotor = R"(<motor joint="spin" gear="20"/>)";
const char* const kTwoMotors = R"(<motor joint="spin" gear="20"/><motor joint="spin" gear="9"/>)";
const char* const kLaggingMotor =
    R"(<motor joint="spin"/><general joint="spin" gear="20" dyntype="filter" dynprm=".1"/>)";

std::function<Model()> OneWheelUnder(const std::string& integrator, const char* motors = "") {
  return [=] {
    OneWheel model;
    model.option = "integrator=\"" + integrator + "\"";
    model.others = "<actuator>" + std::string(motors) + "</actuator>";
    return Load(model.Mjcf());
  };
}

std::function<Model()> RoverUnder(int integrator) {
  return [=] {
    char error[500] = "";
    Model m(mj_loadXML(SOFTSOIL_SOURCE_DIR "/examples/01_rover.xml", nullptr, error, sizeof error));
    EXPECT_NE(m, nullptr) << error;
    m->opt.integrator = integrator;
    return m;
  };
}

// What a careful host keeps of a state.
class Saved {
 public:
  explicit Saved(const Drive& drive)
      : time_(drive.d->time),
        qpos_(drive.d->qpos, drive.d->qpos + drive.m->nq),
        qvel_(drive.d->qvel, drive.d->qvel + drive.m->nv) {}

  void PutBack(Drive* drive, bool time_too) const {
    if (time_too) drive->d->time = time_;
    mju_copy(drive->d->qpos, qpos_.data(), drive->m->nq);
    mju_copy(drive->d->qvel, qvel_.data(), drive->m->nv);
  }

 private:
  double time_;
  Numbers qpos_, qvel_;
};

struct Jacobians {
  Numbers a, b;
};

Jacobians TransitionFd(Drive* drive, bool centred) {
  const mjModel* m = drive->m.get();
  const int n = 2 * m->nv + m->na;
  Jacobians result{Numbers(n * n), Numbers(n * m->nu)};
  mjd_transitionFD(m, drive->d.get(), 1e-6, centred, result.a.data(),
                   m->nu > 0 ? result.b.data() : nullptr, nullptr, nullptr);
  return result;
}

Trial TransitionFdTrial(bool centred, bool restores_time) {
  return [=](Drive& drive) {
    const double time = drive.d->time;
    TransitionFd(&drive, centred);
    ASSERT_GT(drive.d->time, time) << "else there was nothing to guard against";
    if (restores_time) drive.d->time = time;
  };
}

// By hand: velocities, then positions, one at a time.
Trial DifferencesByHand(bool restores_time) {
  return [=](Drive& drive) {
    const Saved saved(drive);
    const auto step_and_put_back = [&] {
      mj_step(drive.m.get(), drive.d.get());
      saved.PutBack(&drive, restores_time);
    };
    step_and_put_back();
    for (int i = 0; i < drive.m->nv; ++i) {
      drive.d->qvel[i] += 1e-5;
      step_and_put_back();
    }
    for (int i = 0; i < drive.m->nv; ++i) {
      Numbers unit(drive.m->nv);
      unit[i] = 1;
      mj_integratePos(drive.m.get(), drive.d->qpos, unit.data(), 1e-5);
      step_and_put_back();
    }
  };
}

class TrialEvaluations : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Under, TrialEvaluations, testing::Values("Euler", "implicit", "RK4"));

TEST_P(TrialEvaluations, OfForwardDynamicsLeaveNoTrace) {
  ExpectNoTrace(OneWheelUnder(GetParam()), 60, [](Drive& drive) {
    for (int i = 0; i < 100; ++i) mj_forward(drive.m.get(), drive.d.get());
  });
}

TEST_P(TrialEvaluations, OfInverseDynamicsLeaveNoTrace) {
  ExpectNoTrace(OneWheelUnder(GetParam()), 300, [](Drive& drive) {
    for (int i = 0; i < drive.m->nv; ++i) drive.d->qacc[i] = 3 * i - 2;
    mj_inverse(drive.m.get(), drive.d.get());
  });
}

TEST_P(TrialEvaluations, OfTransitionFdLeaveNoTrace) {
  for (const bool centred : {false, true}) {
    for (const bool restores_time : {false, true}) {
      for (const char* motors : {"", kTwoMotors, kLaggingMotor}) {
        SCOPED_TRACE(testing::Message() << "centred " << centred << ", restores time "
                                        << restores_time << ", motors " << motors);
        ExpectNoTrace(OneWheelUnder(GetParam(), motors), 150,
                      TransitionFdTrial(centred, restores_time));
      }
    }
  }
}

TEST_P(TrialEvaluations, OfTransitionFdInTheControlsAloneLeaveNoTrace) {
  ExpectNoTrace(OneWheelUnder(GetParam(), kTwoMotors), 300, [](Drive& drive) {
    Numbers b(2 * drive.m->nv * drive.m->nu);
    mjd_transitionFD(drive.m.get(), drive.d.get(), 1e-6, 0, nullptr, b.data(), nullptr, nullptr);
  });
}

TEST_P(TrialEvaluations, OfDifferencesByHandLeaveNoTrace) {
  for (const bool restores_time : {false, true}) {
    SCOPED_TRACE(restores_time);
    ExpectNoTrace(OneWheelUnder(GetParam(), kMotor), 300, DifferencesByHand(restores_time));
  }
}

TEST_P(TrialEvaluations, OfOneStepPutBackLeaveNoTrace) {
  ExpectNoTrace(OneWheelUnder(GetParam(), kMotor), 300, [](Drive& drive) {
    const Saved saved(drive);
    for (const double ctrl : {-30, 0, 30}) {
      drive.d->ctrl[0] = ctrl;
      mj_step(drive.m.get(), drive.d.get());
      saved.PutBack(&drive, true);
    }
  });
}

TEST_P(TrialEvaluations, OfAWholeVehicleLeaveNoTrace) {
  const int integrator = GetParam() == "Euler" ? mjINT_EULER
                         : GetParam() == "RK4" ? mjINT_RK4
                                               : mjINT_IMPLICIT;
  ExpectNoTrace(RoverUnder(integrator), 60, TransitionFdTrial(false, false));
}

TEST(TrialEvaluationsOfInverseDynamics, ReproduceTheAppliedForces) {
  Drive drive(OneWheelUnder("Euler", kMotor)());
  Go(&drive, 300, [](Drive&) {});
  mjModel* m = drive.m.get();
  mjData* d = drive.d.get();
  mj_forward(m, d);
  mj_inverse(m, d);
  Numbers applied(d->qfrc_actuator, d->qfrc_actuator + m->nv);
  for (int body = 1; body < m->nbody; ++body) {
    const double* row = d->xfrc_applied + 6 * body;
    mj_applyFT(m, d, row, row + 3, d->xipos + 3 * body, body, applied.data());
  }
  ASSERT_GT(applied[1], 100) << "the soil carries the wheel";
  for (int i = 0; i < m->nv; ++i) EXPECT_NEAR(d->qfrc_inverse[i], applied[i], 1e-8);
}

// State after one step from a drive of its own, one coordinate of position, velocity or control
// moved before.
Numbers AfterOneStep(const std::function<Model()>& load, int column, double change) {
  Drive drive(load());
  Go(&drive, 200, [](Drive&) {});
  const int nv = drive.m->nv;
  if (column >= 2 * nv) {
    drive.d->ctrl[column - 2 * nv] += change;
  } else {
    (column < nv ? drive.d->qpos[column] : drive.d->qvel[column - nv]) += change;
  }
  mj_step(drive.m.get(), drive.d.get());
  return Motion(drive);
}

// Not under RK4, where mjd_transitionFD starts from what the last stage before has left.
class Derivatives : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Under, Derivatives, testing::Values("Euler", "implicit"));

TEST_P(Derivatives, OfTransitionFdAreThoseOfDrivesOfTheirOwn) {
  const auto load = OneWheelUnder(GetParam(), kTwoMotors);
  Drive drive(load());
  Go(&drive, 200, [](Drive&) {});
  const Jacobians found = TransitionFd(&drive, true);
  const int nv = drive.m->nv, n = 2 * nv, nu = drive.m->nu;
  ASSERT_EQ(nv, drive.m->nq);
  const double eps = 1e-6;
  for (int column = 0; column < n + nu; ++column) {
    const Numbers after = AfterOneStep(load, column, eps);
    const Numbers before = AfterOneStep(load, column, -eps);
    for (int row = 0; row < n; ++row) {
      const double found_here =
          column < n ? found.a[row * n + column] : found.b[row * nu + column - n];
      EXPECT_NEAR(found_here, (after[row] - before[row]) / (2 * eps), 1e-7)
          << "row " << row << ", column " << column;
    }
  }
  EXPECT_LT(found.a[(nv + 1) * n + 1], -0.1) << "the soil is a spring";
}

}  // namespace
}  // namespace softsoil
