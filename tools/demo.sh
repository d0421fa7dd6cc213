#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# demo.sh [--real]: builds gaunt and lights 2000 objects of a small scene from packed probes, under an
# embedded sky; with --real also under a panorama of Debian's blender-data (CC0). Installs what is missing
# with apt. Three minutes on two cores where everything has to be installed.
set -euo pipefail
cd "$(dirname "$0")/.."
. tools/packages.sh

real=no
for argument in "$@"; do
  case "$argument" in
    --real) real=yes ;;
    -h|--help) sed -n '3,5s/^# //p' "$0"; exit 0 ;;
    *) echo "demo.sh: unknown option $argument; see --help" >&2; exit 2 ;;
  esac
done

tools/install_packages.sh $packages_build
cmake --preset release >/dev/null
cmake --build --preset release --target gaunt_command

echo
build/release/gaunt frame --out out
if [ $real = yes ]; then
  tools/install_packages.sh $packages_panorama
  panorama=/usr/share/blender/datafiles/studiolights/world/sunrise.exr
  echo
  echo "the same under $panorama:"
  build/release/gaunt frame --env "$panorama" --out out/real
fi
