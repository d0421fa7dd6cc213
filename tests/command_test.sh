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

unfinished() { find . -name '.gaunt*'; }
leftovers() {
  find . -name '*.png' -o -name '*part*' -o -name '.gaunt*' -o -name '*turned*'
}

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
  [ -z "$(leftovers)" ] || fail "gaunt $*: left files"
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
rejects "no format" frame --format sh9
rejects scene frame --scene moon
rejects target frame --target MMX
rejects missing.exr frame --env missing.exr
printf 'not an image' >broken.exr
rejects broken.exr frame --env broken.exr
printf '#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 64 +X 128\n' >truncated.hdr
rejects truncated.hdr frame --env truncated.hdr
: >empty.hdr
rejects empty.hdr frame --env empty.hdr
# uniform BYTE: a panorama of 4 x 2 texels whose bytes, red, green, blue and exponent, are all the same.
uniform() {
  printf '#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 2 +X 4\n'
  printf "$1%.0s" {1..32}
}
uniform '\0' >black.hdr
uniform '\200' >grey.hdr
uniform '\377' >bright.hdr
rejects missing.hdr formats missing.hdr
rejects "black.hdr has no light" formats grey.hdr black.hdr
rejects "bright.hdr is too bright" formats bright.hdr
"$gaunt" formats grey.hdr >out.txt || fail "formats"
grep -q '^sh3_28 ' out.txt && ! grep -q 'nan\|inf' out.txt || fail "formats: $(cat out.txt)"
# 12 GiB of texels. Sanitizers do not start within such a limit.
printf '#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 32768 +X 32768\n' >huge.hdr
if (ulimit -v 4000000 && "$gaunt" info) >/dev/null 2>&1; then
  (ulimit -v 4000000 && "$gaunt" formats huge.hdr >out.txt 2>err.txt)
  [ $? -eq 1 ] && [ "$(cat err.txt)" = "gaunt: out of memory" ] ||
    fail "a panorama beyond memory: $(cat err.txt)"
fi
printf 'a file' >taken
rejects taken frame --out taken "${small[@]}"
if [ "$(id -u)" -ne 0 ]; then
  mkdir locked && chmod a-w locked
  rejects locked frame --out locked/out "${small[@]}"
  rejects locked points --repulsion 3 --out locked/points
  printf old >kept.txt && chmod a-w kept.txt
  rejects kept.txt points --repulsion 3 --out kept.txt
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

# floats NUMBER...: as bytes, little-endian.
floats() {
  local number
  for number; do
    case $number in
      0) printf '\0\0\0\0' ;;
      1) printf '\0\0\200\77' ;;
      -1) printf '\0\0\200\277' ;;
      2) printf '\0\0\0\100' ;;
      *) fail "floats: $number" ;;
    esac
  done
}
# splats COUNT: a PLY file of SH degree 1, with a byte and no normals.
splats() {
  printf 'ply\nformat binary_little_endian 1.0\nelement vertex %d\nproperty uchar tag\n' "$1"
  printf 'property float %s\n' x y z f_dc_{0..2} f_rest_{0..8} scale_{0..2} rot_{0..3}
  printf 'end_header\n'
  local i
  for ((i = 0; i < $1; ++i)); do
    printf T
    floats 1 2 0  2 2 2  1 2 -1 0 1 2 -1 -1 0  1 0 0  1 0 0 1
  done
}
splats 2 >scene.ply
turn=(--axis 0 0 1 --degrees 90 --out turned.ply)
rejects scene rotate
rejects out rotate scene.ply --mirror x
rejects "give --quaternion" rotate scene.ply --out turned.ply
rejects excludes rotate scene.ply --quaternion 0 0 0 1 "${turn[@]}"
rejects excludes rotate scene.ply --quaternion 0 0 0 1 --matrix 1 0 0 0 1 0 0 0 1 --out turned.ply
rejects requires rotate scene.ply --axis 0 0 1 --out turned.ply
rejects requires rotate scene.ply --degrees 90 --out turned.ply
rejects mirror rotate scene.ply --mirror w --out turned.ply
rejects "quaternion is zero" rotate scene.ply --quaternion 0 0 0 0 --out turned.ply
rejects "quaternion is not finite" rotate scene.ply --quaternion 0 0 nan 0 --out turned.ply
rejects "axis is zero" rotate scene.ply --axis 0 0 0 --degrees 5 --out turned.ply
rejects "angle is not finite" rotate scene.ply --axis 0 0 1 --degrees inf --out turned.ply
rejects "not orthogonal" rotate scene.ply --matrix 1 0 0 0 1 0 0 0 2 --out turned.ply
rejects matrix rotate scene.ply --matrix 1 0 0 0 1 0 0 0 --out turned.ply
rejects missing.ply rotate missing.ply "${turn[@]}"
rejects "it is a folder" rotate folder "${turn[@]}"
rejects "it is a folder" rotate scene.ply --mirror x --out folder
rejects nowhere rotate scene.ply --mirror x --out nowhere/turned.ply
rejects "name is empty" rotate scene.ply --mirror x --out ""
rejects "name is empty" points --repulsion 2 --out ""
rejects "missing?file.ply: No such file" rotate $'missing\nfile.ply' "${turn[@]}"
ln -s ring.ply ring.ply
rejects "symbolic links" rotate scene.ply --mirror x --out ring.ply
# broken_splats WORD COMMAND...: rejects what the command makes of the file.
broken_splats() {
  local word=$1
  shift
  "$@" <scene.ply >broken.ply
  rejects "$word" rotate broken.ply "${turn[@]}"
}
broken_splats "not a PLY" head -c 2
broken_splats "ends in its header" head -c 100
broken_splats "has 1 of 2 splats" head -c -1
broken_splats "bytes after" cat scene.ply /dev/stdin
broken_splats "'ascii 1.0'" sed s/binary_little_endian/ascii/
broken_splats "'binary_big_endian 1.0'" sed s/little/big/
broken_splats "no property rot_3" sed s/rot_3/rot_4/
broken_splats "no property f_dc_0" sed s/f_dc_0/f_ac_0/
broken_splats "8 properties f_rest" sed s/f_rest_8/opacity/
broken_splats "must be float" sed 's/float x/int x/'
broken_splats "a second property" sed 's/float x/float y/'
broken_splats "too many" sed 's/vertex 2/vertex 99999999999999999999/'
broken_splats "lists" sed 's/uchar tag/list uchar uchar tag/'

# Volumes: three probes of order 2, and six of order 1.
for _ in 1 2 3; do floats 1 0 1 -1  2 1 0 0  1 1 1 1; done >order2.bin
for _ in 1 2 3 4 5 6; do floats 1 2 2; done >order1.bin
"$gaunt" pack order2.bin --format sh2_13 --out three.probes >out.txt || fail "pack"
"$gaunt" pack order1.bin --format rgb9e5 --grid 1 2 3 --out six.probes >out.txt || fail "pack --grid"
rejects format pack order2.bin --out turned
rejects out pack order2.bin --format sh2_13
rejects "'sh9' is no format; there are sh3_28, sh2_13" pack order2.bin --format sh9 --out turned
rejects "no multiple of 108" pack order2.bin --format sh3_28 --out turned
rejects "not in range" pack order2.bin --format sh2_13 --order 17 --out turned
rejects "not in range" pack order2.bin --format sh2_13 --order 0 --out turned
rejects "not in range" pack order2.bin --format sh2_13 --threads 0 --out turned
rejects "not in range" pack order2.bin --format sh2_13 --threads 1025 --out turned
rejects "stride of 44 bytes is less" pack order2.bin --format sh2_13 --stride 44 --out turned
rejects "2 x 1 x 1, but 3 probes" pack order2.bin --format sh2_13 --grid 2 1 1 --out turned
rejects "not in range" pack order2.bin --format sh2_13 --grid 3 1 0 --out turned
rejects requires pack order2.bin --format sh2_13 --spacing 1 1 1 --out turned
rejects "above 0" pack order2.bin --format sh2_13 --grid 3 1 1 --spacing 1 1 0 --out turned
rejects "empty.hdr: is empty" pack empty.hdr --format sh2_13 --out turned
rejects "it is a folder" pack folder --format sh2_13 --out turned
rejects "it is a folder" pack order2.bin --format sh2_13 --out folder
rejects "No such file" pack missing.bin --format sh2_13 --out turned
rejects nowhere pack order2.bin --format sh2_13 --out nowhere/turned
rejects "name is empty" pack order2.bin --format sh2_13 --out ""
rejects "scene.ply: is no file of packed probes" unpack scene.ply --out turned
rejects "give --raw-in" unpack three.probes --stride 13 --out turned
rejects "is no format" unpack three.probes --raw-in none --out turned
rejects "no multiple of the 4" unpack three.probes --out-stride 50 --out turned
rejects "give --raw-out" transcode three.probes --format sh3_28 --out-stride 50 --out turned
rejects "raw files have none" transcode three.probes --format rgb9e5 --raw-out --grid 3 1 1 --out turned
rejects requires transcode three.probes --format sh3_28 --weight 0.5 --out turned
rejects "not in range" transcode three.probes --format sh3_28 --blend three.probes --weight 2 --out turned
rejects "not in range" transcode three.probes --format sh3_28 --blend three.probes --weight nan --out turned
rejects "has 6 probes, but three.probes has 3" \
  transcode three.probes --format sh3_28 --blend six.probes --out turned
head -c -1 three.probes >broken.probes
rejects "broken.probes: is cut short" transcode broken.probes --format sh3_28 --out turned
{ cat three.probes; printf x; } >broken.probes
rejects "broken.probes: has bytes after" unpack broken.probes --out turned
{ head -c 80 three.probes; printf x; tail -c +82 three.probes; } >broken.probes
rejects "broken.probes: is damaged" unpack broken.probes --out turned
{ head -c 8 three.probes; printf '\2'; tail -c +10 three.probes; } >broken.probes
rejects "broken.probes: has version 2" unpack broken.probes --out turned
# A pipe does not say how many floats it has.
rejects "no regular file" pack <(cat order2.bin) --format sh2_13 --out turned

# Results of two orders: two methods, a scalar loop, and a series.
row() { printf '%s{"name": "%s", "label": "%s", %s}' "$comma" "$1" "$2" "$3"; comma=,; }
results() {
  local comma='' n
  printf '{"context": {"compiler": "cc 1"}, "benchmarks": [\n'
  for n in 2 3; do
    row "f/one/n$n/tiled/1024/AVX2" "first method" \
      "\"ns_item\": $n, \"mul\": 3, \"fma\": $n, \"error\": ${n}e-7, \"limit_ns\": 1, \"ns_multiply\": 0.1"
    row "f/two/n$n/tiled/1024/SSE4" "it's a_<method> \`id\`" \
      "\"ns_item\": 2$n, \"mul\": 2, \"fma\": $n, \"error\": ${n}e-8, \"limit_ns\": 2"
    row "f/one/n$n/interleaved/1024/loop" "scalar loop" "\"ns_item\": 3$n, \"error\": 1e-7"
    row "f/drift/line/$n" "a line of steps" "\"x\": $n, \"error\": ${n}e-7"
  done
  row "g/one/n2/tiled/1024/AVX2" "" '"ns_item": 1, "error": 1e-7, "limit_ns": 1'
  printf ']}\n'
}
results >results.json
head -c 300 results.json >cut.json
printf '{"pictures": []}' >foreign.json
sed 's/"name": "f.two.n3/"error_occurred": true, "error_message": "broke", &/' results.json >failed.json
rejects family chart
rejects "it has f, g" chart nonsense --results results.json
rejects "no row of g" chart g --results results.json
rejects nowhere.json chart f --results nowhere.json
rejects folder chart f --results folder
rejects "cut short" chart f --results cut.json
rejects "not what gaunt_bench writes" chart f --results foreign.json
rejects "n3/tiled/1024/SSE4 failed: broke" chart f --results failed.json
rejects "no program ./nothing" chart f --bench ./nothing
rejects excludes chart f --bench ./nothing --results results.json
rejects orders chart f --results results.json --orders 2
rejects "the first, 3, is above the last, 2" chart f --results results.json --orders 3 2
rejects "there are tiled with 1024 items, of orders 2 to 3" \
  chart f --results results.json --layout planar --out none
rejects "cannot read nowhere" chart f --results nowhere --out none
rejects "is a folder" chart f --bench folder --out none
rejects "no program that may be run" chart f --bench results.json --out none
[ ! -e none ] || fail "chart made a folder for nothing"
rejects layout chart f --results results.json --layout diagonal
rejects taken chart f --results results.json --out taken
PATH=nowhere "$gaunt" chart f --results results.json 2>err.txt
[ $? -eq 2 ] && grep -q gnuplot-nox err.txt || fail "chart without gnuplot: $(cat err.txt)"

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

# Formats of other orders; the scalar loops know one.
for format in sh2_13 sh5_55 rgb9e5; do
  "$gaunt" frame "${small[@]}" --format $format --out formats >out.txt 2>err.txt ||
    fail "format $format: $(cat err.txt)"
  grep -q " each as $format " out.txt || fail "format $format: no summary"
  grep -q '^scalar loop' out.txt && fail "format $format: times of other probes"
done
# by steps: SUM ns per object = gather TIME + lerp TIME ..., but for rounding.
awk '/^by steps: [0-9.]+ ns per object = gather [0-9.]+ \+ lerp / {
  for (k = 9; k <= NF; k += 3) sum += $k
  found = (NF == 24 && (sum - $3) ^ 2 < 0.16)
} END { exit !found }' out.txt || fail "steps: $(cat out.txt)"

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

# Splats: a quarter turn about z, and back into the file itself.
"$gaunt" rotate scene.ply "${turn[@]}" >out.txt 2>err.txt || fail "rotate: $(cat err.txt)"
grep -qE '^2 splats of SH degree 1 rotated in [0-9.]+ s \([0-9]+ MB/s\): turned.ply$' out.txt ||
  fail "summary of rotate: $(cat out.txt)"
[ ! -s err.txt ] || fail "rotate: stderr: $(cat err.txt)"
# numbers FILE: of its last splat.
numbers() { tail -c 88 "$1" | od -A n -v -t f4 -w88; }
# are FILE NUMBER...: whether a splat has these.
are() {
  local file=$1
  shift
  numbers "$file" | awk -v numbers="$*" '{
    if (split(numbers, want, " ") != NF) exit 1
    for (k = 1; k <= NF; ++k) if (($k - want[k]) ^ 2 > 1e-12) exit 1
  }' || fail "$file: $(numbers "$file") instead of $*"
}
# Coefficients -1, 0, 1 of band 1 are -y, z, -x: -x becomes -y, and -y becomes x.
are turned.ply -2 1 0  2 2 2  -1 2 -1  2 1 0  0 -1 1  1 0 0  0 0 0 1.4142136
chmod 640 turned.ply
"$gaunt" rotate turned.ply --quaternion 0 0 -0.5 0.5 --out turned.ply >out.txt || fail "rotate back"
are turned.ply 1 2 0  2 2 2  1 2 -1  0 1 2  -1 -1 0  1 0 0  1 0 0 1
[ "$(stat -c %a turned.ply)" = 640 ] || fail "rotate changed the mode of the file"
[ "$(head -c -177 turned.ply)" = "$(head -c -177 scene.ply)" ] || fail "rotate changed the header"
[ "$(tail -c 89 turned.ply | head -c 1)" = T ] || fail "rotate changed a byte"
"$gaunt" rotate scene.ply --mirror x --axis 0 0 1 --degrees 90 --out turned.ply >out.txt ||
  fail "rotate --mirror"
grep -q mirrored out.txt || fail "summary of rotate --mirror"
are turned.ply -2 -1 0  2 2 2  1 2 -1  -2 1 0  0 -1 1  1 0 0  0 1.4142136 0 0
"$gaunt" rotate scene.ply --matrix 0 -1 0 -1 0 0 0 0 1 --json --out turned.ply >json.txt ||
  fail "rotate --matrix"
grep -q '"mirrored": true' json.txt || fail "rotate --json"
are turned.ply -2 -1 0  2 2 2  1 2 -1  -2 1 0  0 -1 1  1 0 0  0 1.4142136 0 0
rm turned.ply
"$gaunt" rotate scene.ply --mirror x --out /dev/full >out.txt 2>err.txt
[ $? -eq 1 ] && [ "$(cat err.txt)" = "gaunt: cannot write /dev/full: No space left on device" ] ||
  fail "rotate to a full device: $(cat err.txt)"

# Volumes there and back.
"$gaunt" pack order2.bin --format sh2_13 --out turned >out.txt 2>err.txt || fail "pack: $(cat err.txt)"
cmp -s turned three.probes || fail "pack differs from itself"
[ ! -s err.txt ] || fail "pack: stderr: $(cat err.txt)"
grep -qE '^3 probes from floats of order 2 to sh2_13 in [0-9.]+ s \([0-9.e+-]+ million per second, [0-9]+ MB/s\): turned$' out.txt ||
  fail "summary of pack: $(cat out.txt)"
grep -qE '^error of E/pi relative to the mean light, 0.3761: RMS [0-9.]+ %' out.txt &&
  grep -q '^clamped to the format.s range: 0 coefficients$' out.txt ||
  fail "errors of pack: $(cat out.txt)"
"$gaunt" unpack turned --json --out unpacked.bin >json.txt || fail "unpack"
grep -q '"to": "floats of order 2"' json.txt || fail "unpack --json: $(cat json.txt)"
od -A n -v -t f4 -w48 unpacked.bin | awk '{
  split("1 0 1 -1 2 1 0 0 1 1 1 1", want, " ")
  for (k = 1; k <= 12; ++k) if (($k - want[k]) ^ 2 > 1e-4) exit 1
}' || fail "unpack: $(od -t f4 unpacked.bin)"
[ "$(stat -c %s unpacked.bin)" = 144 ] || fail "size of unpacked floats"
"$gaunt" transcode three.probes --format sh3_28 --raw-out --out-stride 32 --out raw.bin >out.txt ||
  fail "transcode --raw-out"
[ "$(stat -c %s raw.bin)" = 96 ] || fail "size of a raw file"
"$gaunt" transcode raw.bin --raw-in sh3_28 --stride 32 --format sh2_13 --grid 3 1 1 --origin 0 -.5 0 \
  --json --out raw.bin >json.txt || fail "transcode --raw-in"
cmp -s <(tail -c +69 raw.bin) <(tail -c +69 three.probes) || fail "transcode to SH3 and back"
grep -q '"errors"' json.txt && tr -d ' \n' <json.txt | grep -q '"origin":\[0.0,-0.5,0.0\]' ||
  fail "transcode --json: $(cat json.txt)"
"$gaunt" transcode three.probes --format sh2_13 --blend raw.bin --weight 1 --threads 1 --out turned \
  >out.txt || fail "transcode --blend"
cmp -s turned raw.bin || fail "a blend of equal volumes"
cat three.probes | "$gaunt" unpack /dev/stdin --out /dev/stdout 2>err.txt | cmp -s - unpacked.bin &&
  grep -q '^3 probes from sh2_13' err.txt || fail "unpack through pipes: $(cat err.txt)"
# Bands that the format lacks are errors, too.
"$gaunt" pack order2.bin --format rgb9e5 --order 2 --out turned >out.txt || fail "pack to order 1"
grep -q 'RMS 70.7 %, of the worst probe (0) 70.7 %$' out.txt || fail "errors of bands: $(cat out.txt)"
rm turned
for command in "pack order2.bin --format sh2_13" "unpack three.probes" "transcode three.probes --format rgb9e5"; do
  "$gaunt" $command --out /dev/full >out.txt 2>err.txt
  [ $? -eq 1 ] && [ "$(cat err.txt)" = "gaunt: cannot write /dev/full: No space left on device" ] ||
    fail "$command to a full device: $(cat err.txt)"
done
head -c 1200000 /dev/zero >zeros.bin
"$gaunt" pack zeros.bin --format rgb9e5 --out turned >out.txt || fail "pack of zeros"
grep -q '^error of E/pi: RMS 0, of the worst probe (0) 0$' out.txt || fail "errors of zeros: $(cat out.txt)"
cp turned before
(ulimit -f 64 && "$gaunt" unpack turned --out turned >out.txt 2>err.txt)
[ $? -eq 1 ] && [ "$(cat err.txt)" = "gaunt: cannot write turned: File too large" ] ||
  fail "unpack beyond the limit of files: $(cat err.txt)"
cmp -s turned before && [ -z "$(unfinished)" ] || fail "unpack at the limit of files changed its output"
rm turned

# An end in the middle leaves nothing either.
mkfifo slow.probes
head -c -1 three.probes >most.probes
"$gaunt" unpack slow.probes --out turned >out.txt 2>err.txt &
unpacking=$!
exec 3>slow.probes
cat most.probes >&3
for _ in $(seq 100); do
  [ -z "$(unfinished)" ] || break
  sleep 0.1
done
[ "$(stat -c %a .gaunt*)" = 600 ] || fail "unpack: no private file to interrupt"
kill -TERM $unpacking
wait $unpacking 2>/dev/null
[ $? -eq 143 ] && [ -z "$(unfinished)" ] && [ ! -e turned ] || fail "unpack left a file after SIGTERM"
exec 3>&-
mkfifo slow.ply
ulimit -c 0
for ending in TERM:143 ALRM:142 PIPE:141 XCPU:152; do
  "$gaunt" rotate slow.ply "${turn[@]}" >out.txt 2>err.txt &
  rotating=$!
  exec 3>slow.ply
  head -c -1 scene.ply >&3
  for _ in $(seq 100); do
    [ -z "$(unfinished)" ] || break
    sleep 0.1
  done
  [ "$(stat -c %a .gaunt*)" = 600 ] || fail "rotate: no private file to interrupt"
  kill -${ending%:*} $rotating
  wait $rotating 2>/dev/null
  [ $? -eq ${ending#*:} ] || fail "rotate does not end by SIG${ending%:*}"
  exec 3>&-
  [ -z "$(unfinished)" ] && [ ! -e turned.ply ] || fail "rotate left a file after SIG${ending%:*}"
done

# Output to links, pipes and stdout; what is said about it goes elsewhere.
"$gaunt" rotate scene.ply --mirror x --out mirrored.ply >out.txt || fail "rotate"
[ "$(stat -c %a mirrored.ply)" = "$(stat -c %a scene.ply)" ] || fail "mode of a new file"
mkdir linked && ln -s ../not-yet.ply linked/one.ply && ln -s linked/one.ply two.ply
for _ in new again; do
  "$gaunt" rotate scene.ply --mirror x --out two.ply >out.txt || fail "rotate to a dangling link"
  [ -L two.ply ] && [ -L linked/one.ply ] && cmp -s not-yet.ply mirrored.ply ||
    fail "a dangling link was replaced"
done
for form in "" --json; do
  "$gaunt" rotate scene.ply --mirror x --out /dev/stdout $form 2>err.txt | cat >piped.ply
  [ "${PIPESTATUS[0]}" -eq 0 ] && cmp -s piped.ply mirrored.ply && [ -s err.txt ] ||
    fail "rotate to stdout: $(cat err.txt)"
done
"$gaunt" rotate scene.ply --mirror x --out /dev/stdout 2>err.txt >redirected.ply
cmp -s redirected.ply mirrored.ply && grep -q mirrored err.txt || fail "rotate to redirected stdout"
"$gaunt" rotate scene.ply --mirror x --out >(cat >substituted.ply; : >read-all) >out.txt ||
  fail "rotate to a process"
for _ in $(seq 100); do
  [ ! -f read-all ] || break
  sleep 0.1
done
cmp -s substituted.ply mirrored.ply || fail "rotate to a process"
"$gaunt" points --repulsion 2 --csv --out /dev/stdout 2>err.txt | cmp -s - real.txt ||
  fail "points to stdout"

# Where there is no room.
{ cat scene.ply && head -c 200000 /dev/zero; } |
  sed 's/^end_header/element more 200000\nproperty uchar x\n&/' >large.ply
(ulimit -f 64 && "$gaunt" rotate large.ply --mirror x --out large-out.ply >out.txt 2>err.txt)
[ $? -eq 1 ] && [ "$(cat err.txt)" = "gaunt: cannot write large-out.ply: File too large" ] ||
  fail "rotate beyond the limit of files: $(cat err.txt)"
[ ! -e large-out.ply ] && [ -z "$(unfinished)" ] || fail "rotate left a file at the limit of files"
for command in "info" "info --help" "opcount --csv" "points --repulsion 2" \
  "rotate scene.ply --mirror x --out spare.ply"; do
  "$gaunt" $command >/dev/full 2>err.txt
  [ $? -eq 1 ] && [ "$(wc -l <err.txt)" -eq 1 ] && grep -q "No space left" err.txt ||
    fail "$command with a full stdout: $(cat err.txt)"
done

"$gaunt" nonsense >out.txt 2>/dev/full
[ $? -eq 2 ] || fail "exit code with a full stderr"

# Names and numbers as they come.
"$gaunt" rotate scene.ply --mirror x --json --out $'\xff.ply' >json.txt 2>err.txt ||
  fail "rotate --json of a name that is not UTF-8: $(cat err.txt)"
"$gaunt" rotate scene.ply --quaternion 0 0 -.5 -.5e0 --out short.ply >out.txt 2>err.txt ||
  fail "rotate by -.5: $(cat err.txt)"
"$gaunt" rotate scene.ply --quaternion 0 0 -0.5 -0.5 --out long.ply >out.txt
cmp -s short.ply long.ply || fail "rotate by -.5 and -0.5 differ"

# Charts.
"$gaunt" chart f --results results.json --out charts >out.txt 2>err.txt || fail "chart: $(cat err.txt)"
[ ! -s err.txt ] || fail "chart: stderr: $(cat err.txt)"
[ "$(cd charts && echo *)" = \
  "f_drift.png f_drift.svg f_error.png f_error.svg f_operations.png f_operations.svg" ] ||
  fail "charts: $(ls charts)"
for chart in error operations drift; do
  [ "$(head -c 4 "charts/f_$chart.png" | tail -c 3)" = PNG ] || fail "no f_$chart.png"
done
for word in 'order 2' 'order 3' AVX2 SSE4 'first method' "a_&lt;method> \`id\`" 'scalar loop' \
  'Pareto front' 'cc 1 · tiled layout (scalar loops: interleaved) · 1024 items'; do
  grep -q -- "$word" charts/f_error.svg || fail "f_error.svg: no $word"
done
grep -q 'scalar loop' charts/f_operations.svg && fail "f_operations.svg has a row without operations"
grep -q 'a line of steps' charts/f_drift.svg || fail "f_drift.svg: no label"

# A bench that fails, and one that a signal ends.
bench() {
  printf '#!/bin/sh\ncase $1 in *list*) echo f/op/n3/tiled/1024/AVX2; exit;; esac\n%s\n' "$1" >bench
  chmod +x bench
}
bench 'echo broke; exit 3'
"$gaunt" chart f --bench bench --out charts >out.txt 2>err.txt
[ $? -eq 1 ] && grep -q 'bench ended with status 3: broke' err.txt || fail "bench: $(cat err.txt)"
mkdir temporary
bench 'echo $$ >pid; sleep 60; echo'
TMPDIR=temporary "$gaunt" chart f --bench bench --out charts >out.txt 2>err.txt &
charting=$!
for _ in $(seq 100); do
  [ ! -s pid ] || break
  sleep 0.1
done
kill -TERM $charting
wait $charting 2>/dev/null
[ $? -eq 143 ] || fail "chart does not end by a signal"
[ -z "$(ls temporary)" ] || fail "chart left files when it was interrupted"
kill -0 "$(cat pid)" 2>/dev/null && fail "chart left its bench running"

# Links in the folder are not followed, and names are not read.
ln -s ../victim charts/.gaunt-trial
"$gaunt" chart f --results results.json --out charts >out.txt 2>&1 || fail "chart: $(cat out.txt)"
[ ! -e victim ] && [ -L charts/.gaunt-trial ] || fail "chart wrote through a link"
rm charts/.gaunt-trial
"$gaunt" chart f --results results.json --out "it's \"\`these\`" >out.txt 2>&1 ||
  fail "chart to quotes: $(cat out.txt)"

"$gaunt" info | grep -q '^target ' || fail "info"
"$gaunt" info --json | grep -q '"targets"' || fail "info --json"
GAUNT_TARGET=nonsense "$gaunt" info | grep -q 'nonsense is unknown' || fail "unknown GAUNT_TARGET"
for command in "" info opcount frame points rotate pack unpack transcode chart; do
  "$gaunt" $command --help | grep -q -- --help || fail "help of '$command'"
done

[ "$failures" -eq 0 ] && echo "all good"
exit "$((failures != 0))"
