#!/usr/bin/env bash
# A HMMWV accelerates and brakes, steers by a step, and changes lanes twice: on soft soil, on firm soil and on rigid
# ground, with the same controls. Madsen (2014) 7.3. Results and picture in build/09_handling.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source tests/setup.sh
use_softsoil

out=build/09_handling
for manoeuvre in straight step_steer lane_change; do
  for ground in tilled_yolo_loam firm_yolo_loam rigid_ground; do
    softsoil run hmmwv_flat --time 10 --controls "examples/09_handling/$manoeuvre.csv" \
      --set "soil=$ground" --set soil_file=examples/09_handling/rigid_ground.xml --set grid_spacing=0.05 \
      --no-picture --out "$out/$manoeuvre/$ground"
  done
done
PYTHONDONTWRITEBYTECODE=1 PYTHONPATH=examples /usr/bin/python3 examples/09_handling/handling.py "$out"
