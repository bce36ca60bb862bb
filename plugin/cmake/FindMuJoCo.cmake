# Finds MuJoCo 2.2.2, that version exactly: the layout of mjModel and mjData changes with each release.
#   MuJoCo::headers  the headers alone, for code that looks its symbols up at run time
#   MuJoCo::MuJoCo   the headers and libmujoco
# Set MuJoCo_INCLUDE_DIR and MuJoCo_LIBRARY, or CMAKE_PREFIX_PATH, to use a copy of your own.
find_path(MuJoCo_INCLUDE_DIR mujoco/mujoco.h)
find_library(MuJoCo_LIBRARY mujoco)
mark_as_advanced(MuJoCo_INCLUDE_DIR MuJoCo_LIBRARY)

if(MuJoCo_INCLUDE_DIR)
  file(STRINGS ${MuJoCo_INCLUDE_DIR}/mujoco/mujoco.h version_line REGEX "#define mjVERSION_HEADER")
  string(REGEX MATCH "[0-9]+" MuJoCo_VERSION_HEADER "${version_line}")
  if(NOT MuJoCo_VERSION_HEADER STREQUAL "222")
    message(FATAL_ERROR "${MuJoCo_INCLUDE_DIR}/mujoco/mujoco.h: mjVERSION_HEADER must be 222 "
                        "(MuJoCo 2.2.2), got ${MuJoCo_VERSION_HEADER}")
  endif()
endif()

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(MuJoCo REQUIRED_VARS MuJoCo_LIBRARY MuJoCo_INCLUDE_DIR)

if(MuJoCo_FOUND AND NOT TARGET MuJoCo::MuJoCo)
  add_library(MuJoCo::headers INTERFACE IMPORTED)
  target_include_directories(MuJoCo::headers INTERFACE ${MuJoCo_INCLUDE_DIR})
  add_library(MuJoCo::MuJoCo UNKNOWN IMPORTED)
  set_target_properties(MuJoCo::MuJoCo PROPERTIES IMPORTED_LOCATION ${MuJoCo_LIBRARY})
  target_link_libraries(MuJoCo::MuJoCo INTERFACE MuJoCo::headers)
endif()
