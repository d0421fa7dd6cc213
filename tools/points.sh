#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# points.sh: makes the committed sets of points anew, each by the command in its first line. Seconds, once
# gaunt is built.
set -euo pipefail
cd "$(dirname "$0")/.."
. tools/packages.sh

case "${1-}" in
  "") ;;
  -h|--help) sed -n '3,4s/^# //p' "$0"; exit 0 ;;
  *) echo "points.sh: unknown option $1; see --help" >&2; exit 2 ;;
esac

tools/install_packages.sh $packages_build
cmake --preset release >/dev/null
cmake --build --preset release --target gaunt_command

# make FILE ARGUMENT...
make() {
  local file=$1
  shift
  build/release/gaunt points "$@" --out "$file"
  sed -i '1a // SPDX-License-Identifier: MIT\n// clang-format off' "$file"
}
make src/light/search_points.h --repulsion 1,3,6,10,15,22 --header gaunt::light::kSearchPoints
make tests/support/design_points.h --design 5,9,11,15,21 --header gaunt::test::kDesignPoints
