#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Runs the tests of the built folder $BUILD, with CTest's options if given, and closes with one plain line of totals.
set -eu
: "${BUILD:?}"
source=$(cd "$(dirname "$0")/.." && pwd -P)
export ARESTA_DATA="${ARESTA_DATA:-$source/../shared/data}"
# Read by sanitized builds alone. OCCT keeps its singletons until the end of the process, so leaks are not asked for.
export ASAN_OPTIONS="${ASAN_OPTIONS:-detect_leaks=0:strict_string_checks=1:detect_stack_use_after_return=1}"
export UBSAN_OPTIONS="${UBSAN_OPTIONS:-print_stacktrace=1:suppressions=$source/cmake/ubsan.supp}"

report=$BUILD/tests.xml
rm -f "$report"
status=0
ctest --test-dir "$BUILD" -j "${JOBS:-$(nproc)}" --timeout 900 --output-on-failure --output-junit "$report" \
  --no-tests=error "$@" || status=$?

count() { sed -n "s/.*[[:space:]]$1=\"\([0-9]*\)\".*/\1/p" "$report" | head -n 1; }
[ -s "$report" ] || { echo "ctest ran no test" >&2 && exit 1; }
total=$(count tests)
failed=$(count failures)
skipped=$(($(count skipped) + $(count disabled)))
[ "$status" = 0 ] || [ "$failed" != 0 ] || failed=1
echo "$((total - failed - skipped)) passed, $failed failed, $skipped skipped"
exit "$status"
