#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# The complex beside CGAL's Surface_mesh and OpenMesh, built in the same run (bench/topology): a figure beyond its bound is
# wrong, and so is a peer that did not run. At full size only: the libraries are installed where they are missing.
set -eu
result() { echo "topology_peers: seed 0, cases $1, wrong $2, refused 0, skipped $3, coverage: $4"; }
if [ "$ARESTA_SCALE" != 1 ]; then
  result 0 0 1 "the libraries to compare with are asked for at full size alone"
  exit 0
fi

build=$ARESTA_BUILD/bench
if ! { sh "$ARESTA_SOURCE/scripts/install-dependencies.sh" build bench &&
  cmake -S "$ARESTA_SOURCE" -B "$build" -G Ninja -DARESTA_TESTS=OFF -DARESTA_BENCH=ON &&
  cmake --build "$build" --target bench_topology; } >"$OUT/build.log" 2>&1; then
  tail -n 20 "$OUT/build.log"
  result 0 0 1 "the benchmark cannot be built here"
  exit 0
fi
status=0
"$build/bench/topology/bench_topology" >"$OUT/figures" 2>&1 || status=$?
cat "$OUT/figures"
within=$(grep -c '^ok ' "$OUT/figures" || true)
beyond=$(grep -c '^BEYOND ' "$OUT/figures" || true)
cases=$((within + beyond))
wrong=$beyond
for peer in CGAL OpenMesh; do
  grep -q "^$peer .* median " "$OUT/figures" || wrong=$((wrong + 1))
done
if [ "$status" != 0 ] && [ "$wrong" = 0 ]; then wrong=1; fi
[ "$cases" != 0 ] || cases=1
result "$cases" "$wrong" 0 "1003520 triangles in three libraries, 20^3 cubes, snapshot and change"
