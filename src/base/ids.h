// SPDX-License-Identifier: Apache-2.0
// Typed handles. An id is a 32-bit index that knows what it indexes: passing an EdgeId for a VertexId does not compile.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>

namespace aresta {

template <class Tag>
struct Id {
  static constexpr std::uint32_t none = 0xffffffffu;
  std::uint32_t value = none;

  constexpr Id() = default;
  constexpr explicit Id(std::size_t index) : value(static_cast<std::uint32_t>(index)) {}
  constexpr bool valid() const { return value != none; }
  constexpr std::size_t index() const { return value; }
  constexpr auto operator<=>(const Id&) const = default;
};

using VertexId = Id<struct VertexTag>;
using EdgeId = Id<struct EdgeTag>;
using CoedgeId = Id<struct CoedgeTag>;  ///< the use of an edge by a loop
using LoopId = Id<struct LoopTag>;
using FaceId = Id<struct FaceTag>;
using ShellId = Id<struct ShellTag>;
using RegionId = Id<struct RegionTag>;
using CurveId = Id<struct CurveTag>;      ///< a curve in a model's table of curves
using SurfaceId = Id<struct SurfaceTag>;  ///< a surface in a model's table of surfaces

/// One side of a face, implied by arithmetic and never stored: side 0 is the one the face's normal points to.
struct FaceUse {
  std::uint32_t value = 0xffffffffu;

  constexpr FaceUse() = default;
  constexpr FaceUse(FaceId face, int side) : value(2 * face.value + static_cast<std::uint32_t>(side)) {}
  static constexpr FaceUse from_index(std::size_t index) {
    FaceUse use;
    use.value = static_cast<std::uint32_t>(index);
    return use;
  }
  constexpr bool valid() const { return value != 0xffffffffu; }
  constexpr std::size_t index() const { return value; }
  constexpr FaceId face() const { return FaceId(value / 2); }
  constexpr int side() const { return static_cast<int>(value & 1u); }
  constexpr FaceUse opposite() const { return from_index(value ^ 1u); }
  constexpr auto operator<=>(const FaceUse&) const = default;
};

/// The kinds of entity that users, groups, attributes and errors speak of, by dimension.
enum class EntityKind : std::uint8_t { vertex = 0, edge = 1, face = 2, region = 3 };

constexpr const char* to_string(EntityKind kind) {
  constexpr const char* names[] = {"vertex", "edge", "face", "region"};
  return names[static_cast<int>(kind)];
}

/// An entity of any dimension; ordered by dimension, then index.
struct EntityRef {
  EntityKind kind = EntityKind::vertex;
  std::uint32_t index = 0xffffffffu;

  constexpr EntityRef() = default;
  constexpr EntityRef(EntityKind k, std::uint32_t i) : kind(k), index(i) {}
  constexpr EntityRef(VertexId id) : kind(EntityKind::vertex), index(id.value) {}
  constexpr EntityRef(EdgeId id) : kind(EntityKind::edge), index(id.value) {}
  constexpr EntityRef(FaceId id) : kind(EntityKind::face), index(id.value) {}
  constexpr EntityRef(RegionId id) : kind(EntityKind::region), index(id.value) {}
  constexpr auto operator<=>(const EntityRef&) const = default;
};

}  // namespace aresta

template <class Tag>
struct std::hash<aresta::Id<Tag>> {
  std::size_t operator()(aresta::Id<Tag> id) const noexcept { return id.value; }
};
