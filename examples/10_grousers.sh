#!/usr/bin/env bash
# A rigid rover wheel with grousers beside the same wheel without, each a triangle mesh, on a planetary soil simulant: pull
# against slip. Results and picture in build/10_grousers.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source tests/setup.sh
use_softsoil

out=build/10_grousers
export PYTHONDONTWRITEBYTECODE=1 PYTHONPATH=examples
mkdir -p "$out"
cp examples/10_grousers/wheels.xml "$out/"
/usr/bin/python3 examples/grouser_wheel.py 0.15735 0.165 > "$out/smooth.obj"
/usr/bin/python3 examples/grouser_wheel.py 0.15735 0.165 --grousers 30 --height 0.01 > "$out/grousers.obj"
for wheel in smooth_wheel grouser_wheel; do
  softsoil drawbar --tire "$wheel" --tire-file "$out/wheels.xml" --soil ding2011_simulant --load 80 --speed 0.1 \
    --slip 0.11,0.25,0.67,1.5 --set grid_spacing=0.01 --set volume_height=0.01 --set volumes=20 --no-picture \
    --out "$out/$wheel"
done
/usr/bin/python3 examples/10_grousers/grousers.py "$out"
