#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# arm_root.sh DIRECTORY: unpacks Debian's arm64 packages of Highway and GoogleTest there, for the cross
# build. Nothing is installed, and the system's architectures stay as they are.
set -euo pipefail

root=$(mkdir -p "$1" && cd "$1" && pwd)
[ -e "$root/done" ] && exit 0
echo "fetching arm64 packages into $1"
apt=(-o APT::Architecture=arm64 -o APT::Architectures=arm64 -o Dir::State::lists="$root/lists"
     -o Dir::Cache="$root/cache" -o Debug::NoLocking=1)
mkdir -p "$root/lists/partial" "$root/cache/archives/partial" "$root/packages"
apt-get "${apt[@]}" update >"$root/log" 2>&1
(cd "$root/packages" &&
  apt-get "${apt[@]}" download libhwy1 libhwy-dev libgtest-dev libstdc++6 libgcc-s1 \
    >>"$root/log" 2>&1)
for package in "$root"/packages/*.deb; do dpkg -x "$package" "$root"; done
touch "$root/done"
