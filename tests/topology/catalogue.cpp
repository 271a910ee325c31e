// SPDX-License-Identifier: Apache-2.0
#include "catalogue.h"

#include <set>
#include <stdexcept>
#include <string_view>

#include "sketch.h"

namespace aresta {

namespace {

using Index = Sketch::Index;
constexpr Index outside = Sketch::outside;
constexpr Sketch::Sides in_the_open{outside, outside};  ///< a sheet with the infinite region on both sides

// --- points and wires

void one_point(Sketch& s) {
  s.add_point(0, outside);
}
void three_points(Sketch& s) {
  for (Index v = 0; v < 3; ++v) s.add_point(v, outside);
}
void segment(Sketch& s) {
  s.add_wire(0, 1, outside);
}
void two_segments(Sketch& s) {
  s.add_wire(0, 1, outside);
  s.add_wire(2, 3, outside);
}
void closed_edge(Sketch& s) {
  s.add_wire_along(s.add_edge(0, 0), outside);
}
void figure_eight(Sketch& s) {
  s.add_wire_along(s.add_edge(0, 0), outside);
  s.add_wire_along(s.add_edge(0, 0), outside);
}
void parallel_edges(Sketch& s) {
  for (int i = 0; i < 2; ++i) s.add_wire_along(s.add_edge(0, 1), outside);
}
void theta(Sketch& s) {
  for (int i = 0; i < 3; ++i) s.add_wire_along(s.add_edge(0, 1), outside);
}
void tree(Sketch& s) {
  for (const auto& [a, b] : {std::pair{0u, 1u}, {1u, 2u}, {1u, 3u}, {3u, 4u}, {3u, 5u}}) s.add_wire(a, b, outside);
}
void wire_triangle(Sketch& s) {
  for (Index v = 0; v < 3; ++v) s.add_wire(v, (v + 1) % 3, outside);
}

// --- sheets

void triangle(Sketch& s) {
  s.add_polygon({0, 1, 2}, in_the_open);
}
void two_triangles(Sketch& s) {
  s.add_polygon({0, 1, 2}, in_the_open);
  s.add_polygon({2, 1, 3}, in_the_open);
}
void two_triangles_facing(Sketch& s) {  // the same, with normals that disagree
  s.add_polygon({0, 1, 2}, in_the_open);
  s.add_polygon({1, 2, 3}, in_the_open);
}
void triangles_touching_in_a_vertex(Sketch& s) {
  s.add_polygon({0, 1, 2}, in_the_open);
  s.add_polygon({0, 3, 4}, in_the_open);
}
void square_with_hole(Sketch& s) {
  s.add_face({s.path({0, 1, 2, 3}), s.path({4, 7, 6, 5})}, in_the_open);
}
void square_with_two_holes(Sketch& s) {
  s.add_face({s.path({0, 1, 2, 3}), s.path({4, 6, 5}), s.path({7, 9, 8})}, in_the_open);
}
void square_with_strut(Sketch& s) {
  s.add_polygon({0, 1, 2, 3, 0, 4}, in_the_open);
}
void square_with_forked_strut(Sketch& s) {
  s.add_polygon({0, 1, 2, 3, 0, 4, 5, 4, 6, 4}, in_the_open);
}
void square_with_loose_strut(Sketch& s) {
  s.add_face({s.path({0, 1, 2, 3}), s.path({4, 5})}, in_the_open);
}
void square_with_isthmus(Sketch& s) {  // a hole that hangs on the boundary by an edge
  s.add_polygon({0, 1, 2, 3, 0, 4, 7, 6, 5, 4}, in_the_open);
}
void square_with_point(Sketch& s) {
  s.add_face({s.path({0, 1, 2, 3}), Sketch::point(4)}, in_the_open);
}
void square_with_two_points(Sketch& s) {
  s.add_face({s.path({0, 1, 2, 3}), Sketch::point(4), Sketch::point(5)}, in_the_open);
}
void square_with_wire(Sketch& s) {
  s.add_polygon({0, 1, 2, 3}, in_the_open);
  s.add_wire(0, 4, outside);
}
void square_with_wire_from_inside(Sketch& s) {
  s.add_face({s.path({0, 1, 2, 3}), Sketch::point(4)}, in_the_open);
  s.add_wire(4, 5, outside);
}
void squares_touching_in_inner_point(Sketch& s) {
  s.add_face({s.path({0, 1, 2, 3}), Sketch::point(8)}, in_the_open);
  s.add_face({s.path({4, 5, 6, 7}), Sketch::point(8)}, in_the_open);
}
void moebius_strip(Sketch& s) {
  for (Index i = 0; i < 4; ++i) s.add_polygon({i, i + 1, i + 6, i + 5}, in_the_open);
  s.add_polygon({4, 5, 0, 9}, in_the_open);
}
void annulus(Sketch& s) {
  for (Index i = 0; i < 3; ++i) s.add_polygon({i, (i + 1) % 3, 3 + (i + 1) % 3, 3 + i}, in_the_open);
}
void disc_on_closed_edge(Sketch& s) {
  s.add_face({s.steps({{s.add_edge(0, 0), false}})}, in_the_open);
}
void annulus_on_closed_edges(Sketch& s) {
  const Index a = s.add_edge(0, 0), b = s.add_edge(1, 1);
  s.add_face({s.steps({{a, false}}), s.steps({{b, true}})}, in_the_open);
}
void book(Sketch& s, Index pages) {
  for (Index i = 0; i < pages; ++i) s.add_polygon({0, 1, 2 + 2 * i, 3 + 2 * i}, in_the_open);
}
void book_of_three(Sketch& s) {
  book(s, 3);
}
void book_of_four(Sketch& s) {
  book(s, 4);
}
void cross(Sketch& s) {  // two squares, each cut in two where they cross
  s.add_polygon({0, 1, 2, 3}, in_the_open);
  s.add_polygon({1, 0, 4, 5}, in_the_open);
  s.add_polygon({0, 1, 6, 7}, in_the_open);
  s.add_polygon({1, 0, 8, 9}, in_the_open);
  s.order_about(s.edge(0, 1), {0, 2, 1, 3});
}
void square_standing_on_square(Sketch& s) {  // along an edge inside the lower one
  const Index below = s.add_face({s.path({0, 1, 2, 3}), s.path({4, 5})}, in_the_open);
  const Index fin = s.add_polygon({4, 5, 6, 7}, in_the_open);
  s.order_about(s.edge(4, 5), {below, fin, below});
}
void folded_into_tube(Sketch& s) {  // one face that meets itself in an edge
  const Index seam = s.add_edge(0, 1), a = s.add_edge(0, 0), b = s.add_edge(1, 1);
  s.add_face({s.steps({{a, false}, {seam, false}, {b, true}, {seam, true}})}, in_the_open);
}
void klein_bottle(Sketch& s) {
  for (Index i = 0; i < 3; ++i) {
    for (Index j = 0; j < 3; ++j) {
      const auto place = [](Index ring, Index around) {  // the last ring is sewn to the first one turned over
        return ring < 3 ? 3 * ring + around % 3 : (3 - around % 3) % 3;
      };
      s.add_polygon({place(i, j), place(i + 1, j), place(i + 1, j + 1), place(i, j + 1)}, in_the_open);
    }
  }
}

// --- one solid

void solid(Sketch& s, const Polygons& polygons) {
  const Index inside = s.add_region();
  add_polyhedron(s, polygons, {outside, inside});
}
void solid_tetrahedron(Sketch& s) {
  solid(s, tetrahedron());
}
void solid_cube(Sketch& s) {
  solid(s, cube());
}
void inverted_cube(Sketch& s) {  // normals inward
  const Index inside = s.add_region();
  add_polyhedron(s, cube(), {inside, outside});
}
void hollow_cube(Sketch& s) {  // faces that bound no volume of the model
  const Index inside = s.add_region(false);
  add_polyhedron(s, cube(), {outside, inside});
}
void solid_prism(Sketch& s) {
  solid(s, {{0, 2, 1}, {3, 4, 5}, {0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}});
}
void solid_pyramid(Sketch& s) {
  solid(s, {{0, 3, 2, 1}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}});
}
void solid_octahedron(Sketch& s) {
  solid(s, {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}, {1, 0, 5}, {2, 1, 5}, {3, 2, 5}, {0, 3, 5}});
}
void solid_torus(Sketch& s) {
  solid(s, torus(3));
}
void torus_of_one_face(Sketch& s) {
  const Index inside = s.add_region(), a = s.add_edge(0, 0), b = s.add_edge(0, 0);
  s.add_face({s.steps({{a, false}, {b, false}, {a, true}, {b, true}})}, {outside, inside});
}
void solid_cells(Sketch& s, std::array<int, 3> size, const std::set<std::array<int, 3>>& holes) {
  const Index inside = s.add_region();
  add_cells(s, size, [&](int x, int y, int z) { return holes.count({x, y, z}) != 0 ? outside : inside; });
}
void genus_two(Sketch& s) {
  solid_cells(s, {5, 3, 1}, {{1, 1, 0}, {3, 1, 0}});
}
void touching_itself_in_an_edge(Sketch& s) {
  solid_cells(s, {2, 2, 2}, {{1, 0, 0}, {0, 1, 0}, {0, 1, 1}});
}
void touching_itself_in_a_vertex(Sketch& s) {
  const std::set<std::array<int, 3>> cells{{1, 0, 0}, {0, 0, 0}, {0, 1, 0}, {0, 2, 0},
                                           {0, 2, 1}, {1, 2, 1}, {2, 2, 1}, {2, 1, 1}};
  const Index inside = s.add_region();
  add_cells(s, {3, 3, 2}, [&](int x, int y, int z) { return cells.count({x, y, z}) != 0 ? inside : outside; });
}
void cube_with_through_hole(Sketch& s) {  // top and bottom have two loops
  const Index inside = s.add_region();
  const Sketch::Sides sides{outside, inside};
  s.add_face({s.path({0, 2, 3, 1}), s.path({8, 9, 11, 10})}, sides);
  s.add_face({s.path({4, 5, 7, 6}), s.path({12, 14, 15, 13})}, sides);
  for (const auto& wall : Polygons{{0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}) s.add_polygon(wall, sides);
  for (const auto& wall : Polygons{{8, 12, 13, 9}, {10, 11, 15, 14}, {8, 10, 14, 12}, {9, 13, 15, 11}}) {
    s.add_polygon(wall, sides);
  }
}
void cube_with_blind_hole(Sketch& s) {
  const Index inside = s.add_region();
  const Sketch::Sides sides{outside, inside};
  s.add_face({s.path({4, 5, 7, 6}), s.path({12, 14, 15, 13})}, sides);
  for (const auto& wall : Polygons{{0, 2, 3, 1}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}) {
    s.add_polygon(wall, sides);
  }
  for (const auto& wall :
       Polygons{{8, 12, 13, 9}, {10, 11, 15, 14}, {8, 10, 14, 12}, {9, 13, 15, 11}, {8, 9, 11, 10}}) {
    s.add_polygon(wall, sides);
  }
}
void cube_with_point_in_face(Sketch& s) {
  const Index inside = s.add_region();
  Polygons walls = cube();
  s.add_face({s.path(walls.back()), Sketch::point(8)}, {outside, inside});
  walls.pop_back();
  add_polyhedron(s, walls, {outside, inside});
}

// --- few faces, closed ones and round ones

void sphere_on_vertex(Sketch& s) {
  s.add_face({Sketch::point(0)}, {outside, s.add_region()});
}
void sphere_on_two_vertices(Sketch& s) {
  s.add_face({Sketch::point(0), Sketch::point(1)}, {outside, s.add_region()});
}
void sphere_with_seam(Sketch& s) {
  s.add_face({s.path({0, 1})}, {outside, s.add_region()});
}
void hemispheres(Sketch& s) {
  const Index inside = s.add_region(), e = s.add_edge(0, 0);
  s.add_face({s.steps({{e, false}})}, {outside, inside});
  s.add_face({s.steps({{e, true}})}, {outside, inside});
}
void pillow(Sketch& s) {
  const Index inside = s.add_region(), a = s.add_edge(0, 1), b = s.add_edge(0, 1);
  s.add_face({s.steps({{a, false}, {b, true}})}, {outside, inside});
  s.add_face({s.steps({{b, false}, {a, true}})}, {outside, inside});
}
void cylinder(Sketch& s) {
  const Index inside = s.add_region(), low = s.add_edge(0, 0), high = s.add_edge(1, 1);
  s.add_face({s.steps({{low, true}})}, {outside, inside});
  s.add_face({s.steps({{high, false}})}, {outside, inside});
  s.add_face({s.steps({{low, false}}), s.steps({{high, true}})}, {outside, inside});
}
void cylinder_with_seam(Sketch& s) {
  const Index inside = s.add_region(), low = s.add_edge(0, 0), high = s.add_edge(1, 1), seam = s.add_edge(0, 1);
  s.add_face({s.steps({{low, true}})}, {outside, inside});
  s.add_face({s.steps({{high, false}})}, {outside, inside});
  s.add_face({s.steps({{low, false}, {seam, false}, {high, true}, {seam, true}})}, {outside, inside});
}
void cone(Sketch& s) {
  const Index inside = s.add_region(), base = s.add_edge(0, 0);
  s.add_face({s.steps({{base, true}})}, {outside, inside});
  s.add_face({s.steps({{base, false}}), Sketch::point(1)}, {outside, inside});
}
void two_cones_apex_to_apex(Sketch& s) {
  for (Index i = 0; i < 2; ++i) {
    const Index inside = s.add_region(), base = s.add_edge(i, i);
    s.add_face({s.steps({{base, true}})}, {outside, inside});
    s.add_face({s.steps({{base, false}}), Sketch::point(2)}, {outside, inside});
  }
}

// --- solids with something else

void cube_with_wire_inside(Sketch& s) {
  solid_cube(s);
  s.add_wire(0, 8, 1);
}
void cube_with_diagonal(Sketch& s) {
  solid_cube(s);
  s.add_wire(0, 7, 1);
}
void cube_with_wire_outside(Sketch& s) {
  solid_cube(s);
  s.add_wire(0, 8, outside);
}
void cube_with_handle(Sketch& s) {
  solid_cube(s);
  s.add_wire(0, 7, outside);
}
void cube_with_wires_on_both_sides(Sketch& s) {
  solid_cube(s);
  s.add_wire(0, 8, 1);
  s.add_wire(0, 9, outside);
}
void cube_with_loose_wire_inside(Sketch& s) {
  solid_cube(s);
  s.add_wire(8, 9, 1);
}
void cube_with_points(Sketch& s) {
  solid_cube(s);
  s.add_point(8, 1);
  s.add_point(9, outside);
}
void cube_with_fin(Sketch& s) {
  solid_cube(s);
  s.add_polygon({0, 1, 8, 9}, in_the_open);
}
void cube_with_fin_inside(Sketch& s) {
  solid_cube(s);
  s.add_polygon({0, 1, 8, 9}, {1, 1});
}
void cube_with_sheet_inside_on_two_edges(Sketch& s) {
  solid_cube(s);
  s.add_polygon({1, 0, 2, 8}, {1, 1});
}
void cube_with_sheet_inside(Sketch& s) {  // free of the walls
  solid_cube(s);
  s.add_polygon({8, 9, 10}, {1, 1});
}
void cube_with_fin_on_a_face(Sketch& s) {
  const Index inside = s.add_region();
  Polygons walls = cube();
  const Index wall = s.add_face({s.path(walls.back()), s.path({8, 9})}, {outside, inside});
  walls.pop_back();
  add_polyhedron(s, walls, {outside, inside});
  const Index fin = s.add_polygon({8, 9, 10, 11}, in_the_open);
  s.order_about(s.edge(8, 9), {wall, fin, wall});
}
void cube_with_wire_from_a_face(Sketch& s) {
  cube_with_point_in_face(s);
  s.add_wire(8, 9, outside);
}
void torus_with_membrane_inside(Sketch& s) {  // across the tube; divides nothing
  solid_torus(s);
  s.add_polygon({0, 1, 2}, {1, 1});
}
void torus_with_membrane_across_hole(Sketch& s) {
  solid_torus(s);
  s.add_polygon({0, 3, 6}, in_the_open);
}

// --- several regions

void two_cubes_with_common_face(Sketch& s) {
  const Index left = s.add_region(), right = s.add_region();
  add_cells(s, {2, 1, 1}, [&](int x, int, int) { return x == 0 ? left : right; });
}
void cube_beside_hollow_one(Sketch& s) {
  const Index left = s.add_region(), right = s.add_region(false);
  add_cells(s, {2, 1, 1}, [&](int x, int, int) { return x == 0 ? left : right; });
}
void eight_cubes(Sketch& s) {
  for (int i = 0; i < 8; ++i) s.add_region();
  add_cells(s, {2, 2, 2}, [](int x, int y, int z) { return static_cast<Index>(1 + x + 2 * y + 4 * z); });
}
void chessboard(Sketch& s) {  // two cubes of four that meet in an edge
  const Index a = s.add_region(), b = s.add_region();
  add_cells(s, {2, 2, 1}, [&](int x, int y, int) { return x != y ? outside : x == 0 ? a : b; });
}
void three_prisms_in_a_row(Sketch& s) {
  for (int i = 0; i < 3; ++i) s.add_region();
  s.add_polygon({0, 2, 1}, {outside, 1});
  for (Index i = 1; i <= 3; ++i) {
    const Index below = 3 * (i - 1), above = 3 * i;
    for (Index j = 0; j < 3; ++j) {
      s.add_polygon({below + j, below + (j + 1) % 3, above + (j + 1) % 3, above + j}, {outside, i});
    }
    s.add_polygon({above, above + 1, above + 2}, {i < 3 ? i + 1 : outside, i});
  }
}
void three_wedges_about_an_edge(Sketch& s) {
  for (int i = 0; i < 3; ++i) s.add_region();
  const auto low = [](Index j) { return 2 + j % 3; };
  const auto high = [](Index j) { return 5 + j % 3; };
  for (Index j = 0; j < 3; ++j) {
    s.add_polygon({0, low(j), high(j), 1}, {1 + (j + 2) % 3, 1 + j});
    s.add_polygon({low(j), low(j + 1), high(j + 1), high(j)}, {outside, 1 + j});
    s.add_polygon({0, low(j + 1), low(j)}, {outside, 1 + j});
    s.add_polygon({1, high(j), high(j + 1)}, {outside, 1 + j});
  }
}
void cube_standing_on_cube(Sketch& s) {  // on the inside of its top
  const Index below = s.add_region(), above = s.add_region();
  s.add_face({s.path({4, 5, 7, 6}), s.path({8, 10, 11, 9})}, {outside, below});
  for (const auto& wall : Polygons{{0, 2, 3, 1}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}) {
    s.add_polygon(wall, {outside, below});
  }
  Polygons upper = cube();
  upper.erase(upper.begin());
  add_polyhedron(s, upper, {outside, above}, 8);
  s.add_polygon({8, 10, 11, 9}, {below, above});
}
void sphere_cut_by_disc(Sketch& s) {
  const Index above = s.add_region(), below = s.add_region(), e = s.add_edge(0, 0);
  s.add_face({s.steps({{e, false}})}, {outside, above});
  s.add_face({s.steps({{e, true}})}, {outside, below});
  s.add_face({s.steps({{e, false}})}, {above, below});
}

// --- voids

void cube_in_cube(Sketch& s, bool filled) {
  const Index wall = s.add_region(), core = s.add_region(filled);
  add_polyhedron(s, cube(), {outside, wall});
  add_polyhedron(s, cube(), {wall, core}, 8);
}
void cube_with_void(Sketch& s) {
  cube_in_cube(s, false);
}
void cube_in_cube_filled(Sketch& s) {
  cube_in_cube(s, true);
}
void three_nested_cubes(Sketch& s) {
  for (Index i = 0; i < 3; ++i) {
    const Index inside = s.add_region();
    add_polyhedron(s, cube(), {inside - 1, inside}, 8 * i);
  }
}
void cube_with_two_voids(Sketch& s) {
  const Index inside = s.add_region();
  add_polyhedron(s, cube(), {outside, inside});
  add_polyhedron(s, tetrahedron(), {inside, s.add_region(false)}, 8);
  add_polyhedron(s, cube(), {inside, s.add_region(false)}, 12);
}
void cube_with_toroidal_void(Sketch& s) {
  const Index inside = s.add_region();
  add_polyhedron(s, cube(), {outside, inside});
  add_polyhedron(s, torus(3), {inside, s.add_region(false)}, 8);
}
void cube_with_wire_to_its_void(Sketch& s) {
  cube_with_void(s);
  s.add_wire(0, 8, 1);
}
void cube_with_sheet_to_its_void(Sketch& s) {
  cube_with_void(s);
  s.add_polygon({0, 1, 9, 8}, {1, 1});
}
void cube_with_things_in_its_void(Sketch& s) {
  cube_with_void(s);
  s.add_point(16, 2);
  s.add_wire(17, 18, 2);
  add_polyhedron(s, tetrahedron(), {2, s.add_region()}, 19);
}

// --- touching solids

void two_separate_cubes(Sketch& s) {
  add_polyhedron(s, cube(), {outside, s.add_region()});
  add_polyhedron(s, cube(), {outside, s.add_region()}, 8);
}
void two_tetrahedra_with_common_vertex(Sketch& s) {
  add_polyhedron(s, tetrahedron(), {outside, s.add_region()});
  add_polyhedron(s, tetrahedron(), {outside, s.add_region()}, 3);
}
void two_tetrahedra_with_common_edge(Sketch& s) {
  add_polyhedron(s, tetrahedron(), {outside, s.add_region()});
  add_polyhedron(s, tetrahedron(), {outside, s.add_region()}, 2);
}
void two_tetrahedra_with_common_face(Sketch& s) {
  const Index a = s.add_region(), b = s.add_region();
  add_polyhedron(s, {{0, 2, 1}, {0, 1, 3}, {2, 0, 3}}, {outside, a});
  s.add_polygon({1, 2, 3}, {b, a});
  add_polyhedron(s, {{1, 2, 4}, {2, 3, 4}, {3, 1, 4}}, {outside, b});
}
void tetrahedron_in_corner_of_cube(Sketch& s) {  // vertex 7 is common, from inside
  const Index inside = s.add_region();
  add_polyhedron(s, cube(), {outside, inside});
  add_polyhedron(s, tetrahedron(), {inside, s.add_region()}, 7);
}
void tetrahedron_on_edge_in_cube(Sketch& s) {  // the edge of 6 and 7 is common, from inside
  const Index inside = s.add_region();
  add_polyhedron(s, cube(), {outside, inside});
  add_polyhedron(s, tetrahedron(), {inside, s.add_region()}, 6);
}
void ring_of_three_tetrahedra(Sketch& s) {  // each touches the next in a vertex
  for (const auto& corners : {std::array{0u, 1u, 3u, 4u}, {1u, 2u, 5u, 6u}, {2u, 0u, 7u, 8u}}) {
    const Index inside = s.add_region();
    for (auto polygon : tetrahedron()) {
      for (Index& v : polygon) v = corners[v];
      s.add_polygon(polygon, {outside, inside});
    }
  }
}

struct Entry {
  const char* name;
  void (*sketch)(Sketch&);
};

constexpr Entry entries[] = {
    {"nothing", [](Sketch&) {}},
    {"one point", one_point},
    {"three points", three_points},
    {"segment", segment},
    {"two segments", two_segments},
    {"closed edge", closed_edge},
    {"figure eight", figure_eight},
    {"parallel edges", parallel_edges},
    {"theta", theta},
    {"tree", tree},
    {"wire triangle", wire_triangle},

    {"triangle", triangle},
    {"two triangles", two_triangles},
    {"two triangles facing", two_triangles_facing},
    {"triangles touching in a vertex", triangles_touching_in_a_vertex},
    {"square with hole", square_with_hole},
    {"square with two holes", square_with_two_holes},
    {"square with strut", square_with_strut},
    {"square with forked strut", square_with_forked_strut},
    {"square with loose strut", square_with_loose_strut},
    {"square with isthmus", square_with_isthmus},
    {"square with point", square_with_point},
    {"square with two points", square_with_two_points},
    {"square with wire", square_with_wire},
    {"square with wire from inside", square_with_wire_from_inside},
    {"squares touching in inner point", squares_touching_in_inner_point},
    {"moebius strip", moebius_strip},
    {"annulus", annulus},
    {"disc on closed edge", disc_on_closed_edge},
    {"annulus on closed edges", annulus_on_closed_edges},
    {"book of three", book_of_three},
    {"book of four", book_of_four},
    {"cross", cross},
    {"square standing on square", square_standing_on_square},
    {"folded into tube", folded_into_tube},
    {"klein bottle", klein_bottle},

    {"tetrahedron", solid_tetrahedron},
    {"cube", solid_cube},
    {"inverted cube", inverted_cube},
    {"hollow cube", hollow_cube},
    {"prism", solid_prism},
    {"pyramid", solid_pyramid},
    {"octahedron", solid_octahedron},
    {"torus", solid_torus},
    {"torus of one face", torus_of_one_face},
    {"genus two", genus_two},
    {"touching itself in an edge", touching_itself_in_an_edge},
    {"touching itself in a vertex", touching_itself_in_a_vertex},
    {"cube with through hole", cube_with_through_hole},
    {"cube with blind hole", cube_with_blind_hole},
    {"cube with point in face", cube_with_point_in_face},

    {"sphere on vertex", sphere_on_vertex},
    {"sphere on two vertices", sphere_on_two_vertices},
    {"sphere with seam", sphere_with_seam},
    {"hemispheres", hemispheres},
    {"pillow", pillow},
    {"cylinder", cylinder},
    {"cylinder with seam", cylinder_with_seam},
    {"cone", cone},
    {"two cones apex to apex", two_cones_apex_to_apex},

    {"cube with wire inside", cube_with_wire_inside},
    {"cube with diagonal", cube_with_diagonal},
    {"cube with wire outside", cube_with_wire_outside},
    {"cube with handle", cube_with_handle},
    {"cube with wires on both sides", cube_with_wires_on_both_sides},
    {"cube with loose wire inside", cube_with_loose_wire_inside},
    {"cube with points", cube_with_points},
    {"cube with fin", cube_with_fin},
    {"cube with fin inside", cube_with_fin_inside},
    {"cube with sheet inside on two edges", cube_with_sheet_inside_on_two_edges},
    {"cube with sheet inside", cube_with_sheet_inside},
    {"cube with fin on a face", cube_with_fin_on_a_face},
    {"cube with wire from a face", cube_with_wire_from_a_face},
    {"torus with membrane inside", torus_with_membrane_inside},
    {"torus with membrane across hole", torus_with_membrane_across_hole},

    {"two cubes with common face", two_cubes_with_common_face},
    {"cube beside hollow one", cube_beside_hollow_one},
    {"eight cubes", eight_cubes},
    {"chessboard", chessboard},
    {"three prisms in a row", three_prisms_in_a_row},
    {"three wedges about an edge", three_wedges_about_an_edge},
    {"cube standing on cube", cube_standing_on_cube},
    {"sphere cut by disc", sphere_cut_by_disc},

    {"cube with void", cube_with_void},
    {"cube in cube filled", cube_in_cube_filled},
    {"three nested cubes", three_nested_cubes},
    {"cube with two voids", cube_with_two_voids},
    {"cube with toroidal void", cube_with_toroidal_void},
    {"cube with wire to its void", cube_with_wire_to_its_void},
    {"cube with sheet to its void", cube_with_sheet_to_its_void},
    {"cube with things in its void", cube_with_things_in_its_void},

    {"two separate cubes", two_separate_cubes},
    {"two tetrahedra with common vertex", two_tetrahedra_with_common_vertex},
    {"two tetrahedra with common edge", two_tetrahedra_with_common_edge},
    {"two tetrahedra with common face", two_tetrahedra_with_common_face},
    {"tetrahedron in corner of cube", tetrahedron_in_corner_of_cube},
    {"tetrahedron on edge in cube", tetrahedron_on_edge_in_cube},
    {"ring of three tetrahedra", ring_of_three_tetrahedra},
};

Complex built(const Entry& entry) {
  try {
    Sketch sketch;
    entry.sketch(sketch);
    return sketch.complex();
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(std::string(entry.name) + ": " + error.what());
  }
}

}  // namespace

std::vector<CatalogueModel> catalogue() {
  std::vector<CatalogueModel> models;
  for (const Entry& entry : entries) models.push_back({entry.name, built(entry)});
  return models;
}

Complex catalogue_model(const char* name) {
  for (const Entry& entry : entries) {
    if (std::string_view(entry.name) == name) return built(entry);
  }
  throw std::runtime_error(std::string("the catalogue has no ") + name);
}

}  // namespace aresta
