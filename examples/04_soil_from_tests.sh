#!/usr/bin/env bash
# A soil from a report: composition, density, plate-sinkage and shear tests; then the rover on it. The warnings are
# due: with 10 % clay this soil lies beside those that the relations were made from.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source tests/setup.sh

use_softsoil
softsoil soil --clay 10 --silt 25 --sand 65 --bulk-density 1400 \
  --plate examples/data/plate_sinkage.csv --shear examples/data/shear_test.csv \
  --like upland_sandy_loam --name field_loam --out build/04_soil/field_loam.xml --force
softsoil run examples/01_rover.xml --time 3 --controls examples/01_rover_controls.csv \
  --set soil_file=build/04_soil/field_loam.xml --set soil=field_loam --out build/04_soil/rover
