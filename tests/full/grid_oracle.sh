#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Fragments of random operands on a grid against an enumeration of the grid that shares no code with the engine: wrong is
# any count, place, label, area or volume that is not the enumeration's. 50000 models with each kind of contact at least
# 500 times, and 5000 turned by rational rotations, at full size. Faults planted in fragments must all be found.
set -eu
oracle=$ARESTA_BUILD/tests/fragment/oracle/grid_oracle
scaled() { awk -v s="$ARESTA_SCALE" -v n="$1" 'BEGIN { print int(n * s) }'; }
for fault in label parent sense fill piece; do
  if "$oracle" 20 "$ARESTA_SEED" --plant $fault >"$OUT/$fault.log"; then
    echo "faults of kind $fault are not reported"
    exit 1
  fi
  tail -n 1 "$OUT/$fault.log" | sed -n 's/.*faults planted \([0-9]*\), caught \([0-9]*\)$/\1 \2/p' >"$OUT/caught"
  read -r planted caught <"$OUT/caught"
  echo "faults of kind $fault: $planted planted, $caught caught"
  [ "$planted" -gt 0 ] && [ "$planted" = "$caught" ] || exit 1
done
"$oracle" "$(scaled 50000)" "$ARESTA_SEED" --least "$(scaled 500)"
"$oracle" "$(scaled 5000)" "$ARESTA_SEED" --rotated
