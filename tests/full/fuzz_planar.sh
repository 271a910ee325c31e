#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# The planar engine tried with soups of boxes, polygons, wires and points, and with pairs of closed meshes, in all kinds
# of contact: wrong is a crash, a sanitizer's finding, a hang, an imprint whose pieces are not the whole, a result that is
# not closed or whose volume does not fit. At full size libFuzzer with sanitizers goes on for thirty minutes each; at any
# size a seeded program tries 50000 cases, or a hundredth.
set -eu
cd "$OUT"
cases=$(awk -v s="$ARESTA_SCALE" 'BEGIN { print int(50000 * s) }')
seconds=$(awk -v s="$ARESTA_SCALE" 'BEGIN { print int(1800 * s) }')
number() { sed -n "s/^.*$2:\{0,1\} \([0-9][0-9]*\).*/\1/p" "$1" | tail -n 1; }
status=0
"$ARESTA_BUILD/tests/fuzz/random_planar" "$ARESTA_SEED" "$cases" >seeded.log 2>&1 || status=$?
cat seeded.log
for target in groups meshes; do
  grep "^$target: " seeded.log >line || echo "$target: refused 0, wrong 1, exit status $status" >line
  echo "fuzz_planar $target: seed $ARESTA_SEED, cases $cases, wrong $(number line wrong), refused $(number line refused)," \
    "skipped 0, coverage: seeded bytes"
done
[ "$seconds" -gt 60 ] || exit 0

build=$ARESTA_BUILD/fuzz
if ! { sh "$ARESTA_SOURCE/scripts/install-dependencies.sh" clang &&
  cmake -S "$ARESTA_SOURCE" --preset fuzz -B "$build" &&
  cmake --build "$build" --target planar_groups_fuzz planar_meshes_fuzz; } >build.log 2>&1; then
  tail -n 20 build.log
  echo "fuzz_planar: seed $ARESTA_SEED, cases 0, wrong 0, refused 0, skipped 1, coverage: libFuzzer cannot be built here"
  exit 0
fi
for target in groups meshes; do
  "$ARESTA_SOURCE/scripts/run-fuzzer.sh" fuzz_planar $target "$build/tests/fuzz/planar_${target}_fuzz" "$seconds" inputs \
    -max_len=160 -len_control=0
done
