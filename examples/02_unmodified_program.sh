#!/usr/bin/env bash
# Soft soil in a program that knows nothing of it: MuJoCo's own speed test, two threads.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source tests/setup.sh

use_softsoil
softsoil with -- mujoco-testspeed examples/01_rover.xml 1000 2 </dev/null
