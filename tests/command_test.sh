#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# command_test.sh GAUNT: the command on good and on bad input.
set -uo pipefail
gaunt=$1
work=$(mktemp -d)
trap 'chmod -R u+w "$work"; rm -rf "$work"' EXIT
cd "$work" || exit 1
failures=0

fail() { echo "FAILED: $*"; failures=$((failures + 1)); }

# rejects WORD ARGUMENT...: exit code 2, one line on stderr that has the word, nothing on stdout, no
# file left behind.
rejects() {
  local word=$1 status=0
  shift
  "$gaunt" "$@" >out.txt 2>err.txt || status=$?
  [ "$status" -eq 2 ] || fail "gaunt $*: exit code $status"
  [ "$(wc -l <err.txt)" -eq 1 ] || fail "gaunt $*: stderr is not one line: $(cat err.txt)"
  grep -q -- "$word" err.txt || fail "gaunt $*: no word of '$word': $(cat err.txt)"
  [ ! -s out.txt ] || fail "gaunt $*: wrote to stdout"
  [ -z "$(find . -name '*.png' -o -name '*part*' -o -name '.gaunt*')" ] || fail "gaunt $*: left files"
}

small=(--grid 4 3 4 --rays 32 --bounces 1 --objects 70 --frames 3)

rejects subcommand
rejects subcommand nonsense
rejects objects frame --objects 0
rejects objects frame --objects -5
rejects objects frame --objects 99999999999
rejects frames frame --frames 0
rejects grid frame --grid 0 8 16
rejects grid frame --grid 16 8
rejects "too large" frame --grid 1024 1024 1024
rejects rays frame --rays 1
rejects scene frame --scene moon
rejects target frame --target MMX
rejects missing.exr frame --env missing.exr
printf 'not an image' >broken.exr
rejects broken.exr frame --env broken.exr
printf '#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 64 +X 128\n' >truncated.hdr
rejects truncated.hdr frame --env truncated.hdr
: >empty.hdr
rejects empty.hdr frame --env empty.hdr
printf 'a file' >taken
rejects taken frame --out taken "${small[@]}"
if [ "$(id -u)" -ne 0 ]; then
  mkdir locked && chmod a-w locked
  rejects locked frame --out locked/out "${small[@]}"
  rejects locked points --repulsion 3 --out locked/points
fi
rejects "--repulsion or --design" points
rejects "not in range" points --repulsion 0
rejects "not in range" points --repulsion 201
rejects six points --repulsion six
rejects "not in range" points --design 33
rejects "take 5" points --design 4
rejects excludes points --design 5 --repulsion 6
rejects excludes points --repulsion 6 --csv --json
rejects excludes points --repulsion 6 --csv --header kSet
rejects a::9 points --repulsion 6 --header a::9
rejects twice points --repulsion 6,3,6
rejects nowhere points --repulsion 6 --out nowhere/points
mkdir folder
rejects folder points --repulsion 6 --out folder

for scene in courtyard room street; do
  "$gaunt" frame --scene "$scene" "${small[@]}" --out "pictures/$scene" >out.txt 2>err.txt ||
    fail "scene $scene: $(cat err.txt)"
  grep -qE '^70 objects: [0-9.e-]+ ms per frame \([0-9.]+ ns per object\)' out.txt ||
    fail "scene $scene: no summary"
  [ ! -s err.txt ] || fail "scene $scene: stderr: $(cat err.txt)"
  for picture in frame probes; do
    [ "$(head -c 4 "pictures/$scene/$picture.png" | tail -c 3)" = PNG ] ||
      fail "scene $scene: no $picture.png"
  done
done

# Pictures depend neither on the run nor on the number of cores.
"$gaunt" frame "${small[@]}" --json --out again >json.txt || fail "json"
grep -q '"ns_per_object"' json.txt || fail "no ns_per_object in JSON"
cmp -s again/frame.png pictures/courtyard/frame.png || fail "pictures differ between runs"
taskset -c 0 "$gaunt" frame "${small[@]}" --out one_core >/dev/null || fail "one core"
cmp -s one_core/frame.png pictures/courtyard/frame.png || fail "pictures depend on the cores"

# Links are followed, other files of the user stay, and what is no file is written itself.
echo old >real.txt && ln -s real.txt link.txt && echo mine >link.txt.part && mkfifo pipe
"$gaunt" points --repulsion 2 --csv --out link.txt >out.txt || fail "points to a link"
[ -L link.txt ] && grep -q '^2,' real.txt || fail "a link was replaced"
[ "$(cat link.txt.part)" = mine ] || fail "a file of the user was lost"
cat pipe >piped.txt &
"$gaunt" points --repulsion 2 --csv --out pipe >out.txt || fail "points to a pipe"
wait
[ -p pipe ] && cmp -s piped.txt real.txt || fail "a pipe was replaced"
rm link.txt.part

"$gaunt" opcount --csv >csv.txt || fail "opcount"
[ "$(head -1 csv.txt)" = op,order,variant,mul,fma,add,ports ] || fail "header of opcount"
awk -F, 'NR > 1 && ($4 + $5 + $6 != $7 || NF != 7) { exit 1 }' csv.txt || fail "sums of opcount"
[ "$(wc -l <csv.txt)" -gt 50 ] || fail "opcount has few rows"
"$gaunt" opcount --json >json.txt && grep -q '"op": "basis"' json.txt || fail "opcount --json"

# Points, in each form.
"$gaunt" points --repulsion 1,22 >out.txt || fail "points"
grep -q '^22 points: energy 185.287536149, covering radius 28' out.txt || fail "energy of points"
[ "$(wc -l <out.txt)" -eq 25 ] || fail "number of points"
"$gaunt" points --design 5 --csv --out csv.txt >out.txt || fail "points --csv"
grep -q '^strength 5, 12 points: residual' out.txt || fail "summary of points --out"
awk -F, 'NR > 1 && (($2 ^ 2 + $3 ^ 2 + $4 ^ 2 - 1) ^ 2 > 1e-28 || $1 != 5) { exit 1 }' csv.txt ||
  fail "lengths of points"
[ "$(wc -l <csv.txt)" -eq 13 ] || fail "rows of points"
"$gaunt" points --design 5 --json | grep -q '"strength": 5' || fail "points --json"
"$gaunt" points --repulsion 6 --header a::b::kFewPoints >header.txt || fail "points --header"
[ "$(head -1 header.txt)" = "// Made by: gaunt points --repulsion 6 --header a::b::kFewPoints" ] ||
  fail "first line of points --header"
for word in '#ifndef A_B_FEW_POINTS_H_' 'namespace a::b {' 'kFewPoints6\[6\]\[3\] = {'; do
  grep -q "$word" header.txt || fail "points --header: no $word"
done

"$gaunt" info | grep -q '^target ' || fail "info"
"$gaunt" info --json | grep -q '"targets"' || fail "info --json"
GAUNT_TARGET=nonsense "$gaunt" info | grep -q 'nonsense is unknown' || fail "unknown GAUNT_TARGET"
for command in "" info opcount frame points; do
  "$gaunt" $command --help | grep -q -- --help || fail "help of '$command'"
done

[ "$failures" -eq 0 ] && echo "all good"
exit "$((failures != 0))"
