#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Fragments and set operations of planar models beside OCCT, CGAL and manifold-3d, in the same run (bench/fragment): a figure
# beyond its bound is wrong, so is an answer that differs, and one that is not there where a ratio to it is asked for. At full
# size only: the libraries are installed where they are missing.
set -eu
result() { echo "planar_peers: seed 20240229, cases $1, wrong $2, refused $3, skipped $4, coverage: $5"; }
if [ "$ARESTA_SCALE" != 1 ]; then
  result 0 0 0 1 "the libraries to compare with are asked for at full size alone"
  exit 0
fi

build=$ARESTA_BUILD/bench
BENCH_MANIFOLD=$build/manifold
export BENCH_MANIFOLD
# npm comes with Node or as a package of its own; whoever has it needs no package.
if ! { { command -v npm >/dev/null || sh "$ARESTA_SOURCE/scripts/install-dependencies.sh" node; } &&
  sh "$ARESTA_SOURCE/scripts/install-dependencies.sh" build bench &&
  mkdir -p "$BENCH_MANIFOLD" && cp "$ARESTA_SOURCE"/bench/fragment/manifold/* "$BENCH_MANIFOLD" &&
  npm install --prefix "$BENCH_MANIFOLD" --ignore-scripts --no-audit --no-fund &&
  cmake -S "$ARESTA_SOURCE" -B "$build" -G Ninja -DARESTA_TESTS=OFF -DARESTA_BENCH=ON &&
  cmake --build "$build" --target bench_fragment; } >"$OUT/build.log" 2>&1; then
  tail -n 20 "$OUT/build.log"
  result 0 0 0 1 "the benchmark cannot be built here"
  exit 0
fi
status=0
"$build/bench/fragment/bench_fragment" >"$OUT/figures" 2>&1 || status=$?
cat "$OUT/figures"
count() { grep -c "^$1 " "$OUT/figures" || true; }
differing=$(count DIFFERS)
cases=$(($(count ok) + $(count BEYOND) + differing))
wrong=$(($(count BEYOND) + differing))
if [ "$status" != 0 ] && [ "$wrong" = 0 ]; then wrong=1; fi
[ "$cases" != 0 ] || cases=1
result "$cases" "$wrong" "$(count NONE)" 0 "cells of grids and random blocks; spheres, plates, sponges, terrain by set operations"
