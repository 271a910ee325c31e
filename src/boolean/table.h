// SPDX-License-Identifier: Apache-2.0
// The keep-or-remove table of booleans between groups, as data. Rows are classes, columns are operations.
//
// Classes of an entity of group A against the other group B (and the other way round):
//   out     outside every region of the other group and on none of its entities        AoutB, BoutA
//   in      in the interior of some region of the other group, on none of its entities  AinB, BinA
//   shared  both groups hold it                                                         INTERS
// With more than two groups, decided at once and never by folding: for a union "in" wins over "shared" (a face of two
// groups buried in a third), for an intersection "out" of any group wins over everything. After Arruda 2005, chapter 4,
// repaired: see the notes on the table in docs/booleans.md.
#pragma once

#include <array>
#include <cstdint>

namespace aresta {

enum class Operation : std::uint8_t { unite = 0, intersect = 1, subtract = 2 };

enum class Class : std::uint8_t { a_out_b, b_out_a, shared, a_in_b, b_in_a };

constexpr const char* to_string(Class c) {
  constexpr const char* names[] = {"AoutB", "BoutA", "INTERS", "AinB", "BinA"};
  return names[static_cast<int>(c)];
}

/// What a cell of the table says. "Own" groups are those that hold the entity; "bounds" counts listed regions.
enum class Rule : std::uint8_t {
  keep,
  remove,
  remove_if_bounds_own,       ///< bounds a region of an own group
  remove_if_bounds_two_own,   ///< bounds two regions of its own group
  remove_if_bounds_two_all,   ///< bounds two regions of every own group
  remove_if_wall,             ///< bounds two regions of one group, or one each of two groups on opposite sides
  keep_if_one_side,           ///< exactly one side lies in the result's volume
  remove_if_bounds_or_inner,  ///< bounds a region of an own group, or lay loose, dangling or isolated in a removed face
                              ///< of it
  keep_if_support             ///< only when it bounds something kept
};

struct FaceRow {
  Class cls;
  int sides;  ///< of the face in the result's volume; -1: any
  std::array<Rule, 3> rule;
};

inline constexpr FaceRow face_rows[] = {
    {Class::a_out_b, -1, {Rule::keep, Rule::remove, Rule::keep}},
    {Class::b_out_a, -1, {Rule::keep, Rule::remove, Rule::remove}},
    {Class::a_in_b, -1, {Rule::remove_if_bounds_own, Rule::remove_if_bounds_two_own, Rule::remove}},
    {Class::b_in_a, -1, {Rule::remove_if_bounds_own, Rule::remove_if_bounds_two_own, Rule::keep_if_one_side}},
    {Class::shared, 0, {Rule::keep, Rule::keep, Rule::remove}},
    {Class::shared, 1, {Rule::keep, Rule::keep, Rule::keep}},
    {Class::shared, 2, {Rule::remove_if_wall, Rule::remove_if_bounds_two_all, Rule::remove}},
};

struct LowRow {  ///< edges and vertices
  Class cls;
  std::array<Rule, 3> rule;
};

inline constexpr LowRow low_rows[] = {
    {Class::a_out_b, {Rule::keep, Rule::remove, Rule::keep}},
    {Class::b_out_a, {Rule::keep, Rule::remove, Rule::remove}},
    {Class::a_in_b, {Rule::remove_if_bounds_or_inner, Rule::keep, Rule::remove}},
    {Class::b_in_a, {Rule::remove_if_bounds_or_inner, Rule::keep, Rule::keep_if_support}},
    {Class::shared, {Rule::keep, Rule::keep, Rule::keep_if_support}},
};

constexpr Rule face_rule(Class cls, int sides, Operation operation) {
  for (const FaceRow& row : face_rows) {
    if (row.cls == cls && (row.sides == -1 || row.sides == sides)) return row.rule[static_cast<int>(operation)];
  }
  return Rule::remove;
}

constexpr Rule low_rule(Class cls, Operation operation) {
  for (const LowRow& row : low_rows) {
    if (row.cls == cls) return row.rule[static_cast<int>(operation)];
  }
  return Rule::remove;
}

}  // namespace aresta
