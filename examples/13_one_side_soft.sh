#!/usr/bin/env bash
# A HMMWV drives with its left wheels on firm, its right wheels on soft soil, and nobody steers: it is pulled to the soft
# side, and when it brakes hard to the firm one, which holds more. On firm soil alone it goes straight. Results in
# build/13_one_side_soft.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source tests/setup.sh
use_softsoil

example=examples/13_one_side_soft out=build/13_one_side_soft
softsoil run $example/scene.xml --time 10 --controls $example/controls.csv --no-picture --out $out/one_side_soft
softsoil run $example/scene.xml --time 10 --controls $example/controls.csv --no-picture --out $out/firm \
  --set regions=none
PYTHONDONTWRITEBYTECODE=1 PYTHONPATH=examples /usr/bin/python3 $example/one_side_soft.py $out
