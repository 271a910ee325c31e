#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Runs one target of libFuzzer and prints the line of figures that a topic wants.
#
#   scripts/run-fuzzer.sh TOPIC NAME PROGRAM SECONDS UNIT [OPTION or FOLDER...]
#
# In the current folder: what it found new goes to found/NAME, what went wrong to wrong/NAME, its words to NAME.log. UNIT
# is what an input is called. Options and folders of seeds are libFuzzer's own. Needs ARESTA_SEED.
set -eu
topic=$1 name=$2 program=$3 seconds=$4 unit=$5
shift 5
number() { sed -n "s/^.*$1:\{0,1\} \([0-9][0-9]*\).*/\1/p" "$name.log" | tail -n 1; }

mkdir -p "found/$name" "wrong/$name"
"$program" -seed="$ARESTA_SEED" -max_total_time="$seconds" -timeout=20 -rss_limit_mb=3000 -print_final_stats=1 \
  -artifact_prefix="wrong/$name/" "found/$name" "$@" >"$name.log" 2>&1 || true
wrong=$(find "wrong/$name" -type f ! -name 'slow-unit-*' | wc -l)
if [ "$wrong" != 0 ] || ! grep -q '^Done ' "$name.log"; then
  tail -n 40 "$name.log"
  [ "$wrong" != 0 ] || wrong=1
fi
done=$(number number_of_executed_units)
refused=$(number refused)
echo "$topic $name libFuzzer: seed $ARESTA_SEED, cases ${done:-0}, wrong $wrong, refused ${refused:-0}, skipped 0," \
  "coverage: $seconds s, $(find "found/$name" -type f | wc -l) $unit that reach something new"
