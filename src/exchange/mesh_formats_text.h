// SPDX-License-Identifier: Apache-2.0
// Shared by the writers of mesh formats: numbers as text, order of nodes, sides of elements.
#pragma once

#include <array>
#include <charconv>
#include <concepts>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/result.h"
#include "mesh/mesh.h"

namespace aresta::mesh_formats {

/// A growing text. Numbers are written without regard to the locale.
class Text {
 public:
  std::string take() { return std::move(text_); }
  const std::string& str() const { return text_; }

  Text& operator<<(std::string_view s) {
    text_ += s;
    return *this;
  }
  Text& operator<<(char c) {
    text_ += c;
    return *this;
  }
  template <std::integral T>
  requires(!std::same_as<T, char>) Text& operator<<(T number) {
    char buffer[24];
    text_.append(buffer, std::to_chars(buffer, buffer + sizeof buffer, number).ptr);
    return *this;
  }
  /// The shortest text that reads back exactly (17 significant digits at most).
  Text& operator<<(double number) {
    char buffer[32];
    text_.append(buffer, std::to_chars(buffer, buffer + sizeof buffer, number).ptr);
    return *this;
  }

 private:
  std::string text_;
};

/// Status of a mesh as far as writers rely on it: nodes in range, coordinates finite, whole elements.
Status check_mesh(const Mesh& mesh);

/// For the position i of an element's nodes in the file, the position in our (VTK's) order. Empty: the same order.
std::span<const int> msh_order(ElementType type);
std::span<const int> inp_order(ElementType type);

/// A side of a volume element by its corners.
struct ElementSide {
  std::array<std::uint32_t, 4> key{};  ///< sorted corner nodes; the last is 0xffffffff for a triangle
  std::uint32_t block = 0, element = 0;
  int side = 0;  ///< from 0, in Abaqus' order
};

/// All corner sides of volume elements, sorted by key, then block and element.
std::vector<ElementSide> volume_sides(const Mesh& mesh);

/// The sorted key of a surface element's corners.
std::array<std::uint32_t, 4> side_key(const std::uint32_t* nodes, int corners);

/// The element types' numbers of corner sides and their corners.
std::span<const std::array<int, 4>> corner_sides(ElementType type);

}  // namespace aresta::mesh_formats
