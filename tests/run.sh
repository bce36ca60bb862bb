#!/usr/bin/env bash
# Installs what is missing, builds and runs every test: the release build, then the same tests under address and
# undefined behaviour sanitizers and under the thread sanitizer, then every fuzz target for a while.
# Arguments go to ctest, and then the release build alone is tested: ./tests/run.sh -R Rut
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

run_tests() {
  (cd "$repo" && ctest --preset "$1" --no-tests=error --parallel "$(nproc)" "${@:2}")
}

install_packages
build release all benchmarks
run_tests release "$@"
[[ $# -eq 0 ]] || exit 0

install_packages "${sanitizer_packages[@]}"
for preset in asan tsan fuzz; do
  echo "Preset $preset"
  build "$preset"
  run_tests "$preset"
done
