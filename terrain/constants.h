// Numbers of mathematics.
#pragma once

namespace softsoil {

constexpr double kPi = 3.14159265358979323846;
constexpr double kDegrees = 180 / kPi;  // [deg per rad]

}  // namespace softsoil
