#!/usr/bin/env bash
# Installs what is missing, builds and runs every test. Arguments go to ctest: ./tests/run.sh -R Rut
#   ./tests/run.sh --sanitizers   the same tests under address and undefined behaviour sanitizers and under the thread
#                                 sanitizer, and every fuzz target for a while, instead
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

run_tests() {
  (cd "$repo" && ctest --preset "$1" --no-tests=error --parallel "$(nproc)" "${@:2}")
}

install_packages
if [[ ${1:-} != --sanitizers ]]; then
  build release all benchmarks
  run_tests release "$@"
  exit
fi

install_packages "${sanitizer_packages[@]}"
for preset in asan tsan fuzz; do
  echo "Preset $preset"
  build "$preset"
  run_tests "$preset" "${@:2}"
done
