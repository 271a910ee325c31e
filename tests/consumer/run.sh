#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Installs the built folder $BUILD into a prefix of its own, moves the prefix, and builds and runs the project beside this
# script, and the installed program, with nothing of the build folder in sight.
set -eu
: "${BUILD:?}"
here=$(cd "$(dirname "$0")" && pwd -P)
work=$BUILD/consumer
rm -rf "$work"
mkdir -p "$work"
DESTDIR='' cmake --install "$BUILD" --prefix "$work/first" >"$work/install.log"
mv "$work/first" "$work/prefix"
cmake -S "$here" -B "$work/build" -G Ninja -DCMAKE_PREFIX_PATH="$work/prefix" -DCMAKE_BUILD_TYPE=Release >"$work/configure.log"
cmake --build "$work/build"
"$work/build/consumer"
"$work/prefix/bin/aresta" --version
if grep -rlF "$BUILD" "$work/prefix"; then
  echo "the installed files above name the build folder" >&2
  exit 1
fi
