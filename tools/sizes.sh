#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# sizes.sh LIBRARY [FAMILY LIMIT]: prints KB of machine code by family and SIMD target of a static
# library. With a family and a limit in KB, fails if a target that is not emulated has more of it.
set -euo pipefail
[ $# -eq 1 ] || [ $# -eq 3 ] || { sed -n '3,4s/^# \{0,1\}//p' "$0" >&2; exit 2; }
[ -f "$1" ] || { echo "sizes.sh: cannot read $1" >&2; exit 2; }

nm --print-size --defined-only --demangle --radix=d "$1" 2>/dev/null | awk -v checked="${2:-}" -v limit="${3:-0}" '
  # Address, size, kind of symbol, name: of templates, the family is in an argument.
  $3 ~ /^[tTwW]$/ && match($0, /gaunt::[a-z]+::([a-z]+::)*N_[A-Z0-9_]+::/) {
    split(substr($0, RSTART, RLENGTH), part, "::")
    family = part[2]
    match($0, /::N_[A-Z0-9_]+::/)
    target = substr($0, RSTART + 4, RLENGTH - 6)
    size[family, target] += $2
    families[family]
    targets[target]
  }
  END {
    order = "sort -k1,1 -k2,2"
    for (key in size) {
      split(key, part, SUBSEP)
      printf "%-10s %-8s %6.0f\n", part[1], part[2], size[key] / 1024 | order
    }
    close(order)
    if (checked == "") exit 0
    if (!(checked in families)) { print "sizes.sh: no family " checked > "/dev/stderr"; exit 1 }
    for (target in targets) {
      if (target == "EMU128" || size[checked, target] <= limit * 1024) continue
      printf "sizes.sh: %s on %s has more than %d KB\n", checked, target, limit > "/dev/stderr"
      bad = 1
    }
    exit bad
  }'
