#!/usr/bin/env bash
# Ten HMMWVs drive one after the other in the same rut, on loam that gives way to slip: the second meets an eighth of
# the resistance of the first, the tenth next to none, and each deepens the rut a little. Results in build/11_convoy.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source tests/setup.sh
use_softsoil

out=build/11_convoy
cmake --install "$SOFTSOIL_BUILD" --prefix "$out/prefix" >/dev/null
cmake -S examples/11_convoy -B "$out" -DCMAKE_BUILD_TYPE=Release -DCMAKE_PREFIX_PATH="$PWD/$out/prefix"
cmake --build "$out"
"$out/convoy" models/scenes/hmmwv_flat.xml \
  "soil=slipping_loam soil_file=examples/07_five_passes/slipping_loam.xml grid_spacing=0.05" 10 "$out"
PYTHONDONTWRITEBYTECODE=1 PYTHONPATH=examples /usr/bin/python3 examples/11_convoy/convoy.py "$out"
