// SPDX-License-Identifier: Apache-2.0
#include "fuzz/script_writer.h"

#include "topology/item.h"
#include "topology/small_models.h"

namespace aresta::test {

std::size_t ScriptWriter::below(std::size_t n) {
  std::size_t value = 0;
  for (std::size_t range = 1; range < n && !at_end(); range *= 256) {
    value = 256 * value + static_cast<unsigned char>(bytes_[at_++]);
  }
  return n == 0 ? 0 : value % n;
}

/// Invalid when there is none.
template <class IdType, class Range>
IdType ScriptWriter::any(const Range& range) {
  std::vector<IdType> all;
  for (const IdType id : range) all.push_back(id);
  return all.empty() ? IdType() : all[below(all.size())];
}

template <class IdType, class Range>
std::string ScriptWriter::number(const Range& range) {
  const auto id = any<IdType>(range);
  return id.valid() ? std::to_string(id.value) : "0";
}

std::string ScriptWriter::Call::text() const {
  std::string text = name + "(";
  for (std::size_t i = 0; i < arguments.size(); ++i) text += (i == 0 ? "" : ", ") + arguments[i];
  return text + ")";
}

std::string ScriptWriter::line(const Complex* m) {
  if (m == nullptr) return start();
  if (chance(12)) return other_line();
  Call made = call(*m);
  if (chance(12)) spoil(made);
  std::string text = made.text();
  if (chance(3)) text = text.substr(0, below(text.size()));
  if (chance(3)) text = "a, b = " + text;
  return text;
}

std::string ScriptWriter::start() {
  if (chance(50)) return "m = m_mr()";
  const auto models = small_models();
  std::string text;
  for (const char c : std::string(models[below(models.size())].text)) text += c == '\n' ? "\\n" : std::string(1, c);
  return "m = read_complex(\"" + text + "\", \"notation\")";
}

/// All that is not an operator.
std::string ScriptWriter::other_line() {
  switch (below(14)) {
    case 0:
      return start();
    case 1:
      return "n = m";
    case 2:
      return "m, n = n, m";
    case 3:
      return "n = read_complex(dump(m))";
    case 4:
      return "n = read_complex(dump(m, \"json\"), \"json\")";
    case 5:
      return "assert dump(read_complex(dump(m))) == dump(m)";
    case 6:
      return "n = read_complex(dump(m)[" + std::to_string(below(300)) + ":])";
    case 7:
      return "assert check(m) >= 0 and len(betti(m)) == 3";
    case 8:
      return "print(m, count(m, \"faces\"), betti(m))";
    case 9:
      return "k_m(m)";
    case 10:
    case 11:
    case 12:
      return "undo(m)";
    default:
      return "redo(m)";
  }
}

std::string ScriptWriter::region_at(const Complex& k, VertexId v) {
  if (chance(30)) return "None";
  std::vector<RegionId> regions;
  for_each_item_at(k, v, [&](Item item) { regions.push_back(region_of(k, item)); });
  return number<RegionId>(regions);
}

std::string ScriptWriter::corner(const Complex& k, FaceId f) {
  const auto l = any<LoopId>(k.loops(f));
  return k.is_vertex_loop(l) ? "\"l" + std::to_string(l.value) + "\"" : "\"c" + number<CoedgeId>(k.coedges(l)) + "\"";
}

/// A walk along edges until it comes back, or back the way it went.
std::string ScriptWriter::circuit(const Complex& k) {
  const auto first = any<VertexId>(k.vertices());
  if (k.has_no_edge(first) || chance(5)) return "v" + std::to_string(first.value);
  std::vector<EdgeEnd> path;
  VertexId v = first;
  do {
    auto end = any<EdgeEnd>(k.edge_ends(v));
    if (!path.empty() && end.edge == path.back().edge) end = any<EdgeEnd>(k.edge_ends(v));
    path.push_back(end);
    v = k.vertex({end.edge, 1 - end.end});
  } while (v != first && path.size() < 6);
  for (std::size_t i = v == first ? 0 : path.size(); i-- > 0;) path.push_back({path[i].edge, 1 - path[i].end});
  std::string text;
  for (const EdgeEnd use : path) {
    text += (text.empty() ? "" : " ") + std::string(use.end == 1 ? "-e" : "e") + std::to_string(use.edge.value);
    const auto after = any<CoedgeId>(k.coedges(use.edge));
    if (after.valid() && chance(50)) text += "@c" + std::to_string(after.value);
  }
  return text;
}

std::string ScriptWriter::items(const Complex& k) {
  std::string text;
  for (std::size_t n = chance(70) ? 0 : below(4); n > 0; --n) {
    switch (below(4)) {
      case 0:
        text += " e" + number<EdgeId>(k.edges());
        break;
      case 1:
        text += " v" + number<VertexId>(k.vertices());
        break;
      default:
        text += (chance(50) ? " -f" : " f") + number<FaceId>(k.faces());
    }
  }
  return "\"" + text + "\"";
}

ScriptWriter::Call ScriptWriter::call(const Complex& k) {
  const auto vertex = [&] { return number<VertexId>(k.vertices()); };
  const auto edge = [&] { return number<EdgeId>(k.edges()); };
  const auto face = [&] { return number<FaceId>(k.faces()); };
  // Large complexes are taken apart.
  const bool large = k.vertex_count() + k.edge_count() + k.face_count() > 40;
  std::size_t choice = large ? 13 + below(10) : below(24);
  // What needs edges or faces waits until there are some.
  if (k.face_count() == 0 && ((choice >= 9 && choice <= 12) || choice == 16 || choice == 17 || choice == 20))
    choice = 5;
  if (k.edge_count() == 0 && (choice == 5 || choice == 14 || choice == 15 || choice == 19 || choice > 20)) choice = 1;
  if (k.vertex_count() == 0) choice = 0;
  switch (choice) {
    case 0:
      return {"m_sv", {"m", number<RegionId>(k.regions())}};
    case 1:
    case 2: {
      const auto v = any<VertexId>(k.vertices());
      return {"m_ev", {"m", std::to_string(v.value), region_at(k, v)}};
    }
    case 3:
    case 4: {
      const auto v = any<VertexId>(k.vertices());
      return {"m_e", {"m", std::to_string(v.value), vertex(), region_at(k, v)}};
    }
    case 5:
    case 6:
    case 7: {
      std::string circuits = circuit(k);
      if (chance(15)) circuits += " | " + circuit(k);
      return {
          "m_f",
          {"m", "\"" + circuits + "\"", chance(50) ? "None" : number<RegionId>(k.regions()), flag(), side(), items(k)}};
    }
    case 8: {
      const auto v = any<VertexId>(k.vertices());
      return {"m_rsfl", {"m", std::to_string(v.value), region_at(k, v), flag()}};
    }
    case 9:
      return {"mm_vl", {"m", face()}};
    case 10:
      return {"mm_ev", {"m", corner(k, any<FaceId>(k.faces()))}};
    case 11:
    case 12: {
      const auto f = any<FaceId>(k.faces());
      std::string moved;
      if (chance(30)) moved = number<LoopId>(k.loops(f));
      return {"mm_e", {"m", corner(k, f), corner(k, f), "[" + moved + "]"}};
    }
    case 13:
      return {"k_v", {"m", vertex()}};
    case 14:
    case 15:
      return {"k_e", {"m", edge(), chance(80) ? "None" : face()}};
    case 16:
    case 17:
      return {"k_f", {"m", face(), chance(70) ? "None" : number<RegionId>(k.regions())}};
    case 18:
      return {"g_v", {"m", vertex(), vertex()}};
    case 19: {
      const auto e = any<EdgeId>(k.edges());
      const auto gone = chance(60) ? any<EdgeEnd>(k.edge_ends(k.start(e))).edge : any<EdgeId>(k.edges());
      const auto after = [&](EdgeId of) {
        const auto c = any<CoedgeId>(k.coedges(of));
        return c.valid() && chance(80) ? std::to_string(c.value) : std::string("None");
      };
      return {
          "g_e",
          {"m", std::to_string(e.value), std::to_string(gone.value), after(e), after(gone), flag(), flag(), side()}};
    }
    case 20: {
      const auto f = any<FaceId>(k.faces()), gone = any<FaceId>(k.faces());
      std::string pairs;
      const auto of_kept = k.loops(f), of_gone = k.loops(gone);
      auto q = of_gone.begin();
      for (auto p = of_kept.begin(); p != of_kept.end() && q != of_gone.end(); ++p, ++q) {
        if (k.is_vertex_loop(*p) || k.is_vertex_loop(*q)) break;
        pairs += (pairs.empty() ? "(" : ", (") + std::to_string(k.first_coedge(*p).value) + ", " +
                 number<CoedgeId>(k.coedges(*q)) + ")";
      }
      return {"g_f", {"m", std::to_string(f.value), side(), std::to_string(gone.value), side(), "[" + pairs + "]"}};
    }
    case 21:
      return {"esplit", {"m", edge()}};
    default: {
      const auto e = any<EdgeId>(k.edges());
      return {"esqueeze", {"m", std::to_string(e.value), chance(50) ? "None" : std::to_string(k.end(e).value)}};
    }
  }
}

/// Another id, word or type than is wanted, or another number of arguments.
void ScriptWriter::spoil(Call& call) {
  static const char* const strange[] = {"None",
                                        "\"x\"",
                                        "1.5",
                                        "-1",
                                        "[1]",
                                        "True",
                                        "m",
                                        "99999999999",
                                        "4294967295",
                                        "4294967294",
                                        "2147483647",
                                        "1e300",
                                        "(1, 2)",
                                        "[]",
                                        "\"\"",
                                        "n",
                                        "\"e0 e0 -e0\"",
                                        "\"v0 v1\"",
                                        "\"e0 |\"",
                                        "\"c4294967295\"",
                                        "\"l0\"",
                                        "\"-\"",
                                        "\"@\"",
                                        "[(0,)]",
                                        "\"e0@\"",
                                        "[(0, 1), (0, 1)]"};
  static const char* const words[] = {"m_",  "k_v",  "k_f",   "m_f",  "mm_e",
                                      "g_f", "undo", "betti", "M_SV", "read_complex"};
  std::string& argument = call.arguments[below(call.arguments.size())];
  switch (below(7)) {
    case 0:
    case 1:
      argument = strange[below(std::size(strange))];
      return;
    case 2:
    case 3:
      argument = std::to_string(below(30));
      return;
    case 4:
      call.name = words[below(std::size(words))];
      return;
    case 5:
      call.arguments.pop_back();
      return;
    default:
      call.arguments.push_back(chance(50) ? "7" : "region=0");
  }
}

}  // namespace aresta::test
