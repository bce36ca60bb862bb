// A single wheel that may rise and fall, roll and spin: the smallest vehicle.
#pragma once

#include <string>

#include "tests/plugin/mjcf.h"

namespace softsoil {

constexpr double kOneWheelWeight = 200 * 9.81;  // [N]

struct OneWheel {
  std::string timestep = "0.001";
  std::string option;  // attributes of it
  std::string custom = R"(<text name="softsoil_soil" data="tilled_yolo_loam"/>
                          <numeric name="softsoil_sync" data="1"/>)";
  std::string plane = R"(contype="2" conaffinity="0")";
  std::string wheel_geom = R"(type="cylinder" zaxis="0 1 0" size=".4 .1")";
  std::string others;  // beside worldbody

  std::string Mjcf() const {
    return "<mujoco model=\"one_wheel\"><option timestep=\"" + timestep + "\" " + option +
           "/><custom>" + custom + "</custom>" + others + R"(
      <worldbody>
        <geom name="field" type="plane" size="9 9 1" )" +
           plane + R"(/>
        <body name="hub" pos="0 0 .4">
          <inertial pos="0 0 0" mass="190" diaginertia="5 5 5"/>
          <joint type="slide" axis="1 0 0"/>
          <joint type="slide" axis="0 0 1" damping="3000"/>
          <body name="wheel">
            <joint name="spin" axis="0 1 0"/>
            <geom name="tread" mass="10" )" +
           wheel_geom + R"(/>
          </body>
        </body>
      </worldbody></mujoco>)";
  }
};

}  // namespace softsoil
