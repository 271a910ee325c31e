// SPDX-License-Identifier: Apache-2.0
// The same triangles in other libraries, each in a source of its own so that headers do not meet.
#pragma once

#include <memory>
#include <string>

#include "large/large_models.h"

namespace aresta::bench {

/// What was built, kept until its time is taken.
struct Built {
  virtual ~Built() = default;
  virtual std::size_t edge_count() const = 0;
};

/// CGAL::Surface_mesh by add_vertex and add_face, with room reserved.
std::unique_ptr<Built> build_with_cgal(const test::TriangleMesh& mesh);
std::string cgal_version();

/// OpenMesh::TriMesh_ArrayKernelT by add_vertex and add_face, with room reserved.
std::unique_ptr<Built> build_with_openmesh(const test::TriangleMesh& mesh);
std::string openmesh_version();

}  // namespace aresta::bench
