#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Every Debian 12 package that Aresta needs, in one list, and a command that installs those that are missing.
#
#   scripts/install-dependencies.sh [SET...]    sets: build test style bench node clang; default: build
#   scripts/install-dependencies.sh --list      print the list
#
# Needs root or sudo only when something is missing.
set -eu

# set     package                           why
packages='
build   g++                               the compiler: C++20
build   cmake                             the build system
build   ninja-build                       the builder that CMake drives
build   ccache                            a second build takes seconds
build   libocct-foundation-dev            OCCT: handles, memory and the CMake package
build   libocct-modeling-data-dev         OCCT: NURBS curves and surfaces, B-rep topology
build   libocct-modeling-algorithms-dev   OCCT: intersections, general fuse, measures to compare with
build   libocct-data-exchange-dev         OCCT: STEP and IGES
build   libocct-ocaf-dev                  OCCT: names and colours in STEP files
build   libfontconfig-dev                 what the libraries of OCAF ask to be linked with
build   libeigen3-dev                     linear algebra
build   libtbb-dev                        threads
build   netgen-headers                    Netgen: tetrahedra for several regions (the C++ interface)
build   libnglib-dev                      Netgen: the library
build   libopenmpi-dev                    headers that those of Netgen include; MPI itself is not used
build   libpng-dev                        pictures
build   nlohmann-json3-dev                JSON
build   libcli11-dev                      the command line
build   libspdlog-dev                     logging
build   libfmt-dev                        text formatting
test    libgtest-dev                      the test framework
test    librapidcheck-dev                 properties over random cases
test    libgmp-dev                        exact arithmetic, as the oracle of the predicates
test    calculix-ccx                      runs the solver files that the tests write
test    chromium                          opens the HTML pages that the tests write
style   clang-format-14                   the form of the code
style   clang-tidy-16                     names and common mistakes (14 fails on the ranges of libstdc++ 12)
style   python3                           scripts/check-layers
bench   libbenchmark-dev                  micro-benchmarks (-DARESTA_BENCH=ON)
bench   libcgal-dev                       Surface_mesh, Nef polyhedra, corefinement: peers, GPL, in bench/ alone
bench   libopenmesh-dev                   the same, BSD-3-Clause
node    nodejs                            runs manifold-3d, a peer of set operations (bench/fragment)
node    npm                               installs it; asked for where there is none (Node from elsewhere brings it)
clang   clang-16                          the second compiler (preset clang-16)
clang   libclang-rt-16-dev                sanitizers and libFuzzer for it (preset fuzz)
'

if [ "${1:-}" = --list ]; then
  printf '%s' "$packages"
  exit 0
fi

[ $# -gt 0 ] || set -- build
missing=
for wanted in "$@"; do
  case $wanted in
    build | test | style | bench | node | clang) ;;
    *)
      echo "install-dependencies: there is no set '$wanted'; the sets are: build test style bench node clang" >&2
      exit 2
      ;;
  esac
  for package in $(printf '%s' "$packages" | while read -r set name _; do
    [ "$set" != "$wanted" ] || echo "$name"
  done); do
    state=$(dpkg-query -W -f '${db:Status-Status}\n' "$package" 2>/dev/null || true)
    case $state in
      *not-installed* | '') missing="$missing $package" ;;
      *installed*) ;;
      *) missing="$missing $package" ;;
    esac
  done
done
[ -n "$missing" ] || exit 0

command -v apt-get >/dev/null || {
  echo "install-dependencies: this system has no apt-get; Aresta is built on Debian 12. Missing:$missing" >&2
  exit 1
}
as_root=
if [ "$(id -u)" != 0 ]; then
  as_root=sudo
  command -v sudo >/dev/null || {
    echo "install-dependencies: packages are missing, and neither root nor sudo is at hand. As root, run:" >&2
    echo "  apt-get update && apt-get install --no-install-recommends$missing" >&2
    exit 1
  }
fi

echo "installing:$missing"
apt() { $as_root env DEBIAN_FRONTEND=noninteractive LC_ALL=C apt-get -q -o Acquire::Retries=3 -o Dpkg::Use-Pty=0 "$@"; }
apt update
# shellcheck disable=SC2086  # the list is meant to split
apt install -y --no-install-recommends $missing
