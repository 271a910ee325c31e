#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Readers of complexes (dump, JSON, notation) tried with any bytes: wrong is a crash, a sanitizer's finding, a hang, or
# a complex that is read and whose dump is not read back to the same bytes. Scripts of operators, most lines right and
# some not: wrong is besides a complex with findings, a refusal without its line or that changes something, and what is
# not undone to the same dump. At full size libFuzzer with sanitizers goes on for ten minutes in all, from the texts of
# tests/corpus/topology; at any size seeded programs try both.
set -eu
cd "$OUT"
cases=$(awk -v s="$ARESTA_SCALE" 'BEGIN { n = int(200000 * s); print n < 2000 ? 2000 : n }')
seconds=$(awk -v s="$ARESTA_SCALE" 'BEGIN { print int(150 * s) }')
scripts=$(awk -v s="$ARESTA_SCALE" 'BEGIN { print int(100000 * s) }')
number() { sed -n "s/^.*$2:\{0,1\} \([0-9][0-9]*\).*/\1/p" "$1" | tail -n 1; }

seeded() { # FORMAT CASES COVERAGE: from its line in seeded.log
  grep "^$1: " seeded.log >line || echo "$1: refused 0, wrong 1, exit status $status" >line
  echo "fuzz_topology $1: seed $ARESTA_SEED, cases $2, wrong $(number line wrong), refused $(number line refused)," \
    "skipped 0, coverage: $3"
}
status=0
{ "$ARESTA_BUILD/tests/fuzz/mutate_topology" "$ARESTA_SEED" "$cases" &&
  "$ARESTA_BUILD/tests/fuzz/random_scripts" "$ARESTA_SEED" "$scripts"; } >seeded.log 2>&1 || status=$?
cat seeded.log
for format in dump json notation; do seeded $format "$cases" mutations; done
seeded script "$scripts" "operators, undone and redone"
[ "$seconds" -gt 5 ] || exit 0

# Builds the targets; what is missing is installed where that is possible.
build=$ARESTA_BUILD/fuzz
if ! { sh "$ARESTA_SOURCE/scripts/install-dependencies.sh" clang &&
  cmake -S "$ARESTA_SOURCE" --preset fuzz -B "$build" && cmake --build "$build" --target dump_fuzz json_fuzz notation_fuzz script_fuzz; } >build.log 2>&1; then
  tail -n 20 build.log
  echo "fuzz_topology: seed $ARESTA_SEED, cases 0, wrong 0, refused 0, skipped 1, coverage: libFuzzer cannot be built here"
  exit 0
fi
"$ARESTA_BUILD/tests/fuzz/mutate_topology" corpus "$OUT/seeds"
mkdir -p seeds/script
for format in dump json notation script; do
  # A script needs some length before anything is in it.
  if [ $format = script ]; then sizes="-max_len=400 -len_control=0"; else sizes=-max_len=6000; fi
  "$ARESTA_SOURCE/scripts/run-fuzzer.sh" fuzz_topology $format "$build/tests/fuzz/${format}_fuzz" "$seconds" texts $sizes \
    "seeds/$format"
done
