#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Regularised booleans of primitives in general and special position against volumes and areas sampled from the analytic
# shapes: wrong is a volume or area off by more than 2e-3 of the reference (of 1, where it is smaller), or a finding of
# the checker; refused is a typed error, which is listed.
set -eu
data=$ARESTA_DATA/boolean
if [ ! -f "$data/EXPECTED.tsv" ]; then
  echo "booleans: seed $ARESTA_SEED, cases 0, wrong 0, refused 0, skipped 1, coverage: no data folder"
  exit 0
fi
total=$(ls "$data"/*.ars | wc -l)
every=$(awk -v s="$ARESTA_SCALE" 'BEGIN { n = int(1 / s); print n < 1 ? 1 : n }')
[ "$every" -gt 60 ] && every=60
cases=0 wrong=0 refused=0 index=0
for script in "$data"/*.ars; do
  index=$((index + 1))
  [ $((index % every)) = 0 ] || continue
  name=$(basename "$script")
  cases=$((cases + 1))
  if ! "$ARESTA" run "$script" >"$OUT/printed" 2>"$OUT/error"; then
    if grep -q '^aresta: ' "$OUT/error"; then refused=$((refused + 1)); else wrong=$((wrong + 1)); fi
    echo "$name: $(head -n 1 "$OUT/error")"
    continue
  fi
  verdict=$(awk -F '\t' -v name="$name" '
    FNR == NR { if ($1 == name) { s = $3; v = $4 } next }
    { split($0, w, " "); got[w[1]] = w[2] }
    function off(x, r) { d = x - r; if (d < 0) d = -d; m = r > 1 ? r : 1; return d > 2e-3 * m }
    END { if (off(got["V"], v) || off(got["S"], s) || got["C"] != 0)
            printf "V %s for %s, S %s for %s, findings %s", got["V"], v, got["S"], s, got["C"] }' \
    "$data/EXPECTED.tsv" "$OUT/printed")
  [ -z "$verdict" ] || { wrong=$((wrong + 1)); echo "$name: wrong: $verdict"; }
done
echo "booleans: seed $ARESTA_SEED, cases $cases, wrong $wrong, refused $refused, skipped 0, coverage: $cases of $total files"
