#!/usr/bin/env bash
# A wheel goes back and forth over the same ground: each pass deepens the rut by less than the one before, and meets
# less resistance. Madsen (2014) 7.1. Results and picture in build/07_five_passes.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source tests/setup.sh
use_softsoil

softsoil run soil_bin --time 21 --controls examples/07_five_passes/controls.csv --set soil=slipping_loam \
  --set soil_file=examples/07_five_passes/slipping_loam.xml --set grid_spacing=0.05 \
  --out build/07_five_passes
PYTHONDONTWRITEBYTECODE=1 PYTHONPATH=examples /usr/bin/python3 examples/07_five_passes/passes.py build/07_five_passes
