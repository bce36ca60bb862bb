// Where the installed parts are, found from the place of the program: an installation may be moved.
#pragma once

#include <string>
#include <vector>

namespace softsoil {

// <folder of the program>/../share/softsoil and .../lib/libsoftsoil.so. The latter throws if
// there is none.
std::string ShareFolder();
std::string SoftsoilLibrary();

// A scene as the user names it: the path of an MJCF file, or the name of a shipped scene. Throws
// InputError that lists the shipped scenes.
std::string SceneFile(const std::string& scene);

// A shipped scene. The description is the first sentence of the first comment in its file, or the
// name of its model.
struct Scene {
  std::string name, description, file;
};
std::vector<Scene> ShippedScenes();

}  // namespace softsoil
