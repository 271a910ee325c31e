# SPDX-License-Identifier: Apache-2.0
# Shared by ./demo, ./test and .ci/run, which set `source` (the folder of the sources) first. Plain POSIX sh.
# After it: BUILD and OUT are absolute folders outside of which nothing is written, and configure and build are at hand.
set -eu

die() {
  echo "$*" >&2
  exit 1
}

BUILD=${BUILD:-./build}
mkdir -p "$BUILD" 2>/dev/null && [ -w "$BUILD" ] ||
  die "cannot write to the build folder $BUILD; name another one: BUILD=\$HOME/aresta-build $0"
BUILD=$(cd "$BUILD" && pwd -P)
OUT=${OUT:-$BUILD/out}
mkdir -p "$OUT" 2>/dev/null && [ -w "$OUT" ] || die "cannot write to the output folder $OUT; name another one with OUT=..."
OUT=$(cd "$OUT" && pwd -P)
JOBS=${JOBS:-$(nproc)}
export BUILD OUT

# The same sources in another folder are found in the compiler cache; a user without a home still has a cache.
export CCACHE_BASEDIR="$source" CCACHE_NOHASHDIR=1 CCACHE_SLOPPINESS=time_macros
if [ -z "${CCACHE_DIR:-}" ] && ! mkdir -p "${HOME:-/nonexistent}/.cache/ccache" 2>/dev/null; then
  export CCACHE_DIR="$BUILD/ccache"
fi

# Read by sanitized builds alone, already while building (the tests are asked for their names). OCCT keeps its singletons
# until the end of the process, so leaks are not asked for.
export ASAN_OPTIONS="${ASAN_OPTIONS:-detect_leaks=0:strict_string_checks=1:detect_stack_use_after_return=1}"
export UBSAN_OPTIONS="${UBSAN_OPTIONS:-print_stacktrace=1:suppressions=$source/cmake/ubsan.supp}"

# quietly LOG COMMAND...: runs the command with its output in a log, of which the end is shown on failure.
quietly() {
  log=$1
  shift
  "$@" >"$log" 2>&1 && return
  tail -n 60 "$log" >&2
  die "failed: $* (all of its output: $log)"
}

# configure FOLDER [CMAKE OPTIONS...]
configure() {
  folder=$1
  shift
  mkdir -p "$folder"
  quietly "$folder/configure.log" cmake -S "$source" -B "$folder" -G Ninja "$@"
}

# build FOLDER [TARGETS...]; errors and the progress of a long build are shown as they come.
build() {
  folder=$1
  shift
  if [ $# -gt 0 ]; then set -- --target "$@"; fi
  cmake --build "$folder" -j "$JOBS" "$@"
}
