// SPDX-License-Identifier: Apache-2.0
// Ways to break a good model, for the tests of the checker.
#pragma once

#include "model/builder.h"
#include "topology/assemble.h"

namespace aresta {

Complex assemble_unchecked(const Incidence& incidence);

// Private members, reached by the one rule that lets anybody name them: arguments of an explicit instantiation are not
// checked for access. So the product's headers need not know its tests.
namespace opened {

template <class Tag, auto pointer>
struct Open {
  friend auto member(Tag) { return pointer; }
};
#define ARESTA_OPEN(Tag, Class, field) \
  struct Tag {                         \
    friend auto member(Tag);           \
  };                                   \
  template struct Open<Tag, &Class::field>
ARESTA_OPEN(Topology, Model, topology_);
ARESTA_OPEN(Points, Model, points_);
ARESTA_OPEN(VertexTolerance, Model, vertex_tolerance_);
ARESTA_OPEN(Edges, Model, edges_);
ARESTA_OPEN(Faces, Model, faces_);
ARESTA_OPEN(Pcurves, Model, pcurves_);
ARESTA_OPEN(Surfaces, Model, surfaces_);
ARESTA_OPEN(FaceRecords, Complex, faces_);
#undef ARESTA_OPEN

}  // namespace opened

struct ModelAccess {
  static Complex& topology(Model& m) { return m.*member(opened::Topology()); }
  static Pages<Vec3>& points(Model& m) { return m.*member(opened::Points()); }
  static Pages<double>& vertex_tolerance(Model& m) { return m.*member(opened::VertexTolerance()); }
  static Pages<EdgeGeometry>& edges(Model& m) { return m.*member(opened::Edges()); }
  static Pages<FaceGeometry>& faces(Model& m) { return m.*member(opened::Faces()); }
  static std::vector<Curve2>& pcurves(Model& m) { return m.*member(opened::Pcurves()); }
  static std::vector<Surface>& surfaces(Model& m) { return m.*member(opened::Surfaces()); }
  static void set_shell(Complex& k, FaceUse use, ShellId shell) {
    (k.*member(opened::FaceRecords())).edit(use.face().index()).shell[use.side()] = shell.value;
  }
};

}  // namespace aresta

namespace aresta::testing {

/// The arrays that a complex was assembled from.
inline Incidence incidence_of(const Complex& k) {
  Incidence in;
  constexpr auto none = Incidence::none;
  in.vertex_count = static_cast<std::uint32_t>(k.vertex_count());
  for (const EdgeId e : k.edges()) in.edges.push_back({k.start(e).value, k.end(e).value});
  std::vector<std::uint32_t> new_id(k.coedge_count(), none), old_id;
  for (const FaceId f : k.faces()) {
    for (const LoopId l : k.loops(f)) {
      if (k.is_vertex_loop(l)) {
        in.add_vertex_loop(k.loop_vertex(l).value);
        continue;
      }
      for (const CoedgeId c : k.coedges(l)) {
        new_id[c.index()] = static_cast<std::uint32_t>(old_id.size());
        old_id.push_back(c.value);
        in.add_coedge(k.edge(c).value, k.reversed(c));
      }
      in.close_loop();
    }
    in.close_face();
  }
  for (const std::uint32_t c : old_id) in.radial_next.push_back(new_id[k.radial(CoedgeId(c)).index()]);
  in.region_count = static_cast<std::uint32_t>(k.region_count());
  for (const RegionId r : k.regions()) in.region_filled.push_back(k.is_filled(r));
  for (const FaceId f : k.faces()) {
    for (int side = 0; side < 2; ++side) in.face_use_region.push_back(k.region(FaceUse(f, side)).value);
  }
  for (const EdgeId e : k.edges()) in.edge_region.push_back(k.is_wire(e) ? k.region(k.wire_shell(e)).value : none);
  for (const VertexId v : k.vertices()) {
    const ShellId s = k.isolated_in_shell(v);
    in.vertex_region.push_back(s.valid() ? k.region(s).value : none);
  }
  return in;
}

/// The model with a changed incidence.
template <class Change>
Model with_incidence(Model m, Change change) {
  Incidence in = incidence_of(m.topology());
  change(in);
  ModelAccess::topology(m) = assemble_unchecked(in);
  return m;
}

}  // namespace aresta::testing
