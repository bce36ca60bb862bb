#!/usr/bin/env bash
# A HMMWV climbs and descends until its wheels hold no more: on soft soil, firm soil and rigid ground. Tilled loam holds
# up to 25 degrees uphill and 30 downhill, where its resistance helps; the others 32 to 34. Results in build/12_slopes.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source tests/setup.sh
use_softsoil

out=build/12_slopes
cmake --install "$SOFTSOIL_BUILD" --prefix "$out/prefix" >/dev/null
cmake -S examples/12_slopes -B "$out" -DCMAKE_BUILD_TYPE=Release -DCMAKE_PREFIX_PATH="$PWD/$out/prefix"
cmake --build "$out"
for ground in tilled_yolo_loam firm_yolo_loam rigid_ground; do
  settings="soil=$ground soil_file=examples/09_handling/rigid_ground.xml grid_spacing=0.05"
  for way in up down; do
    "$out/slopes" models/scenes/hmmwv_flat.xml "$settings" "$way" "$out/$ground.$way.csv"
  done
done
PYTHONDONTWRITEBYTECODE=1 PYTHONPATH=examples /usr/bin/python3 examples/12_slopes/slopes.py "$out"
