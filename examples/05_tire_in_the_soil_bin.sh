#!/usr/bin/env bash
# From a tire's data sheet to its drawbar pull: springs are fitted to load-deflection tests at 85 and 125 kPa, and
# the tire is driven at 100 kPa through tilled loam. Results in build/05_tire_in_the_soil_bin.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source tests/setup.sh
use_softsoil

out=build/05_tire_in_the_soil_bin
mkdir -p "$out"
softsoil fit-tire examples/data/18.4R38_load_deflection.csv --radius 0.91 --width 0.467 \
  --contact-width examples/data/18.4R38_contact_width.csv --name my_tire --load 18000 --like 18.4R38_85kPa \
  --out "$out/my_tire.xml" --force
softsoil drawbar --tire my_tire@100kPa --tire-file "$out/my_tire.xml" --soil tilled_yolo_loam --load 18000 \
  --slip 0.05,0.1,0.2,0.4 --set grid_spacing=0.05 --wong-reece --out "$out/bin"
