#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Runs the tests of the built folder $BUILD, with CTest's options if given, and closes with one plain line of totals.
source=$(cd "$(dirname "$0")/.." && pwd -P)
. "$source/scripts/common.sh"
export ARESTA_DATA="${ARESTA_DATA:-$source/../shared/data}"

report=$BUILD/tests.xml
rm -f "$report"
status=0
ctest --test-dir "$BUILD" -j "$JOBS" --timeout 900 --output-on-failure --output-junit "$report" \
  --no-tests=error "$@" || status=$?

count() { sed -n "s/.*[[:space:]]$1=\"\([0-9]*\)\".*/\1/p" "$report" | head -n 1; }
[ -s "$report" ] || { echo "ctest ran no test" >&2 && exit 1; }
total=$(count tests)
failed=$(count failures)
skipped=$(($(count skipped) + $(count disabled)))
[ "$status" = 0 ] || [ "$failed" != 0 ] || failed=1
echo "$((total - failed - skipped)) passed, $failed failed, $skipped skipped"
exit "$status"
