#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# table.sh RESULTS.json: prints the README's table of speeds from a file that gaunt_bench wrote.
set -euo pipefail
[ $# -eq 1 ] || { sed -n '3s/^# //p' "$0" >&2; exit 2; }

awk -F'"' '
  /"compiler"/ { compiler = $4 }
  /"run_name"/ { run = $4 }
  /"aggregate_name"/ { median = $4 == "median" }
  /"ns_item"/ && median { split($3, cell, "[:,]"); ns[run] = cell[2] }
  function row(text, name, scalar) {
    if (!((name "/AVX3") in ns && (name "/AVX2") in ns && scalar in ns)) {
      print "table.sh: no rows of " name " or " scalar >"/dev/stderr"
      exit 1
    }
    printf "| %s | %.2f | %.2f | %.1f |\n", text, ns[name "/AVX3"], ns[name "/AVX2"], ns[scalar]
  }
  END {
    print "| ns per item or texel, " compiler " | AVX-512 | AVX2 | scalar, as engines have it |"
    print "|---|---|---|---|"
    for (n = 3; n <= 6; n += 3) {
      engine = "basis/eval/n" n "/interleaved/1024/engine"
      row("basis, order " n ", tiled", "basis/eval/n" n "/tiled/1024", engine)
      row("basis, order " n ", interleaved", "basis/eval/n" n "/interleaved/1024", engine)
    }
    for (n = 3; n <= 6; n += 3) {
      each = "rotate/quaternion_mono/n" n
      row("rotation by a quaternion each, order " n, each "/tiled/1024",
          each "/interleaved/1024/zxzxz")
    }
    for (n = 3; n <= 6; n += 3) {
      product = "product/product_mono/n" n
      row("product, order " n, product "/tiled/1024", product "/interleaved/1024/pairs")
    }
    for (n = 3; n <= 6; n += 3) {
      one = "rotate/one_mono/n" n
      row("rotation of all by one, order " n, one "/tiled/1024", one "/interleaved/1024/blocks")
    }
    probe = "evaluate/irradiance_one_probe/n3/"
    row("E/π, RGB, one probe at many normals, tiled", probe "tiled/1024",
        probe "interleaved/1024/engine")
    cube = "project/cubemap/n3/rgba32f/64"
    row("cubemap 6 × 64², RGBA32F, order 3", cube, cube "/scalar")
    panorama = "project/equirect/n3/rgb32f/1024x512"
    row("panorama 1024 × 512, RGB32F, order 3", panorama, panorama "/scalar")
  }' "$1"
