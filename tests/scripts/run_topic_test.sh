#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# scripts/run-topic.sh must tell sound runs from wrong, skipped, silent and crashed ones.
set -eu
: "${BUILD:?}"
source=$(cd "$(dirname "$0")/../.." && pwd -P)
export ARESTA_TOPICS="$BUILD/run-topic-test"
rm -rf "$ARESTA_TOPICS"
mkdir -p "$ARESTA_TOPICS"
missed=0

# expect STATUS SIZE LINES...: a topic that prints these lines must end with this status at this size
expect() {
  wanted=$1 size=$2
  shift 2
  printf '%s\n' "$@" >"$ARESTA_TOPICS/planted.sh"
  status=0
  sh "$source/scripts/run-topic.sh" planted "$size" >"$ARESTA_TOPICS/log" 2>&1 || status=$?
  if [ "$status" != "$wanted" ]; then
    echo "status $status instead of $wanted at size $size of: $*"
    missed=$((missed + 1))
  fi
}

figures() { echo "echo 'planted: seed 1, cases $1, wrong $2, refused 0, skipped $3, coverage: all'"; }

expect 0 full "$(figures 10 0 0)"
expect 0 quick "$(figures 10 0 0)"
expect 0 full "$(figures 10 0 0)" "$(figures 3 0 0)"
expect 1 full "$(figures 10 1 0)"
expect 1 quick "$(figures 10 1 0)"
expect 1 full "$(figures 10 2 0)" "$(figures 3 0 0)"
expect 1 full "$(figures 10 0 1)"
expect 0 quick "$(figures 10 0 1)"
expect 1 full "$(figures 0 0 0)"
expect 1 quick "$(figures 0 0 0)"
expect 1 full "$(figures 0 0 5)"
expect 77 quick "$(figures 0 0 5)"
expect 1 full 'echo done'
expect 1 full ':'
expect 1 full "$(figures 10 0 0)" 'exit 3'
expect 1 quick "$(figures 10 0 0)" 'exit 3'
expect 1 full "$(figures 10 0 0)" 'kill -SEGV $$'
expect 0 full 'test "$ARESTA_SCALE" = 1 || exit 1' "$(figures 10 0 0)"
expect 0 quick 'test "$ARESTA_SCALE" = 0.01 || exit 1' "$(figures 10 0 0)"
expect 2 half "$(figures 10 0 0)"
[ "$missed" = 0 ]
