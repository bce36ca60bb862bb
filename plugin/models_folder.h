// Where the catalogues of soils and tires lie.
#pragma once

#include <string>

namespace softsoil {

// File of the library, or of the program if the library is linked into it statically. Asked for
// once when the library is loaded: a relative path is lost when the host changes its folder.
const std::string& LibraryFile();

// <folder of the library>/../share/softsoil/models: the same in a build and in an installation.
std::string ModelsFolder();

}  // namespace softsoil
