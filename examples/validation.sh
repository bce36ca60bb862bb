#!/usr/bin/env bash
# Reruns every experiment, Wong-Reece case, tire fit and soil volume that the thesis prints and writes
# build/validation/table.md, measured against computed, with pictures. About five minutes.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source tests/setup.sh
use_softsoil softsoil_validation
# Debian installs matplotlib for this Python; the first in PATH may be another.
PYTHONDONTWRITEBYTECODE=1 /usr/bin/python3 examples/validation/run.py build/validation
