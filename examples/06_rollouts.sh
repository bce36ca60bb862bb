#!/usr/bin/env bash
# Many futures of one simulation, each on a copy of its own: a rover tries 16 ways to go and takes the best.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source tests/setup.sh

use_softsoil
cmake --install "$SOFTSOIL_BUILD" --prefix build/06_rollouts/prefix >/dev/null
cmake -S examples/06_rollouts -B build/06_rollouts -DCMAKE_BUILD_TYPE=Release \
  -DCMAKE_PREFIX_PATH="$PWD/build/06_rollouts/prefix"
cmake --build build/06_rollouts
build/06_rollouts/rollouts examples/01_rover.xml
