#!/usr/bin/env bash
# From a fresh Debian 12 to a rut: installs, builds, drives a HMMWV over loam for ten seconds.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source tests/setup.sh

use_softsoil
softsoil run hmmwv_flat --time 10 --controls examples/quickstart_controls.csv --out build/quickstart

echo
for picture in "$repo"/build/quickstart/*.png; do
  [[ -f $picture ]] || { echo "quickstart: softsoil run drew no picture" >&2; exit 1; }
  echo "Picture: $picture"
done
