#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# install_test.sh BUILD SOURCE: installs the build into a temporary prefix, and builds tests/install
# against it with find_package, static and shared.
set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cmake --install "$1" --prefix "$work/prefix" >"$work/log" 2>&1 || { cat "$work/log"; exit 1; }
generator=$(sed -n 's/^CMAKE_GENERATOR:INTERNAL=//p' "$1/CMakeCache.txt")
cmake -G "$generator" -S "$2/tests/install" -B "$work/build" -DCMAKE_PREFIX_PATH="$work/prefix" >"$work/log" 2>&1 &&
  cmake --build "$work/build" >>"$work/log" 2>&1 || { cat "$work/log"; exit 1; }
for shader in gaunt.glsl gaunt.hlsl; do
  [ -s "$work/prefix/include/gaunt/$shader" ] || { echo "$shader is not installed" >&2; exit 1; }
done
"$work/build/hello_static"
LD_LIBRARY_PATH="$(dirname "$(find "$work/prefix" -name 'libgaunt.so' | head -1)")" \
  "$work/build/hello_shared"
