#include "tests/reference/wong_reece_oracle.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace softsoil_reference {
namespace {

const double kPi = std::acos(-1.0);
const double kDeepest = 1.55;  // [rad]  entry angle

using Function = std::function<double(double)>;

// Integral from a to b of a function with a root of any order at a: x = a + (b - a) u^p, so that
// the order p n of the root in u is high; five points of Gauss in each of equal panels of u.
double Integral(const Function& f, double a, double b, double n) {
  const double points[] = {0, -0.5384693101056831, 0.5384693101056831, -0.9061798459386640,
                           0.9061798459386640};
  const double weights[] = {0.5688888888888889, 0.4786286704993665, 0.4786286704993665,
                            0.2369268850561891, 0.2369268850561891};
  const int panels = 80;
  const double p = std::max(3.0, std::ceil(3 / n));
  double sum = 0;
  for (int panel = 0; panel < panels; ++panel) {
    for (int k = 0; k < 5; ++k) {
      const double u = (panel + 0.5 + 0.5 * points[k]) / panels;
      sum += weights[k] / (2 * panels) * f(a + (b - a) * std::pow(u, p)) * p * std::pow(u, p - 1);
    }
  }
  return (b - a) * sum;
}

// Where a function changes sign from below to above zero.
double Bisect(const Function& f, double below, double above) {
  for (int k = 0; k < 45; ++k) {
    const double middle = (below + above) / 2;
    (f(middle) < 0 ? below : above) = middle;
  }
  return (below + above) / 2;
}

double Sigma1(const SteadyWheel& w, double theta_1, double theta) {
  const double depth = w.radius * (std::cos(theta) - std::cos(theta_1));
  return depth > 0 ? w.modulus * std::pow(depth, w.n) : 0;
}

double Sigma2(const SteadyWheel& w, double theta_1, double theta_m, double theta) {
  return Sigma1(w, theta_1, theta_1 - theta / theta_m * (theta_1 - theta_m));
}

double Tau(const SteadyWheel& w, double sigma, double j) {
  return (w.cohesion + sigma * std::tan(w.friction_angle)) * (1 - std::exp(-j / w.shear_modulus));
}

// Stresses in front of and behind the angle of the greatest pressure, both as positive numbers,
// and the sign of tau in the rear.
struct Stresses {
  double theta_1, theta_m;
  Function sigma_1, sigma_2, tau_1, tau_2;
  double rear_sign;
};

double Integrals(const SteadyWheel& w, const Stresses& s, const Function& front,
                 const Function& rear) {
  return -Integral(front, s.theta_1, s.theta_m, w.n) + Integral(rear, 0, s.theta_m, w.n);
}

double Load(const SteadyWheel& w, const Stresses& s) {
  return w.radius * w.width *
         Integrals(
             w, s, [&](double t) { return s.sigma_1(t) * std::cos(t) + s.tau_1(t) * std::sin(t); },
             [&](double t) {
               return s.sigma_2(t) * std::cos(t) + s.rear_sign * s.tau_2(t) * std::sin(t);
             });
}

double Thrust(const SteadyWheel& w, const Stresses& s) {
  return w.radius * w.width *
         Integrals(
             w, s, [&](double t) { return s.tau_1(t) * std::cos(t); },
             [&](double t) { return s.rear_sign * s.tau_2(t) * std::cos(t); });
}

double Resistance(const SteadyWheel& w, const Stresses& s) {
  return w.radius * w.width *
         Integrals(
             w, s, [&](double t) { return s.sigma_1(t) * std::sin(t); },
             [&](double t) { return s.sigma_2(t) * std::sin(t); });
}

double Torque(const SteadyWheel& w, const Stresses& s) {
  return w.radius * w.radius * w.width *
         Integrals(w, s, s.tau_1, [&](double t) { return s.rear_sign * s.tau_2(t); });
}

SteadyRolling Rolling(const SteadyWheel& w, const Stresses& s, double skid) {
  const double thrust = Thrust(w, s), resistance = Resistance(w, s);
  return {s.theta_1,           s.theta_m,    w.radius * (1 - std::cos(s.theta_1)),
          Load(w, s),          thrust,       resistance,
          thrust - resistance, Torque(w, s), skid};
}

// Entry angle at which a wheel carries its load.
double EntryAngle(const SteadyWheel& w, double least,
                  const std::function<Stresses(double)>& at_entry_angle) {
  return Bisect([&](double theta_1) { return Load(w, at_entry_angle(theta_1)) - w.load; }, least,
                kDeepest);
}

Stresses UnderDrivenWheel(const SteadyWheel& w, double theta_1, double theta_m, double i) {
  Stresses s = {theta_1, theta_m, {}, {}, {}, {}, 1};
  const auto j = [=](double theta) {
    return w.radius * (theta_1 - theta - (1 - i) * (std::sin(theta_1) - std::sin(theta)));
  };
  s.sigma_1 = [=](double theta) { return Sigma1(w, theta_1, theta); };
  s.sigma_2 = [=](double theta) { return Sigma2(w, theta_1, theta_m, theta); };
  s.tau_1 = [=](double theta) { return Tau(w, s.sigma_1(theta), j(theta)); };
  s.tau_2 = [=](double theta) { return Tau(w, s.sigma_2(theta), j(theta)); };
  return s;
}

// Equation 2.20.
double Theta0(const SteadyWheel& w, double skid) {
  const double slope = std::tan(kPi / 4 - w.friction_angle / 2);
  return Bisect(
      [&](double theta) { return slope * std::sin(theta) - std::cos(theta) + 1 / (1 + skid); }, 0,
      kPi / 2);
}

Stresses UnderTowedWheel(const SteadyWheel& w, double theta_1, double theta_0, double skid) {
  Stresses s = {theta_1, theta_0, {}, {}, {}, {}, -1};
  const double k_v =
      ((1 + skid) * (std::sin(theta_1) - std::sin(theta_0)) / (theta_1 - theta_0) - 1) / (1 + skid);
  const auto j_1 = [=](double theta) {
    return w.radius * ((theta_1 - theta) * (1 + k_v * (1 + skid)) -
                       (1 + skid) * (std::sin(theta_1) - std::sin(theta)));
  };
  const auto j_2 = [=](double theta) {
    return w.radius * (theta_0 - theta - (1 + skid) * (std::sin(theta_0) - std::sin(theta)));
  };
  s.sigma_1 = [=](double theta) { return Sigma1(w, theta_1, theta); };
  s.sigma_2 = [=](double theta) { return Sigma2(w, theta_1, theta_0, theta); };
  s.tau_1 = [=](double theta) { return Tau(w, s.sigma_1(theta), j_1(theta)); };
  s.tau_2 = [=](double theta) { return Tau(w, s.sigma_2(theta), -j_2(theta)); };
  return s;
}

}  // namespace

SteadyRolling Driven(const SteadyWheel& w, double c_1, double c_2, double slip) {
  const auto at = [&](double theta_1) {
    return UnderDrivenWheel(w, theta_1, (c_1 + c_2 * slip) * theta_1, slip);
  };
  return Rolling(w, at(EntryAngle(w, 0, at)), 0);
}

SteadyRolling Towed(const SteadyWheel& w) {
  const auto at_skid = [&](double skid) {
    const double theta_0 = Theta0(w, skid);
    const auto at = [&](double theta_1) { return UnderTowedWheel(w, theta_1, theta_0, skid); };
    return at(EntryAngle(w, theta_0, at));
  };
  const double skid = Bisect([&](double i) { return -Torque(w, at_skid(i)); }, 0, 3);
  return Rolling(w, at_skid(skid), skid);
}

}  // namespace softsoil_reference
