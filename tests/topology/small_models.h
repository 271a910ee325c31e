// SPDX-License-Identifier: Apache-2.0
// Models of every kind of incidence, in the notation of topology/notation.h.
#pragma once

#include <vector>

namespace aresta {

struct SmallModel {
  const char *name, *text;
  const char* counts;  ///< of regions, shells, faces, loops, coedges, edges, vertices
};

inline const char* const two_tetrahedra = R"(
base: 0 1 2
a: 0 1 3
b: 1 2 3
c: 2 0 3
d: 1 0 4
e: 2 1 4
f: 0 2 4
about 0 1: base a d
about 1 2: base b e
about 2 0: base c f
region upper filled: +base
region lower filled: -base
point 5 in upper
wire 3 6 7
)";

inline std::vector<SmallModel> small_models() {
  return {
      {"nothing", "", "1 0 0 0 0 0 0"},
      {"point", "point a", "1 1 0 0 0 0 1"},
      {"wires", "wire a b c a  # a triangle\nwire a.1 b.1 c", "1 1 0 0 0 5 3"},
      {"triangle", "f: 0 1 2", "1 1 1 1 3 3 3"},
      {"annulus", "f: a b c | p r q", "1 1 1 2 6 6 6"},
      {"point in a triangle", "f: a b c | p", "1 1 1 2 3 3 4"},
      {"dangling edge in a triangle", "f: a b c d c", "1 1 1 1 5 4 4"},
      {"digon", "f: a b.1", "1 1 1 1 2 2 2"},
      {"disk", "f: a.0", "1 1 1 1 1 1 1"},
      {"cylinder", "side: a.0 a b.0- b\nbottom: a.0-\ntop: b.0\nregion in filled: -side", "2 2 3 3 6 3 2"},
      {"sphere of one face", "f: a b\nregion in filled: -f", "2 2 1 1 2 1 2"},
      {"sphere of a point", "f: a\nregion in filled: -f", "2 2 1 1 0 0 1"},
      {"torus", "f: a.0 a.1 a.0- a.1-\nregion in filled: -f", "2 2 1 1 4 2 1"},
      {"Moebius strip", "f: a b.1 a b.2", "1 1 1 1 4 3 2"},
      {"projective plane", "f: a b.1 a b.1", "1 1 1 1 4 2 2"},
      {"tetrahedron", "p: 0 2 1\nq: 0 1 3\nr: 1 2 3\ns: 2 0 3\nregion in filled: -p", "2 2 4 4 12 6 4"},
      {"shell with a sheet on it",
       "p: 0 2 1\nq: 0 1 3\nr: 1 2 3\ns: 2 0 3\nt: 0 1 5\nabout 0 1: p q t\nregion in empty: -p", "2 2 5 5 15 8 5"},
      {"two tetrahedra", two_tetrahedra, "3 4 7 7 21 11 8"},
      {"book", "p: a b c\nq: a b d\nr: b a e\nabout b a: r q p", "1 1 3 3 9 7 5"},
  };
}

}  // namespace aresta
