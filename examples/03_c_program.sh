#!/usr/bin/env bash
# A C program that links softsoil: installs a copy into build/prefix, builds against it, runs.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source tests/setup.sh

use_softsoil
cmake --install "$SOFTSOIL_BUILD" --prefix build/prefix >/dev/null
cmake -S examples/03_c_program -B build/03_c_program -DCMAKE_PREFIX_PATH="$PWD/build/prefix"
cmake --build build/03_c_program
build/03_c_program/c_program examples/01_rover.xml
