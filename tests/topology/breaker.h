// SPDX-License-Identifier: Apache-2.0
// Access to the records of a complex, to break them.
#pragma once

#include <string>
#include <vector>

#include "topology/finding.h"

namespace aresta {

struct ComplexBreaker {
  static constexpr std::uint32_t none = Complex::none, dead = Complex::dead, tag = Complex::tag;

  static auto& vertex(Complex& k, std::size_t i) { return k.vertices_.edit(i); }
  static auto& edge(Complex& k, std::size_t i) { return k.edges_.edit(i); }
  static auto& wire(Complex& k, std::size_t i) { return k.wires_.edit(i); }
  static auto& coedge(Complex& k, std::size_t i) { return k.coedges_.edit(i); }
  static auto& point_use(Complex& k, std::size_t i) { return k.point_uses_.edit(i); }
  static auto& loop(Complex& k, std::size_t i) { return k.loops_.edit(i); }
  static auto& face(Complex& k, std::size_t i) { return k.faces_.edit(i); }
  static auto& shell(Complex& k, std::size_t i) { return k.shells_.edit(i); }
  static auto& region(Complex& k, std::size_t i) { return k.regions_.edit(i); }
  static auto& free_rows(Complex& k, RowKind kind) { return k.free_[static_cast<std::size_t>(kind)]; }
  /// A new row, of no meaning.
  static std::uint32_t add_point_use(Complex& k, std::uint32_t loop, std::uint32_t next) {
    k.point_uses_.push_back({loop, next});
    return static_cast<std::uint32_t>(k.point_uses_.size() - 1);
  }

  /// One number of a record.
  struct Word {
    Row row;
    std::string name;
    std::uint32_t* value;
  };
  /// All numbers that mean something: of a free row only its mark and its link, and the heads of the lists of free
  /// rows. Valid until k is copied or changes its size.
  static std::vector<Word> words(Complex& k) {
    std::vector<Word> result;
    const auto add = [&](RowKind kind, auto& table, auto&& list) {
      for (std::uint32_t i = 0; i < table.size(); ++i) list(Row{kind, i}, table.edit(i));
      auto& free = free_rows(k, kind);
      result.push_back({{kind, none}, "free.first", &free.first});
      result.push_back({{kind, none}, "free.count", &free.count});
    };
    using Named = std::initializer_list<std::pair<const char*, std::uint32_t*>>;
    const auto list = [&](Row row, bool is_live, Named links, Named others) {
      for (const auto& [name, value] : links) result.push_back({row, name, value});
      for (const auto& [name, value] : others) {
        if (is_live) result.push_back({row, name, value});
      }
    };
    add(RowKind::vertex, k.vertices_, [&](Row row, auto& r) {
      list(row, r.first_end != dead, {{"first_end", &r.first_end}, {"owner", &r.owner}}, {});
    });
    add(RowKind::edge, k.edges_, [&](Row row, auto& r) {
      list(row, r.vertex[0] != dead, {{"vertex 0", &r.vertex[0]}, {"vertex 1", &r.vertex[1]}},
           {{"next 0", &r.next[0]},
            {"next 1", &r.next[1]},
            {"prev 0", &r.prev[0]},
            {"prev 1", &r.prev[1]},
            {"first_use", &r.first_use}});
    });
    add(RowKind::wire, k.wires_, [&](Row row, auto& r) {
      list(row, r.edge != dead, {{"edge", &r.edge}, {"next", &r.next}}, {{"shell", &r.shell}, {"prev", &r.prev}});
    });
    add(RowKind::coedge, k.coedges_, [&](Row row, auto& r) {
      list(row, r.loop != dead, {{"loop", &r.loop}, {"next", &r.next}},
           {{"prev", &r.prev}, {"radial", &r.radial}, {"edge_sense", &r.edge_sense}});
    });
    add(RowKind::point_use, k.point_uses_, [&](Row row, auto& r) {
      list(row, r.loop != dead, {{"loop", &r.loop}, {"next", &r.next}}, {});
    });
    add(RowKind::loop, k.loops_, [&](Row row, auto& r) {
      list(row, r.face != dead, {{"face", &r.face}, {"next", &r.next}}, {{"first", &r.first}, {"prev", &r.prev}});
    });
    add(RowKind::face, k.faces_, [&](Row row, auto& r) {
      list(row, r.first_loop != dead, {{"first_loop", &r.first_loop}, {"shell 0", &r.shell[0]}},
           {{"shell 1", &r.shell[1]},
            {"next_in_shell 0", &r.next_in_shell[0]},
            {"next_in_shell 1", &r.next_in_shell[1]},
            {"prev_in_shell 0", &r.prev_in_shell[0]},
            {"prev_in_shell 1", &r.prev_in_shell[1]}});
    });
    add(RowKind::shell, k.shells_, [&](Row row, auto& r) {
      list(row, r.region != dead, {{"region", &r.region}, {"next", &r.next}},
           {{"prev", &r.prev},
            {"first_face_use", &r.first_face_use},
            {"first_wire", &r.first_wire},
            {"vertex", &r.vertex}});
    });
    add(RowKind::region, k.regions_, [&](Row row, auto& r) {
      list(row, r.filled != dead, {{"filled", &r.filled}, {"first_shell", &r.first_shell}}, {});
    });
    return result;
  }
};

}  // namespace aresta
