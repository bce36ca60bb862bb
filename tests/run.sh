#!/usr/bin/env bash
# Installs what is missing, builds and runs every test. Arguments go to ctest: ./tests/run.sh -R Rut
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

install_packages
build release all benchmarks
exec ctest --test-dir "$build" --output-on-failure --no-tests=error --parallel "$(nproc)" "$@"
