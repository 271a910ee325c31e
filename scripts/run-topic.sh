#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Runs one acceptance topic, tests/full/TOPIC.sh, and judges it by the figures that it prints.
#
#   scripts/run-topic.sh TOPIC full|quick
#
# The topic's script finds in its environment
#   ARESTA         the program            ARESTA_SOURCE  the sources (read only)
#   ARESTA_BUILD   the build folder       ARESTA_DATA    the folder of test data that are not part of the product
#   ARESTA_SCALE   1 (full) or 0.01       ARESTA_SEED    the seed of random cases, the same for each run unless set
#   OUT            an empty folder of its own
# and prints, last, one line for each thing it measured:
#   TOPIC: seed 1, cases 1000, wrong 0, refused 3, skipped 0, coverage: what was covered
# Wrong answers fail always; a skipped case fails a full run; a quick run that could do nothing at all ends with 77.
set -eu
topic=$1
size=$2
source=$(cd "$(dirname "$0")/.." && pwd -P)
: "${BUILD:?}"
if [ "$size" != full ] && [ "$size" != quick ]; then
  echo "run-topic: the size is full or quick, not '$size'" >&2
  exit 2
fi

export ARESTA="$BUILD/apps/aresta/aresta" ARESTA_SOURCE="$source" ARESTA_BUILD="$BUILD"
export ARESTA_DATA="${ARESTA_DATA:-$source/../shared/data}" ARESTA_SEED="${ARESTA_SEED:-20240229}"
if [ "$size" = full ]; then ARESTA_SCALE=1; else ARESTA_SCALE=0.01; fi
OUT="$BUILD/out/$size-$topic"
rm -rf "$OUT"
mkdir -p "$OUT"
export ARESTA_SCALE OUT

log=$OUT/output.log
status=0
{ sh "${ARESTA_TOPICS:-$source/tests/full}/$topic.sh" 2>&1 || echo "exit status: $?"; } | tee "$log"
if grep -q '^exit status: ' "$log"; then status=1; fi

number() { echo "$1" | sed -n "s/.*[ ,]$2 \([0-9][0-9]*\).*/\1/p"; }
lines=$(grep -E "^[A-Za-z0-9_. -]+: seed [0-9]+, cases [0-9]+, wrong [0-9]+, refused [0-9]+, skipped [0-9]+, coverage: " "$log" || true)
if [ -z "$lines" ]; then
  echo "$topic: failed: the script printed no line of figures" >&2
  exit 1
fi
all_skipped=yes
while IFS= read -r line; do
  cases=$(number "$line" cases)
  wrong=$(number "$line" wrong)
  skipped=$(number "$line" skipped)
  [ "$wrong" = 0 ] || status=1
  if [ "$cases" = 0 ]; then
    [ "$size" = quick ] && [ "$skipped" != 0 ] || status=1
  else
    all_skipped=no
  fi
  [ "$size" = quick ] || [ "$skipped" = 0 ] || status=1
done <<LINES
$lines
LINES
[ $status = 0 ] || { echo "$topic: failed" >&2 && exit 1; }
if [ $all_skipped = yes ]; then exit 77; fi
