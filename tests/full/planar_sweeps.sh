#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Operations on blocks in degenerate positions with every coordinate moved by ulps or tolerances, and on a cube and its
# copy moved by next to nothing: always the right volume, or a refusal with a reason. 20000 pairs of each at full size.
set -eu
count=$(awk -v s="$ARESTA_SCALE" 'BEGIN { print int(20000 * s) }')
"$ARESTA_BUILD/tests/boolean/sweeps/planar_sweeps" "$count" "$ARESTA_SEED"
