#include "plugin/mujoco_symbols.h"

#include <dlfcn.h>
#include <link.h>

#include <string>
#include <vector>

namespace softsoil {
namespace {

template <class Symbol>
void Find(void* library, const char* name, Symbol* symbol) {
  *symbol = reinterpret_cast<Symbol>(dlsym(library, name));
}

MujocoSymbols SymbolsOf(void* library) {
  MujocoSymbols symbols;
  int (*version)() = nullptr;
  Find(library, "mj_version", &version);
  if (version == nullptr) return symbols;
  symbols.version = version();
  Find(library, "mjcb_passive", &symbols.passive);
  Find(library, "mjcb_contactfilter", &symbols.contact_filter);
  Find(library, "mju_user_error", &symbols.user_error);
  Find(library, "mju_user_malloc", &symbols.user_malloc);
  Find(library, "mju_user_free", &symbols.user_free);
  return symbols;
}

std::vector<std::string> LoadedMujocoLibraries() {
  std::vector<std::string> paths;
  dl_iterate_phdr(
      [](dl_phdr_info* info, size_t, void* found) {
        const std::string path = info->dlpi_name;
        const std::string file = path.substr(path.rfind('/') + 1);
        if (file.rfind("libmujoco", 0) == 0) {
          static_cast<std::vector<std::string>*>(found)->push_back(path);
        }
        return 0;
      },
      &paths);
  return paths;
}

}  // namespace

MujocoSymbols FindMujoco() {
  MujocoSymbols symbols = SymbolsOf(RTLD_DEFAULT);
  if (symbols.version != 0) return symbols;
  for (const std::string& path : LoadedMujocoLibraries()) {
    void* library = dlopen(path.c_str(), RTLD_LAZY | RTLD_NOLOAD);
    if (library == nullptr) continue;
    symbols = SymbolsOf(library);
    dlclose(library);  // its owner keeps it loaded
    if (symbols.version != 0) return symbols;
  }
  return symbols;
}

}  // namespace softsoil
