#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Storage at size: bytes per edge of a sphere of a million triangles and of a complex of cubes, and the bytes that a change
# after a snapshot copies. Wrong is a limit passed, a wrong count, or a finding of the checker. Times are topology_peers.
set -eu
"$ARESTA_BUILD/tests/large/topology_size" "$ARESTA_SCALE"
