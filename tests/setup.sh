# Sourced by tests/run.sh and the examples; sets nothing up by itself. Gives
#   install_packages [PACKAGE]...  what softsoil needs from Debian 12 and these packages, only what is missing
#   build PRESET [TARGET]...       configures once, builds what changed; the build folder is then in $build
#   use_softsoil [TARGET]...       the program softsoil in PATH: the build that ctest gives, or a release build of its own
#                                  with more targets besides

repo=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

packages=(
  build-essential cmake ninja-build
  libmujoco-dev libmujoco-samples libeigen3-dev libboost-dev libtinyxml2-dev libcli11-dev
  nlohmann-json3-dev
  libgtest-dev libgmock-dev libbenchmark-dev
  python3 python3-numpy python3-matplotlib
  xvfb xauth libegl1 libgl1-mesa-dri libosmesa6
)
sanitizer_packages=(clang libclang-rt-dev llvm)  # for the presets asan, tsan and fuzz

missing_packages() {
  local package
  for package in "$@"; do
    dpkg-query --show --showformat='${db:Status-Status}\n' "$package" 2>/dev/null |
      grep -qx installed || echo "$package"
  done
}

install_packages() {
  if ! command -v dpkg-query >/dev/null; then
    echo "softsoil: not a Debian system; install the counterparts of: ${packages[*]} $*" >&2
    exit 1
  fi
  local missing as_root=()
  mapfile -t missing < <(missing_packages "${packages[@]}" "$@")
  [[ ${#missing[@]} -gt 0 ]] || return 0
  if [[ $(id -u) -ne 0 ]]; then
    if ! command -v sudo >/dev/null; then
      echo "softsoil: these packages are missing and only root can install them: ${missing[*]}" >&2
      exit 1
    fi
    as_root=(sudo)
  fi
  echo "Installing: ${missing[*]}"
  "${as_root[@]}" apt-get update -qq </dev/null
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
    apt-get install -y -qq --no-install-recommends "${missing[@]}" </dev/null
}

build() {
  local preset=$1 targets=("${@:2}")
  build=$repo/build/$preset
  # A changed CMakeLists.txt is seen by ninja itself, changed presets are not.
  if [[ ! $build/build.ninja -nt $repo/CMakePresets.json ]]; then
    (cd "$repo" && cmake --preset "$preset")
  fi
  cmake --build "$build" ${targets:+--target "${targets[@]}"}
}

use_softsoil() {
  if [[ -z ${SOFTSOIL_BUILD:-} ]]; then
    install_packages
    build release softsoil_cli "$@"
    export SOFTSOIL_BUILD=$build
  fi
  export PATH=$SOFTSOIL_BUILD/bin:$PATH
}
