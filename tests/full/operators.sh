#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Random non-manifold operators from each model of the catalogue: wrong is a finding of the checker, a count or an Euler
# characteristic that did not change as the operator says, or a dump that is not the same byte for byte when an operator
# is refused, taken back or made again. 200000 applications at full size.
set -eu
count=$(awk -v s="$ARESTA_SCALE" 'BEGIN { print int(200000 * s) }')
"$ARESTA_BUILD/tests/topology/operators_acceptance" "$count" "$ARESTA_SEED"
