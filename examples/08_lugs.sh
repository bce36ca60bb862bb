#!/usr/bin/env bash
# A tractor tire with lugs beside the same tire without, on tilled loam: pull against slip, and the footprint. Madsen
# (2014) 7.2. Results and pictures in build/08_lugs.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source tests/setup.sh
use_softsoil

out=build/08_lugs
for tire in 18.4R38_85kPa 18.4R38_85kPa_lugged; do
  softsoil drawbar --tire "$tire" --soil tilled_yolo_loam --load 17600 --slip 0.05,0.12,0.27,0.45 \
    --set grid_spacing=0.05 --no-picture --out "$out/$tire"
done
softsoil run soil_bin --time 2 --controls examples/08_lugs/controls.csv --set tire=18.4R38_85kPa_lugged \
  --out "$out/footprint"
PYTHONDONTWRITEBYTECODE=1 PYTHONPATH=examples /usr/bin/python3 examples/08_lugs/lugs.py "$out"
