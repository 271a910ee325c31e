#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Wrong input of every kind. Right is: the exit status of the case, one message on standard error that begins with
# "aresta: " and says what is asked for, no output file, whole or in part, and no crash. A case may also be `refuse`d
# with any of the statuses 1, 3 and 4 (damaged files, of which some parts may still be readable).
set -eu
LC_ALL=C
export LC_ALL
cases=0 wrong=0 refused=0 skipped=0
work=$OUT/work
mkdir -p "$work"
cd "$work"
flange=$ARESTA_SOURCE/examples/demo/flange.step

bad() {
  wrong=$((wrong + 1))
  echo "wrong: $1"
  head -n 3 "$OUT/error" 2>/dev/null | cut -c 1-300 | sed 's/^/    /'
}

# judge NAME STATUSES PATTERN STATUS: looks at $OUT/error and at out.* after a run that ended with STATUS
judge() {
  cases=$((cases + 1))
  case " $2 " in
    *" $4 "*) ;;
    *)
      bad "$1: exit status $4 instead of $2"
      rm -f out.*
      return 0
      ;;
  esac
  if [ "$4" != 0 ]; then
    refused=$((refused + 1))
    if ! grep -q '^aresta: ' "$OUT/error"; then
      bad "$1: no message"
    elif ! grep -Eq -e "$3" "$OUT/error"; then
      bad "$1: the message does not say: $3"
    elif grep -Eqi 'terminate called|segmentation|sanitizer|runtime error|std::|0x[0-9a-f]{6}' "$OUT/error"; then
      bad "$1: the message is not for people"
    fi
    for file in out.* .out.*; do
      if [ -e "$file" ]; then bad "$1: $file is left behind"; fi
    done
  fi
  rm -f out.* .out.*
}

# script NAME STATUSES PATTERN LINES...: runs these lines as a script
script() {
  name=$1 statuses=$2 pattern=$3
  shift 3
  printf '%s\n' "$@" >script.ars
  status=0
  "$ARESTA" run script.ars >"$OUT/printed" 2>"$OUT/error" || status=$?
  judge "$name" "$statuses" "$pattern" "$status"
}

# program NAME STATUSES PATTERN ARGUMENTS...: runs the program
program() {
  name=$1 statuses=$2 pattern=$3
  shift 3
  status=0
  "$ARESTA" "$@" >"$OUT/printed" 2>"$OUT/error" </dev/null || status=$?
  judge "$name" "$statuses" "$pattern" "$status"
}

# --- files that are not there, or are not files
program 'missing script' 3 'missing\.ars' run missing.ars
program 'a folder as script' 3 '/' run /
program 'missing file to convert' 3 'missing\.step' convert missing.step out.brep
program 'a folder to convert' 3 '/' convert / out.brep --format brep
script 'missing file' 3 'missing\.step' 'a = import_file("missing.step")' 'export(a, "out.brep")'
script 'a folder' 3 'script\.ars:1' 'a = import_file("/")' 'export(a, "out.brep")'
script 'a folder to write to' '1 3' 'nowhere' 'export(block(1, 1, 1), "nowhere/out.step")'
script 'unknown format' '1 3' 'xyz' 'export(block(1, 1, 1), "out.xyz")'
: >empty.step
script 'empty file' '1 3' 'empty\.step' 'a = import_file("empty.step")' 'export(a, "out.brep")'

# --- wrong usage
program 'unknown command' 2 'frobnicate' frobnicate
program 'unknown option' 2 'frobnicate' run --frobnicate script.ars
program 'no script' 2 '.' run
program 'unknown command with --help' 2 'frobnicate' frobnicate --help
program 'an option in place of a command' 2 'frobnicate' --frobnicate
program 'no name' 3 'empty' run ''
program 'no name to read' 3 'empty' info ''
program 'no name to write' 2 'empty' convert "$flange" ''
program 'one argument too many' 2 'more' info "$flange" more
program 'an option without its value' 2 'format needs a value' convert "$flange" out.brep --format
for option in '--size many' '--order 1.5' '--order 3' '--size nan' '--size inf' '--size -1' '--size 1e-300' '--tolerance 0' '--threads 1.5'; do
  program "mesh $option" '1 2' "${option%% *}|${option#--}|size|order" mesh "$flange" -o out.inp ${option% *} "${option#* }"
done
for option in '--width 0' '--width 1.5' '--height 1e9' '--explode -1' '--explode 1e300' '--explode nan' '--opacity 2' '--view above'; do
  program "render $option" '1 2' "$(echo "${option% *}" | tr -d -)" render "$flange" -o out.png ${option% *} "${option#* }"
done
for plane in '' 1 a,b,c,d,e,f 0,0,0,0,0 0,0,0,0,0,0 0,0,nan,0,0,1 0,0,1e300,0,0,1 0,0,0,0,0,1, '0,0,0,0,0,1;'; do
  program "cut by '$plane'" '1 2' 'plane|normal|point' cut "$flange" --plane "$plane" --above out.brep
done
program 'cut without results' 2 'above' cut "$flange" --plane 0,0,0,0,0,1
program 'cut with one file for two results' 2 'out\.brep' cut "$flange" --plane 0,0,0,0,0,1 --above out.brep --below out.brep
program 'unknown operation' 2 'union' boolean join "$flange" "$flange" -o out.brep
# Refused before anything is read.
program 'a model as a picture' 2 'aresta render' convert missing.step out.png
program 'a model as a mesh' 2 'aresta mesh' fragment missing.step -o out.inp
program 'a mesh as a model' 2 'inp' mesh missing.step -o out.step
program 'a picture as a model' 2 'png' render missing.step -o out.step
program 'a picture without an ending' 2 'png' render missing.step -o out
program 'standard input twice' 2 'once|twice' fragment - - --input-format step -o out.brep
program 'standard input without a format' 2 'format' info -
program 'standard output without a format' 2 'format' convert "$flange" -
program 'nothing on standard input' 3 'standard input is empty' info - --format step
program 'an endless file' 3 '/dev/zero' info /dev/zero --format stl
program 'an endless script' 3 '/dev/zero' run /dev/zero
program 'a file as a folder' 3 'script\.ars/' info script.ars/ --format step
echo 'x = 1' >script.ars
program 'a summary over its own script' 2 'script\.ars' run script.ars --summary-file "$PWD/script.ars"
[ "$(cat script.ars)" = 'x = 1' ] || bad 'the script was overwritten'
program 'a name too long' 3 'nnnn' convert "$flange" "$(printf 'n%.0s' 1 2 3 4)$(head -c 300 /dev/zero | tr '\0' n).brep"
program 'a file in a file' 3 'script\.ars' convert "$flange" script.ars/out.brep
ln -sf loop.step loop.step
program 'a link to itself' 3 'loop' info loop.step

# --- damaged STEP files: cut at many places, and with bytes changed
full_cuts=100
n=$(awk -v s="$ARESTA_SCALE" -v n=$full_cuts 'BEGIN { k = int(n * s * 5); if (k > n) k = n; if (k < 5) k = 5; print k }')
size=$(wc -c <"$flange")
i=0
while [ $i -lt "$n" ]; do
  head -c $((size * 95 * i / 100 / n)) "$flange" >cut.step
  program "STEP cut at $((95 * i / n)) %" '1 3 4' 'cut\.step' convert cut.step out.brep
  i=$((i + 1))
done
i=0
while [ $i -lt "$n" ]; do
  # A changed number may make another sound part, so that 0 is right as well; a crash or a half file never is.
  awk -v seed="$((ARESTA_SEED + i))" 'BEGIN { srand(seed) }
    /^#/ && rand() < 0.02 { at = 1 + int(rand() * length($0)); $0 = substr($0, 1, at - 1) sprintf("%c", 33 + int(rand() * 90)) substr($0, at + 1) }
    { print }' "$flange" >changed.step
  program "STEP with changed bytes, seed $((ARESTA_SEED + i))" '0 1 3 4' '.' convert changed.step out.brep
  i=$((i + 1))
done

# --- random bytes under every ending
for ending in step brep stl obj ars; do
  awk -v seed="$ARESTA_SEED" 'BEGIN { srand(seed); for (i = 0; i < 5000; ++i) printf "%c", int(256 * rand()) }' >"random.$ending"
  if [ $ending = ars ]; then
    program 'random bytes as script' '1 3' 'random\.ars' run random.ars
  else
    program "random bytes as $ending" '1 3 4' "random\\.$ending" convert "random.$ending" out.brep
  fi
done

# --- coordinates that are no numbers
for word in nan inf -inf 1e999; do
  printf 'v 0 0 0\nv 1 0 0\nv 0 %s 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n' "$word" >number.obj
  program "OBJ with $word" '1 3 4' 'number\.obj' convert number.obj out.step
  printf 'solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 %s 0\nendloop\nendfacet\nendsolid s\n' "$word" >number.stl
  program "STL with $word" '1 3 4' 'number\.stl' convert number.stl out.step
done
sed 's/CARTESIAN_POINT *(\([^(]*\)([^,)]*/CARTESIAN_POINT(\1(1.E400/' "$flange" >number.step
program 'STEP with 1.E400' '1 3 4' 'number\.step' convert number.step out.brep
script 'infinite size' 1 'script\.ars:2' 'x = 1e308' 'export(block(x * 10, 1, 1), "out.step")'
script 'division by zero' 1 'script\.ars:1' 'export(block(1 / 0, 1, 1), "out.step")'

# --- sizes that make no solid
for call in 'block(0, 1, 1)' 'block(1, -1, 1)' 'cylinder(0, 1)' 'cylinder(1, 0)' 'cylinder(-1, 1)' 'sphere(0)' 'sphere(-2)' \
  'torus(1, 0)' 'torus(0, 1)' 'cone(0, 0, 1)' 'cone(-1, 1, 1)' 'prism(2, 1, 1)' 'disk(0)' 'polyline([])' 'polygon([(0, 0, 0), (1, 0, 0)])' \
  'scale(block(1, 1, 1), 0)' 'block(1e300, 1, 1)' 'block(1, 1, 1e-300)' 'block(1, 1, 1, at=(1e300, 0, 0))' 'block(1, 1, 1, at=(1e15, 0, 0))' \
  'point((1e300, 0, 0))' 'nearest(block(1, 1, 1), (1e300, 0, 0), "face")' 'cut(block(1, 1, 1), (0, 0, 1e300), (0, 0, 1))' \
  'cut(block(1, 1, 1), (0, 0, 0), (0, 0, 0))' 'translate(block(1, 1, 1), 1e300, 0, 0)' 'scale(block(1, 1, 1), 1e300)' \
  'transform(block(1, 1, 1), [0] * 12)' 'grid(block(1, 1, 1), n=(1000000, 1000, 1000), step=(1, 1, 1))' 'prism(1000000, 1, 1)' \
  'torus(1, 1)' 'revolve(disk(1, at=(0.5, 0, 0)), 90, axis=(0, 1, 0))' 'extrude(disk(1), (1, 0, 0))' 'spline([(0, 0, 0), (0, 0, 0)])' \
  'line((0, 0, 0), (0, 0, 0))' 'polyhedron([(0, 0, 0)], [[0, 0, 9]])' 'render(half_space((0, 0, 0), (0, 0, 1)), "out.png")' \
  'render(block(1, 1, 1), "out")' 'render(block(1, 1, 1) - block(1, 1, 1), "out.png")' 'mesh(block(1, 1, 1), size=1e-300)' 'cylinder(1, 1, axis=(0, 0, 0))' 'mesh(block(1, 1, 1), size=-1)'; do
  script "$call" 1 'script\.ars:2' '' "$call" 'export(block(1, 1, 1), "out.step")'
done

# --- names, types and syntax
script 'unknown name' 1 'script\.ars:1.*blok|blok.*script\.ars:1' 'export(blok(1, 2, 3), "out.step")'
script 'unknown variable' 1 'y' 'x = 1' 'print(x + y)'
script 'unknown argument' 1 'width' 'block(1, 1, 1, width=2)'
script 'missing argument' 1 'block' 'block(1, 1)'
script 'text for a number' 1 'script\.ars:1' 'block("a", 1, 1)'
script 'number for a shape' 1 'volume' 'volume(3)'
script 'numbers for shapes' 1 'union' 'union(1, 2)'
script 'list for a shape' 1 'export' 'export([1, 2], "out.step")'
script 'index out of range' 1 'script\.ars:2' 'a = [1, 2]' 'print(a[2])'
script 'syntax' 1 'script\.ars:1' 'block(1, 1'
script 'indentation' 1 'script\.ars:2' 'for i in range(2):' 'print(i)'
script 'an error in line 7' 1 'script\.ars:7' 'from aresta import *' '' '# sizes' 'a = 1' 'b = 2' '' 'c = block(a, b, 0)' 'export(c, "out.step")'
script 'expect fails' 1 'script\.ars:2' 'b = block(1, 2, 3)' 'expect(volume(b), 7)' 'export(b, "out.step")'
script 'assert fails' 1 'script\.ars:1' 'assert volume(block(1, 2, 3)) == 7'
i=0
deep=
while [ $i -lt 2000 ]; do deep="$deep("; i=$((i + 1)); done
script 'deep nesting' 1 'script\.ars:1' "x = $deep"
script 'many signs' 1 'script\.ars:1' "x = $(head -c 100000 /dev/zero | tr '\0' -)1"
script 'a list without end' 1 'script\.ars:3' 'x = [1]' 'for i in range(99):' '    x = x + x'
script 'a text without end' 1 'script\.ars:1' 'x = "a" * 10**15'
script 'a number without end' 1 'script\.ars:1' "x = $(head -c 100000 /dev/zero | tr '\0' 9)"
printf 'x = 1\000 + 2\n' >zero.ars
program 'a zero byte in a script' 1 'zero\.ars:1' run zero.ars

# --- what is unusual, but right
: >nothing.ars
program 'an empty script' 0 '' run nothing.ars
cp "$flange" 'odd ä %s \n -.step'
program 'an odd name' 0 '' convert 'odd ä %s \n -.step' 'out. ü %d.brep'
cp "$flange" own.step
program 'an output over its input' 0 '' convert own.step own.step
program 'which is still a model' 0 '' check own.step
mkfifo pipe
cat own.step >pipe &
program 'a pipe as a file' 0 '' convert pipe out.brep --input-format step --format brep
program 'a plane far away' 0 '' cut own.step --plane '0, 0, 1e20, 0, 0, 1e200' --below out.brep
program 'a device to write to' 0 '' convert own.step /dev/null --format step

# --- a full disk
disk() {
  mkdir -p disk
  if [ "$(id -u)" = 0 ]; then set -- unshare --mount "$@"; else set -- unshare --user --map-root-user --mount "$@"; fi
  "$@"
}
if disk mount -t tmpfs -o size=64k tmpfs disk 2>/dev/null; then
  status=0
  disk sh -c 'mount -t tmpfs -o ro,size=8k tmpfs disk && exec "$0" convert own.step disk/out.step' "$ARESTA" \
    >"$OUT/printed" 2>"$OUT/error" || status=$?
  judge 'a disk that is read only' 3 'disk/out\.step' "$status"
fi
if disk mount -t tmpfs -o size=64k tmpfs disk 2>/dev/null; then
  for ending in step brep inp vtu png html; do
    case $ending in
      step | brep) line='export(grid_of, "disk/out.'$ending'")' ;;
      inp | vtu) line='export(mesh(grid_of, size=0.5), "disk/out.'$ending'")' ;;
      *) line='render(grid_of, "disk/out.'$ending'")' ;;
    esac
    printf '%s\n' 'from aresta import *' 'grid_of = block(1, 1, 1)' \
      'for i in range(30):' '    grid_of = union(grid_of, block(1, 1, 1, at=(3 * i, 0, 0)))' "$line" >script.ars
    status=0
    disk sh -c 'mount -t tmpfs -o size=8k tmpfs disk && { "$0" run script.ars; s=$?; [ -z "$(ls -A disk)" ] || echo "LEFT: $(ls -A disk)"; exit $s; }' \
      "$ARESTA" >"$OUT/printed" 2>"$OUT/error" || status=$?
    if grep -q '^LEFT' "$OUT/printed"; then bad "full disk, $ending: $(cat "$OUT/printed")"; fi
    judge "full disk, $ending" 3 "out\\.$ending" "$status"
  done
else
  echo "skipped: full disk: no small disk can be mounted here"
  skipped=$((skipped + 1))
fi

# --- Ctrl-C in the middle of long operations
interrupt() { # NAME LINES...
  name=$1
  shift
  # The first line tells that the program is at work, however busy the machine is.
  printf '%s\n' 'export(point((0, 0, 0)), "begun.brep")' "$@" >script.ars
  rm -f begun.brep
  status=0
  timeout --preserve-status -k 20 -s INT 120 "$ARESTA" run script.ars >"$OUT/printed" 2>"$OUT/error" &
  running=$!
  waited=0
  while [ ! -e begun.brep ] && [ $waited -lt 600 ]; do
    sleep 0.1
    waited=$((waited + 1))
  done
  sleep 1
  kill -INT $running
  wait $running || status=$?
  judge "Ctrl-C while $name" 130 '.' "$status"
}
interrupt 'fragmenting' 'from aresta import *' 'b = [sphere(1 + i / 40, at=(i / 10, i / 7 % 1, i / 3 % 1)) for i in range(60)]' \
  'export(fragment(b), "out.step")'
interrupt 'meshing' 'from aresta import *' 'export(mesh(block(1, 1, 1) + sphere(1), size=0.005), "out.inp")'
interrupt 'drawing' 'from aresta import *' 'render(fragment(block(9, 9, 9), sphere(3)), "out.png", width=16384, height=16384)'
mkfifo silent.step
interrupt 'waiting for a pipe' 'from aresta import *' 'export(import_file("silent.step"), "out.brep")'
interrupt 'looping' 'from aresta import *' 'n = 0' 'for i in range(1000000000):' '    n = n + 1' 'export(block(1, 1, 1), "out.step")'

echo "wrong_input: seed $ARESTA_SEED, cases $cases, wrong $wrong, refused $refused, skipped $skipped, coverage: files, usage," \
  "damaged STEP ($n cuts, $n changes), random bytes, numbers, sizes, names, types, syntax, odd but right, full disk, Ctrl-C"
