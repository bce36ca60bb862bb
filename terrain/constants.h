// Numbers of mathematics and of nature.
#pragma once

namespace softsoil {

constexpr double kPi = 3.14159265358979323846;
constexpr double kDegrees = 180 / kPi;  // [deg]    in a radian
constexpr double kGravity = 9.81;       // [m/s^2]  as MuJoCo's default

}  // namespace softsoil
