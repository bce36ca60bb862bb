#!/usr/bin/env bash
# A wheel under 27 kN drives itself back and forth over the same ground, six passes in its own rut: the wheel sinks deeper by
# less than in the one before, and meets less resistance. Madsen (2014) 7.1. Results and picture in build/07_five_passes.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source tests/setup.sh
use_softsoil

out=build/07_five_passes
softsoil drawbar --tire 18.4R38_85kPa --soil slipping_loam --soil-file examples/07_five_passes/slipping_loam.xml \
  --load 27000 --mode spin --spin 3 --set grid_spacing=0.05 --no-picture --out "$out/bin"   # makes the rig
softsoil run "$out/bin/soil_bin.xml" --time 25 --controls examples/07_five_passes/controls.csv --out "$out"
PYTHONDONTWRITEBYTECODE=1 PYTHONPATH=examples /usr/bin/python3 examples/07_five_passes/passes.py "$out"
