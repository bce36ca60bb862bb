#!/usr/bin/env bash
# Installs the build and uses the installation as a stranger would: from CMake in a C program, and
# as the program softsoil. Usage: SOFTSOIL_BUILD=<build folder> find_package_test.sh <version>
set -euo pipefail

examples=$(cd "$(dirname "${BASH_SOURCE[0]}")/../../examples" && pwd)
version=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

fail() { echo "find_package_test: $*" >&2; exit 1; }

cmake --install "$SOFTSOIL_BUILD" --prefix "$work/original" >/dev/null
mv "$work/original" "$work/prefix"  # an installation may be moved

cmake -S "$examples/03_c_program" -B "$work/build" -DCMAKE_PREFIX_PATH="$work/prefix" >/dev/null
cmake --build "$work/build" >/dev/null
got=$("$work/build/c_program" "$examples/01_rover.xml")
[[ $got == "softsoil $version"* ]] || fail "softsoil_version() must be $version, got $got"
[[ $got == *"rear_right   load "* ]] || fail "the program must tell of its wheels, got $got"

library=$(ldd "$work/prefix/bin/softsoil" | awk '$1 == "libsoftsoil.so" { print $3 }')
[[ $(realpath "$library") == "$work/prefix/lib/libsoftsoil.so" ]] ||
  fail "the installed program must load the installed library, got $library"
for data in models plot; do
  [[ -d $work/prefix/share/softsoil/$data ]] || fail "share/softsoil/$data is not installed"
done
