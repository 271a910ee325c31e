// SPDX-License-Identifier: Apache-2.0
#include "topology/notation.h"

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "topology/assemble.h"
#include "topology/check.h"
#include "topology/lexer.h"

namespace aresta {

namespace {

constexpr std::uint32_t none = Incidence::none;

bool is_name(std::string_view text) {
  const auto is_letter = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
  };
  return !text.empty() && std::all_of(text.begin(), text.end(), is_letter);
}

/// A vertex and the suffix of the edge that leaves from it.
struct Step {
  Word word;
  std::string_view vertex, suffix;
  bool has_suffix = false, backwards = false;
};

/// A name with a sign and an index, as in +f.1.
struct SignedName {
  Word word;
  std::string_view name;
  char sign = 0;
  std::uint32_t index = none;
};

// The lines, as they are written.
struct FaceLine {
  Word name;
  std::vector<std::vector<Step>> loops;
};
struct WireLine {
  std::vector<Step> steps;
  std::optional<Word> region;
};
struct PointLine {
  std::vector<Word> vertices;
  std::optional<Word> region;
};
struct AboutLine {
  Step from, to;
  std::vector<SignedName> uses;
};
struct RegionLine {
  Word name;
  bool filled = false;
  std::vector<SignedName> sides;
};
struct Lines {
  std::vector<FaceLine> faces;
  std::vector<WireLine> wires;
  std::vector<PointLine> points;
  std::vector<AboutLine> abouts;
  std::vector<RegionLine> regions;
};

class Reader : WordReader {
 public:
  explicit Reader(std::string_view text) : WordReader(text, errors::bad_notation) {}

  Result<Lines> run() {
    while (!failed() && !lexer_.word().text.empty()) {
      if (accept("wire")) {
        read_wire();
      } else if (accept("point")) {
        read_point();
      } else if (accept("about")) {
        read_about();
      } else if (accept("region")) {
        read_region();
      } else {
        read_face();
      }
      if (!accept("\n")) fail("the end of the line");
    }
    if (error_) return *std::move(error_);
    return std::move(lines_);
  }

 private:
  bool at_end() const { return failed() || lexer_.word().ends_line(); }

  Word name(std::string_view wanted) {
    if (!failed() && is_name(lexer_.word().text)) return lexer_.take();
    fail(wanted);
    return {};
  }

  Step step() {
    Step result;
    result.word = lexer_.word();
    std::string_view text = result.word.text;
    if (text.size() > 1 && text.back() == '-') {
      result.backwards = true;
      text.remove_suffix(1);
    }
    const std::size_t dot = text.find('.');
    result.vertex = text.substr(0, dot);
    result.suffix = "0";
    if (dot != std::string_view::npos) {
      result.has_suffix = true;
      result.suffix = text.substr(dot + 1);
    }
    if (!is_name(result.vertex) || !is_name(result.suffix)) fail("a vertex, as in 5, a, a.1 or a.1-,");
    if (!failed()) lexer_.take();
    return result;
  }

  SignedName signed_name(std::string_view wanted) {
    SignedName result;
    result.word = lexer_.word();
    std::string_view text = result.word.text;
    if (!text.empty() && (text[0] == '+' || text[0] == '-')) {
      result.sign = text[0];
      text.remove_prefix(1);
    }
    const std::size_t dot = text.find('.');
    result.name = text.substr(0, dot);
    const bool is_index = dot == std::string_view::npos ||
                          (result.sign != 0 && read_number(text.substr(dot + 1), none - 1, &result.index));
    if (!is_name(result.name) || !is_index) fail(wanted);
    if (!failed()) lexer_.take();
    return result;
  }

  std::optional<Word> in_region() {
    if (!accept("in")) return {};
    return name("the name of a region");
  }

  void read_face() {
    FaceLine line;
    line.name = name("a face's name, 'wire', 'point', 'about' or 'region'");
    expect(":");
    do {
      auto& loop = line.loops.emplace_back();
      do {
        loop.push_back(step());
      } while (!at_end() && !is("|"));
    } while (accept("|"));
    lines_.faces.push_back(std::move(line));
  }

  void read_wire() {
    WireLine line;
    do {
      line.steps.push_back(step());
    } while (!at_end() && !is("in"));
    if (line.steps.size() < 2) fail("another vertex");
    line.region = in_region();
    lines_.wires.push_back(std::move(line));
  }

  void read_point() {
    PointLine line;
    do {
      line.vertices.push_back(name("the name of a vertex"));
    } while (!at_end() && !is("in"));
    line.region = in_region();
    lines_.points.push_back(std::move(line));
  }

  void read_about() {
    AboutLine line;
    line.from = step();
    line.to = step();
    expect(":");
    do {
      line.uses.push_back(signed_name("a face, as in f, +f, -f or +f.1,"));
    } while (!at_end());
    lines_.abouts.push_back(std::move(line));
  }

  void read_region() {
    RegionLine line;
    line.name = name("the name of a region");
    line.filled = is("filled");
    if (!accept("filled") && !accept("empty")) fail("'filled' or 'empty'");
    expect(":");
    do {
      SignedName side = signed_name("a side of a face, as in +f or -f,");
      if (!failed() && (side.sign == 0 || side.index != none)) {
        error_ = Error{errors::bad_notation, not_as_expected("a side of a face, as in +f or -f,", side.word)};
      }
      line.sides.push_back(side);
    } while (!at_end());
    lines_.regions.push_back(std::move(line));
  }

  Lines lines_;
};

Error wrong(std::uint32_t line, const std::string& message) {
  return Error{errors::notation_model, at_line(line) + message};
}

/// Finds by name what the lines speak of and makes flat arrays of it.
class Builder {
 public:
  explicit Builder(const Lines& lines) : lines_(lines) {}

  Result<Incidence> run() {
    ARESTA_CHECK(add_regions());
    ARESTA_CHECK(add_faces());
    ARESTA_CHECK(add_wires());
    ARESTA_CHECK(add_points());
    in_.vertex_count = static_cast<std::uint32_t>(vertices_.size());
    ARESTA_CHECK(order_uses());
    ARESTA_CHECK(assign_sides());
    renumber_vertices();
    return std::move(in_);
  }

 private:
  using EdgeKey = std::tuple<std::uint32_t, std::uint32_t, std::string_view>;
  struct EdgeUse {
    std::uint32_t edge;
    bool reversed;
  };

  std::uint32_t vertex(std::string_view name) {
    const auto [at, fresh] = vertices_.emplace(name, static_cast<std::uint32_t>(vertices_.size()));
    if (fresh) {
      names_.push_back(name);
      in_.vertex_region.push_back(none);
      is_used_.push_back(false);
    }
    return at->second;
  }

  static EdgeKey key(std::uint32_t from, std::uint32_t to, std::string_view suffix) {
    return {std::min(from, to), std::max(from, to), suffix};
  }

  Result<EdgeUse> edge(const Step& step, const Step& next) {
    const std::uint32_t from = vertex(step.vertex), to = vertex(next.vertex);
    if (step.backwards && from != to) {
      return wrong(step.word.line, shown(step.word) + ": only a closed edge is run backwards by '-'");
    }
    const auto [at, fresh] = edges_.emplace(key(from, to, step.suffix), in_.edge_count());
    if (fresh) {
      in_.edges.push_back({from, to});
      in_.edge_region.push_back(none);
    }
    return EdgeUse{at->second, step.backwards || in_.edges[at->second][0] != from};
  }

  Status add_regions() {
    in_.region_filled = {false};
    for (const RegionLine& line : lines_.regions) {
      if (!regions_.emplace(line.name.text, in_.region_count).second) {
        return wrong(line.name.line, "there is a region " + shown(line.name) + " already");
      }
      ++in_.region_count;
      in_.region_filled.push_back(line.filled);
    }
    return {};
  }

  Result<std::uint32_t> region(const std::optional<Word>& name) const {
    if (!name) return 0u;
    const auto at = regions_.find(name->text);
    if (at == regions_.end()) return wrong(name->line, "there is no region " + shown(*name));
    return at->second;
  }

  Status add_faces() {
    for (const FaceLine& line : lines_.faces) {
      if (!faces_.emplace(line.name.text, in_.face_count()).second) {
        return wrong(line.name.line, "there is a face " + shown(line.name) + " already");
      }
      for (const auto& loop : line.loops) {
        if (loop.size() == 1 && !loop[0].has_suffix && !loop[0].backwards) {
          in_.add_vertex_loop(vertex(loop[0].vertex));
          is_used_[in_.loop_vertex.back()] = true;
          continue;
        }
        for (std::size_t i = 0; i < loop.size(); ++i) {
          ARESTA_TRY(const EdgeUse use, edge(loop[i], loop[(i + 1) % loop.size()]));
          in_.add_coedge(use.edge, use.reversed);
        }
        in_.close_loop();
      }
      in_.close_face();
    }
    return {};
  }

  Status add_wires() {
    std::vector<bool> is_taken(in_.edge_count(), true);
    for (const WireLine& line : lines_.wires) {
      std::uint32_t r = 0;
      ARESTA_TRY(r, region(line.region));
      for (std::size_t i = 0; i + 1 < line.steps.size(); ++i) {
        ARESTA_TRY(const EdgeUse use, edge(line.steps[i], line.steps[i + 1]));
        is_taken.resize(in_.edge_count(), false);
        if (is_taken[use.edge]) {
          return wrong(line.steps[i].word.line, "the edge from " + shown(line.steps[i].word) +
                                                    " is there already and can be no wire: give it another suffix");
        }
        is_taken[use.edge] = true;
        in_.edge_region[use.edge] = r;
      }
      if (line.steps.back().has_suffix || line.steps.back().backwards) {
        return wrong(line.steps.back().word.line,
                     shown(line.steps.back().word) + ": no edge leaves from a last vertex");
      }
    }
    return {};
  }

  Status add_points() {
    for (const auto& ends : in_.edges) {
      for (const std::uint32_t v : ends) is_used_[v] = true;
    }
    for (const PointLine& line : lines_.points) {
      std::uint32_t r = 0;
      ARESTA_TRY(r, region(line.region));
      for (const Word& word : line.vertices) {
        const std::uint32_t v = vertex(word.text);
        if (is_used_[v]) return wrong(word.line, "the vertex " + shown(word) + " is used already and is not isolated");
        is_used_[v] = true;
        in_.vertex_region[v] = r;
      }
    }
    return {};
  }

  /// Uses of edges, sorted so that those which a word may mean are together.
  struct Use {
    std::uint32_t edge, face;
    bool reversed;
    std::uint32_t coedge;
    auto operator<=>(const Use&) const = default;
  };

  std::vector<Use> sorted_uses() const {
    std::vector<Use> uses;
    const auto face = face_of_loop(in_), loop = loop_of_coedge(in_);
    for (std::uint32_t c = 0; c < in_.coedges.size(); ++c) {
      uses.push_back({in_.coedges[c] >> 1, face[loop[c]], (in_.coedges[c] & 1u) != 0, c});
    }
    std::sort(uses.begin(), uses.end());
    return uses;
  }

  std::string edge_name(std::uint32_t e) const {
    return std::string(names_[in_.edges[e][0]]) + " " + std::string(names_[in_.edges[e][1]]);
  }

  Status order_uses() {
    const auto uses = sorted_uses();
    in_.radial_next.assign(in_.coedges.size(), none);
    std::vector<bool> is_ordered(in_.edge_count(), false);
    for (const AboutLine& line : lines_.abouts) ARESTA_CHECK(order_about(line, uses, is_ordered));
    for (std::size_t i = 0, j; i < uses.size(); i = j) {
      const std::uint32_t e = uses[i].edge;
      for (j = i; j < uses.size() && uses[j].edge == e;) ++j;
      if (is_ordered[e]) continue;
      if (j - i > 2) {
        return wrong(lines_.faces[uses[i].face].name.line, "the edge " + edge_name(e) + " has " +
                                                               std::to_string(j - i) +
                                                               " uses: a line 'about' has to say their order");
      }
      for (std::size_t n = i; n < j; ++n) in_.radial_next[uses[n].coedge] = uses[n + 1 < j ? n + 1 : i].coedge;
    }
    return {};
  }

  Status order_about(const AboutLine& line, const std::vector<Use>& uses, std::vector<bool>& is_ordered) {
    const std::uint32_t number = line.from.word.line;
    const auto from = vertices_.find(line.from.vertex), to = vertices_.find(line.to.vertex);
    const bool known = from != vertices_.end() && to != vertices_.end();
    const auto at = known ? edges_.find(key(from->second, to->second, line.from.suffix)) : edges_.end();
    if (at == edges_.end()) {
      return wrong(number, "there is no edge from " + shown(line.from.word) + " to " + shown(line.to.word));
    }
    if (line.to.has_suffix || line.to.backwards || (line.from.backwards && from->second != to->second)) {
      return wrong(number, "an edge is named by a step and a vertex, as in a.1 b");
    }
    const std::uint32_t e = at->second;
    if (is_ordered[e]) return wrong(number, "the uses of " + edge_name(e) + " are ordered already");
    is_ordered[e] = true;
    const bool flipped = line.from.backwards || in_.edges[e][0] != from->second;

    std::vector<std::uint32_t> order;
    for (const SignedName& name : line.uses) {
      const auto f = faces_.find(name.name);
      if (f == faces_.end()) return wrong(name.word.line, "there is no face " + shown(name.word));
      const bool reversed = (name.sign == '-') != flipped;
      auto first = std::lower_bound(uses.begin(), uses.end(), Use{e, f->second, name.sign != 0 && reversed, 0});
      auto last = std::upper_bound(first, uses.end(), Use{e, f->second, name.sign == 0 || reversed, none});
      if (name.index != none && name.index < static_cast<std::size_t>(last - first)) {
        first += name.index;
        last = first + 1;
      }
      if (last - first != 1) {
        return wrong(name.word.line, shown(name.word) + " means " + (first == last ? "no use" : "several uses") +
                                         " of " + edge_name(e));
      }
      if (in_.radial_next[first->coedge] != none) {
        return wrong(name.word.line, shown(name.word) + " comes twice about " + edge_name(e));
      }
      in_.radial_next[first->coedge] = first->coedge;
      order.push_back(first->coedge);
    }
    const auto first = std::lower_bound(uses.begin(), uses.end(), Use{e, 0, false, 0});
    const auto last = std::upper_bound(first, uses.end(), Use{e, none, true, none});
    if (order.size() != static_cast<std::size_t>(last - first)) {
      return wrong(number, "about " + edge_name(e) + " there are " + std::to_string(last - first) + " uses, not " +
                               std::to_string(order.size()));
    }
    if (flipped) std::reverse(order.begin(), order.end());
    for (std::size_t i = 0; i < order.size(); ++i) in_.radial_next[order[i]] = order[(i + 1) % order.size()];
    return {};
  }

  Status assign_sides() {
    const auto component = side_components(in_);
    std::vector<std::uint32_t> region_of(component.size(), none);
    for (std::uint32_t r = 1; r < in_.region_count; ++r) {
      for (const SignedName& side : lines_.regions[r - 1].sides) {
        const auto f = faces_.find(side.name);
        if (f == faces_.end()) return wrong(side.word.line, "there is no face " + shown(side.word));
        std::uint32_t& region = region_of[component[2 * f->second + (side.sign == '-' ? 1 : 0)]];
        if (region != none && region != r) {
          return wrong(side.word.line,
                       shown(side.word) + " is joined to sides of region " + shown(lines_.regions[region - 1].name));
        }
        region = r;
      }
    }
    for (const std::uint32_t c : component) in_.face_use_region.push_back(region_of[c] == none ? 0 : region_of[c]);
    return {};
  }

  void renumber_vertices() {
    std::vector<std::uint32_t> id(names_.size());
    std::vector<bool> is_taken(names_.size(), false);
    for (std::size_t v = 0; v < names_.size(); ++v) {
      if (!read_number(names_[v], none, &id[v]) || id[v] >= id.size() || is_taken[id[v]]) return;
      is_taken[id[v]] = true;
    }
    for (auto& ends : in_.edges) ends = {id[ends[0]], id[ends[1]]};
    for (auto& v : in_.loop_vertex) v = v == none ? none : id[v];
    auto region = in_.vertex_region;
    for (std::size_t v = 0; v < id.size(); ++v) region[id[v]] = in_.vertex_region[v];
    in_.vertex_region = std::move(region);
  }

  const Lines& lines_;
  Incidence in_;
  std::vector<std::string_view> names_;  ///< of vertices
  std::map<std::string_view, std::uint32_t> vertices_, faces_, regions_;
  std::map<EdgeKey, std::uint32_t> edges_;
  std::vector<bool> is_used_;  ///< per vertex
};

}  // namespace

Result<Complex> parse_notation(std::string_view text) {
  ARESTA_TRY(const Lines lines, Reader(text).run());
  ARESTA_TRY(const Incidence incidence, Builder(lines).run());
  ARESTA_TRY(Complex k, assemble(incidence));
  const auto findings = check_structure(k, StructureLevel::shells);
  if (!findings.empty()) return Error{errors::notation_model, describe(findings.front())};
  return k;
}

}  // namespace aresta
