// Shear strength of soil and how slip mobilises it.
#pragma once

#include <cmath>

#include "terrain/host_device.h"

namespace softsoil {

// How shear stress follows slip.
//   kJanosiHanamoto  tau = tau_max (1 - exp(-j/K))              equation 2.5
//   kHumped          tau = tau_max (j/K) exp(1 - j/K) to the peak at j = K; beyond it tau falls
//                    to residual * tau_max. Equation 2.8 (after Kacigin and Guskov 1968), which
//                    names the residual ratio K_r but has no term for it; 0 is as printed.
enum class ShearForm { kJanosiHanamoto, kHumped };

struct Shear {
  double cohesion;        // [Pa]   c, >= 0
  double friction_angle;  // [rad]  phi, 0 to below pi/2
  double modulus;         // [m]    K: slip that mobilises 63 % of the strength; humped: all, > 0
  ShearForm form = ShearForm::kJanosiHanamoto;
  double residual = 0;  // [-]  K_r of the humped form, 0 to 1
};

// What the strength of a soil depends on; worked out once where many points are asked about.
struct Strength {
  SOFTSOIL_HD Strength(const Shear& soil)
      : cohesion(soil.cohesion), tan_phi(std::tan(soil.friction_angle)) {}

  double cohesion;  // [Pa]
  double tan_phi;   // [-]
};

// Shear strength [Pa] of soil on soil under the pressure sigma [Pa].
SOFTSOIL_HD inline double MohrCoulomb(const Strength& soil, double sigma) {
  return soil.cohesion + sigma * soil.tan_phi;
}

// Largest shear stress [Pa] that a surface of friction coefficient mu_s can pass to soil under
// the pressure sigma [Pa]: Mohr-Coulomb in the soil or friction on the surface, whichever is less.
// Algorithm 4.1.4 lines 4 and 5 (line 5 prints tau_max where tau_mc is meant).
SOFTSOIL_HD inline double ShearStrength(const Strength& soil, double mu_s, double sigma) {
  if (sigma <= 0) return 0.0;
  const double mohr_coulomb = MohrCoulomb(soil, sigma);
  const double friction = mu_s * sigma;
  return mohr_coulomb < friction ? mohr_coulomb : friction;
}

// Share of the shear strength that is mobilised after Janosi and Hanamoto, as a vector in the
// tangent plane, length 0 to 1; and the way slipped since the contact began, in any direction.
struct Mobilisation {
  double t, b;      // [-]  along the tangent and the binormal of the node
  double slip = 0;  // [m]
};

// Mobilisation after slipping for the time h [s] at the velocity (v_t, v_b) [m/s].
//
// Janosi-Hanamoto in the form of a rate, dm = (v - |v| m) dt / K. From rest and at a constant
// direction it is |m| = 1 - exp(-j/K), equation 4.15 as it should read, for any time step. Unlike
// a slip displacement that is merely summed (4.10) it forgets the slip that it has already turned
// into plastic shear: the stress unloads and reverses with the slip, and the length never exceeds
// one.
SOFTSOIL_HD inline Mobilisation Slip(Mobilisation m, double v_t, double v_b, double h, double K) {
  const double speed = std::sqrt(v_t * v_t + v_b * v_b);
  if (speed <= 0) return m;
  const double kept = std::exp(-h * speed / K);
  const double towards_t = v_t / speed, towards_b = v_b / speed;
  return {towards_t + (m.t - towards_t) * kept, towards_b + (m.b - towards_b) * kept,
          m.slip + h * speed};
}

// Slip sinkage [m] while a surface slips by `way` [m]: S (tau/p) dj, how much deeper soil must lie
// to bear the same as before. tau/p is `strength_ratio` [-], the shear strength per pressure that
// undisturbed soil bears at this depth, so far as it is mobilised; of the way that part counts
// which is plastic shear and does not go into mobilising the soil. So p dz is a share S of the
// shear work: soil that has been pressed deep gives way less.
//
// In proportion to the way slipped and to tau, as plate tests show it nearly: s = c_0 p^c_1 j^c_2,
// Muro and O'Brien (2004). Work, unlike a slip ratio, is also there where a wheel spins on the spot
// or slides sideways.
SOFTSOIL_HD inline double SlipSinkage(double S, double strength_ratio, const Mobilisation& m,
                                      double way) {
  return S * strength_ratio * (m.t * m.t + m.b * m.b) * way;
}

// What a mobilised shear stress must be multiplied with after the way `slip` [m], so that a hump
// follows on a straight slip; 1 for Janosi-Hanamoto. The way counts, not the stress: a mat of roots
// or a crust that has been torn stays torn when the slip reverses.
SOFTSOIL_HD inline double HumpFactor(const Shear& soil, double slip) {
  if (soil.form == ShearForm::kJanosiHanamoto) return 1.0;
  const double x = slip / soil.modulus;
  if (x < 1e-9) return std::exp(1.0);  // the limit
  const double hump = x * std::exp(1 - x);
  const double share = x < 1 ? hump : soil.residual + (1 - soil.residual) * hump;
  return share / -std::expm1(-x);
}

}  // namespace softsoil
