// A small model with a free joint and a hinge.
#pragma once

#include <string>

#include "tests/plugin/mjcf.h"

namespace softsoil {

// A body that flies, with a wheel on it.
inline Model Flyer(const std::string& option) {
  return Load(World(R"(<body><freejoint/><geom size=".1"/>
                         <body><joint axis="0 1 0"/><geom size=".1" pos=".3 0 0"/></body>
                       </body>)",
                    "<option " + option + "/>"));
}

}  // namespace softsoil
