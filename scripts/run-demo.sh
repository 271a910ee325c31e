#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Runs the main job (examples/demo/main_job.ars) with the program built in $BUILD on a STEP file, and lists what it made.
#
#   scripts/run-demo.sh [FILE.step]     results go to $OUT, by default $BUILD/out/demo
set -eu
: "${BUILD:?}"
source=$(cd "$(dirname "$0")/.." && pwd -P)
OUT=${OUT:-$BUILD/out/demo}
step=${1:-$source/examples/demo/flange.step}
aresta=$BUILD/apps/aresta/aresta

mkdir -p "$OUT"
results="regions.step drilled.step regions.inp regions.vtu regions.png exploded.png drilled.png regions.svg regions.html"
for file in $results; do rm -f "$OUT/$file"; done

echo "input: $step"
"$aresta" run "$source/examples/demo/main_job.ars" -D step="$step" -D out="$OUT" --summary-file "$OUT/summary.json"

missing=0
echo
echo "results in $OUT:"
what() {
  case $1 in
    regions.step) echo "all regions, with the faces between them shared" ;;
    drilled.step) echo "the part less the pin" ;;
    regions.inp) echo "mesh for CalculiX and Abaqus, a set for each region" ;;
    regions.vtu) echo "the same mesh for ParaView" ;;
    regions.png | exploded.png | drilled.png) echo "picture" ;;
    regions.svg) echo "line drawing with hidden lines removed" ;;
    regions.html) echo "a page to turn the model in; opens in any browser, without a network" ;;
  esac
}
for file in $results; do
  if [ -s "$OUT/$file" ]; then
    printf '  %-14s %9d bytes  %s\n' "$file" "$(wc -c <"$OUT/$file")" "$(what "$file")"
  else
    echo "  $file is missing" >&2
    missing=1
  fi
done
exit $missing
