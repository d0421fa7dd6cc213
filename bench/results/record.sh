#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# record.sh GAUNT_BENCH FILE.json: runs the benchmarks whose results are kept, some 12 minutes, and
# writes medians and coefficients of variation. Needs python3.
set -euo pipefail
[ $# -eq 2 ] || { sed -n '3,4s/^# //p' "$0" >&2; exit 2; }

tiled='tiled/(1000|1024|1048576)'
rows="basis/.*/(tiled|interleaved)/(1000|1024|1048576)/"
rows+="|evaluate/irradiance.*/(tiled|interleaved)/(1000|1024)/"
rows+="|(rotate|zonal)/.*/($tiled|interleaved/1024)/|project/|frame/[0-9]+_objects_[0-9]+_probes(_anywhere)?/"
rows+="|product/.*/(tiled|interleaved)/1024/|product/product_mono/n[36]/"
rows+="|probe/gather8_.*/tiled/1024/|probe/decode_.*/(tiled|planar)/(1024|1048576)/"
rows+="|(zh3|grid|tetra|ambient_cube)/.*/(tiled|interleaved)/1024/"
methods='AVX2|AVX3|by_steps|factored|engine|scalar|zxzxz|blocks|table|pairs|matrix|sparse'
methods+='|A|A2|A_clang_native|A2_clang_native'
others='probe/decode_.*/(1024|1048576)/memcpy'
others+='|frame/2000_objects_(2048|1000000)_probes_.*/AVX[23]$'

out=$(mktemp) kept=$(mktemp)
trap 'rm -f "$out" "$kept"' EXIT
"$1" --benchmark_filter="($rows).*($methods)\$|rotate/drift|product/stability|$others" --benchmark_min_time=0.01 \
  --benchmark_repetitions=11 --benchmark_enable_random_interleaving=true \
  --benchmark_report_aggregates_only=true --benchmark_out="$out" --benchmark_out_format=json >&2
python3 - "$out" >"$kept" <<'END'
import json, sys

results = json.load(open(sys.argv[1]))
context = results["context"]
for key in ("host_name", "executable", "load_avg"):
    context.pop(key, None)
kept = []
for row in results["benchmarks"]:
    if row.get("aggregate_name") not in ("median", "cv"):
        continue
    for key in ("family_index", "per_family_instance_index", "threads", "iterations",
                "aggregate_unit", "items_per_second", "bytes_per_second"):
        row.pop(key, None)
    if row["aggregate_name"] == "cv":  # of the time alone
        row = {key: row[key] for key in ("name", "run_name", "run_type", "aggregate_name", "ns_item")
               if key in row}
    kept.append(row)
kept.sort(key=lambda row: row["name"])
print(json.dumps({"context": context, "benchmarks": kept}, indent=1))
END
cp "$kept" "$2"
