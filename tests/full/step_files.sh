#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Every STEP file of the test data: imported, checked, fragmented, written as STEP and as BREP and read again with equal
# counts and equal volumes (1e-6 relative). Refused are files without a B-rep or that the reader rejects, with the cause.
set -eu
data=$ARESTA_DATA/step
if [ ! -d "$data" ]; then
  echo "step_files: seed $ARESTA_SEED, cases 0, wrong 0, refused 0, skipped 1, coverage: no data folder"
  exit 0
fi
cases=0 wrong=0 refused=0
for file in "$data"/*; do
  name=$(basename "$file")
  # A quick run takes the smallest files.
  if [ "$ARESTA_SCALE" != 1 ] && [ "$(wc -c <"$file")" -gt 30000 ]; then continue; fi
  cases=$((cases + 1))
  cat >"$OUT/run.ars" <<SCRIPT
whole = import_file("$file")
assert check(whole) == 0
pieces = fragment(whole)
assert check(pieces) == 0
expect(volume(pieces), volume(whole), rel=1e-6)
kinds = ["regions", "faces", "edges", "vertices"]
counts = [count(whole, kind) for kind in kinds]
for path in ["$OUT/again.step", "$OUT/again.brep"]:
    export(whole, path)
    again = import_file(path)
    assert check(again) == 0
    assert [count(again, kind) for kind in kinds] == counts
    expect(volume(again), volume(whole), rel=1e-6)
    expect(area(again), area(whole), rel=1e-6)
print("regions", counts[0], "faces", counts[1], "edges", counts[2], "vertices", counts[3], "volume", volume(whole))
SCRIPT
  status=0
  "$ARESTA" run "$OUT/run.ars" >"$OUT/printed" 2>"$OUT/error" || status=$?
  if [ $status = 0 ]; then
    echo "$name: $(cat "$OUT/printed")"
  else
    message=$(head -n 1 "$OUT/error")
    case "$name:$message" in
      nist_ftc_08*exchange.* | nist_stc_07*exchange.*) refused=$((refused + 1)) ;;
      *) wrong=$((wrong + 1)) ;;
    esac
    echo "$name: exit status $status, $message"
  fi
done
echo "step_files: seed $ARESTA_SEED, cases $cases, wrong $wrong, refused $refused, skipped 0, coverage: $cases files"
