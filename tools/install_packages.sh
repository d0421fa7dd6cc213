#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# install_packages.sh PACKAGE...: installs those that are missing with apt, after saying so. On systems
# without apt it says what is needed and goes on.
set -euo pipefail

missing=()
for package in "$@"; do
  if ! dpkg-query -W -f='${Status}' "$package" 2>/dev/null | grep -q 'install ok installed'; then
    missing+=("$package")
  fi
done
[ ${#missing[@]} -eq 0 ] && exit 0

if ! command -v apt-get >/dev/null; then
  echo "gaunt needs these packages of Debian, or what they are called here: $*" >&2
  exit 0
fi
echo "installing with apt: ${missing[*]}"
as_root=()
if [ "$(id -u)" -ne 0 ]; then as_root=(sudo); fi
quiet=$(mktemp)
if ! { "${as_root[@]}" apt-get update &&
       "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends \
         "${missing[@]}"; } >"$quiet" 2>&1; then
  cat "$quiet" >&2
  rm -f "$quiet"
  exit 1
fi
rm -f "$quiet"
