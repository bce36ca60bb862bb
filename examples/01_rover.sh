#!/usr/bin/env bash
# A rover of one's own on sand: the model names its soil, and that is enough.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source tests/setup.sh

use_softsoil
softsoil run examples/01_rover.xml --time 4 --controls examples/01_rover_controls.csv \
  --out build/01_rover
