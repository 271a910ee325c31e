// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "base/files.h"
#include "exchange/errors.h"
#include "exchange/mesh_formats.h"
#include "exchange/mesh_formats_msh.h"
#include "exchange/mesh_formats_text.h"

namespace aresta {

namespace {

using namespace mesh_formats;

/// Words of a text, with the line for messages. The first failure sticks; afterwards everything reads as zero.
class Words {
 public:
  explicit Words(const std::string& text) : text_(text) {}

  bool at_end() {
    skip_space();
    return at_ >= text_.size();
  }
  std::string_view word() {
    skip_space();
    const std::size_t start = at_;
    while (at_ < text_.size() && !is_space(text_[at_])) ++at_;
    if (start == at_) fail("the file ends too early");
    return std::string_view(text_).substr(start, at_ - start);
  }
  template <class T>
  T number() {
    const std::string_view w = word();
    T value{};
    const auto end = std::from_chars(w.data(), w.data() + w.size(), value);
    if (!failed() && (end.ec != std::errc() || end.ptr != w.data() + w.size()))
      fail("expected a number instead of " + std::string(w.substr(0, 40)));
    return failed() ? T{} : value;
  }
  /// A count of things that take at least `least` characters each: a wrong one is caught before memory is asked for.
  std::size_t count(std::size_t least) {
    const auto n = number<std::int64_t>();
    if (n < 0 || static_cast<std::uint64_t>(n) > text_.size() / least + 1) fail("a count is out of range");
    return failed() ? 0 : static_cast<std::size_t>(n);
  }
  std::string quoted() {
    skip_space();
    const std::size_t end = at_ < text_.size() && text_[at_] == '"' ? text_.find('"', at_ + 1) : std::string::npos;
    if (end == std::string::npos) {
      fail("expected a name in quotation marks");
      return {};
    }
    std::string name = text_.substr(at_ + 1, end - at_ - 1);
    at_ = end + 1;
    return name;
  }
  void expect(std::string_view wanted) {
    if (word() != wanted) fail("expected " + std::string(wanted));
  }
  void skip_past(const std::string& wanted) {
    const std::size_t found = text_.find(wanted, at_);
    if (found == std::string::npos) return fail("missing " + wanted);
    while (at_ < found) line_ += text_[at_++] == '\n' ? 1 : 0;
    at_ += wanted.size();
  }
  void fail(const std::string& reason) {
    if (reason_.empty()) reason_ = "line " + std::to_string(line_) + ": " + reason;
    at_ = text_.size();
  }
  bool failed() const { return !reason_.empty(); }
  const std::string& reason() const { return reason_; }

 private:
  static bool is_space(char c) { return c == ' ' || c == '\n' || c == '\r' || c == '\t'; }
  void skip_space() {
    while (at_ < text_.size() && is_space(text_[at_])) line_ += text_[at_++] == '\n' ? 1 : 0;
  }

  const std::string& text_;
  std::size_t at_ = 0;
  int line_ = 1;
  std::string reason_;
};

class MshReader {
 public:
  explicit MshReader(const std::string& text) : words_(text) {}

  Result<Mesh> run() {
    words_.expect("$MeshFormat");
    const std::string_view version = words_.word();
    const bool v41 = version == "4.1";
    if (!v41 && version != "2.2")
      words_.fail("MSH version " + std::string(version.substr(0, 20)) + " is not read, only 2.2 and 4.1");
    if (words_.number<int>() != 0) words_.fail("binary MSH files are not read");
    words_.number<int>();
    words_.expect("$EndMeshFormat");
    while (!words_.failed() && !words_.at_end()) {
      const std::string section(words_.word());
      if (section == "$PhysicalNames") {
        names();
      } else if (section == "$Entities" && v41) {
        entities();
      } else if (section == "$Nodes") {
        v41 ? nodes41() : nodes22();
      } else if (section == "$Elements") {
        v41 ? elements41() : elements22();
      } else if (section.size() < 2 || section[0] != '$') {
        words_.fail("expected a section instead of " + section.substr(0, 40));
      } else {
        words_.skip_past("$End" + section.substr(1));
        continue;
      }
      words_.expect("$End" + section.substr(1));
    }
    if (words_.failed())
      return Error{errors::exchange_bad_mesh_file, "the MSH file cannot be read: " + words_.reason()};
    return finish();
  }

 private:
  void names() {
    const std::size_t count = words_.count(6);
    for (std::size_t i = 0; i < count; ++i) {
      const int dim = words_.number<int>(), number = words_.number<int>();
      names_[{number, dim}] = words_.quoted();
    }
  }

  EntityRef entity(int dim, std::int64_t tag) {
    if (dim < 0 || dim > 3 || tag < 1 || tag > 0x7fffffff) {
      words_.fail("an entity is out of range");
      return {};
    }
    return {static_cast<EntityKind>(dim), static_cast<std::uint32_t>(tag - 1)};
  }

  void entities() {
    std::size_t counts[4];
    for (auto& c : counts) c = words_.count(4);
    for (int dim = 0; dim < 4; ++dim) {
      for (std::size_t i = 0; i < counts[dim] && !words_.failed(); ++i) {
        const EntityRef e = entity(dim, words_.number<std::int64_t>());
        for (int k = 0; k < (dim == 0 ? 3 : 6); ++k) words_.number<double>();
        const std::size_t groups = words_.count(2);
        for (std::size_t k = 0; k < groups; ++k) member(e, words_.number<int>());
        if (dim == 0) continue;
        const std::size_t bounds = words_.count(2);
        for (std::size_t k = 0; k < bounds; ++k) words_.number<std::int64_t>();
      }
    }
  }

  void member(EntityRef e, int group) {
    if (group != 0) members_[{group, static_cast<int>(e.kind)}].insert(e);
  }

  void add_node(std::int64_t tag, Vec3 p) {
    if (!is_finite(p)) return words_.fail("a coordinate is not a finite number");
    nodes_.emplace_back(tag, p);
  }

  void nodes41() {
    const std::size_t blocks = words_.count(4);
    words_.count(4), words_.number<std::int64_t>(), words_.number<std::int64_t>();
    for (std::size_t b = 0; b < blocks && !words_.failed(); ++b) {
      words_.number<int>(), words_.number<int>();
      const bool parametric = words_.number<int>() != 0;
      if (parametric) return words_.fail("nodes with parameters are not read");
      std::vector<std::int64_t> tags(words_.count(4));
      for (auto& t : tags) t = words_.number<std::int64_t>();
      for (const auto t : tags) add_node(t, point());
    }
  }

  void nodes22() {
    const std::size_t count = words_.count(8);
    for (std::size_t i = 0; i < count && !words_.failed(); ++i) {
      const auto tag = words_.number<std::int64_t>();
      add_node(tag, point());
    }
  }

  Vec3 point() {
    const double x = words_.number<double>(), y = words_.number<double>(), z = words_.number<double>();
    return {x, y, z};
  }

  std::optional<ElementType> type_of(int number) {
    for (int t = 0; t <= static_cast<int>(ElementType::hexa20); ++t) {
      if (msh_type(static_cast<ElementType>(t)) == number) return static_cast<ElementType>(t);
    }
    words_.fail("element type " + std::to_string(number) + " is not read");
    return {};
  }

  std::vector<std::int64_t> element_nodes(ElementType type) {
    const auto count = static_cast<std::size_t>(node_count(type));
    const auto order = msh_order(type);
    std::vector<std::int64_t> nodes(count);
    for (std::size_t i = 0; i < count; ++i)
      nodes[order.empty() ? i : static_cast<std::size_t>(order[i])] = words_.number<std::int64_t>();
    return nodes;
  }

  void elements41() {
    const std::size_t blocks = words_.count(4);
    words_.count(4), words_.number<std::int64_t>(), words_.number<std::int64_t>();
    for (std::size_t b = 0; b < blocks && !words_.failed(); ++b) {
      const int dim = words_.number<int>();
      const EntityRef e = entity(dim, words_.number<std::int64_t>());
      const auto type = type_of(words_.number<int>());
      const std::size_t count = words_.count(4);
      if (!type) return;
      auto& list = elements_[{e, *type}];
      for (std::size_t i = 0; i < count && !words_.failed(); ++i) {
        words_.number<std::int64_t>();
        list.push_back(element_nodes(*type));
      }
    }
  }

  void elements22() {
    const std::size_t count = words_.count(6);
    std::set<std::pair<EntityRef, std::vector<std::int64_t>>> seen;  // elements are repeated for each of their groups
    for (std::size_t i = 0; i < count && !words_.failed(); ++i) {
      words_.number<std::int64_t>();
      const auto type = type_of(words_.number<int>());
      if (!type) return;
      const std::size_t tags = words_.count(2);
      if (tags < 2) return words_.fail("an element without entity");
      const int group = words_.number<int>();
      const EntityRef e = entity(dimension(*type), words_.number<std::int64_t>());
      for (std::size_t k = 2; k < tags; ++k) words_.number<std::int64_t>();
      auto nodes = element_nodes(*type);
      member(e, group);
      if (seen.emplace(e, nodes).second) elements_[{e, *type}].push_back(std::move(nodes));
    }
  }

  Result<Mesh> finish() {
    Mesh mesh;
    std::sort(nodes_.begin(), nodes_.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    for (const auto& [tag, p] : nodes_) mesh.nodes.push_back(p);
    const auto bad = [](const std::string& reason) {
      return Error{errors::exchange_bad_mesh_file, "the MSH file cannot be read: " + reason};
    };
    for (std::size_t i = 1; i < nodes_.size(); ++i) {
      if (nodes_[i].first == nodes_[i - 1].first)
        return bad("node " + std::to_string(nodes_[i].first) + " comes twice");
    }
    for (const auto& [key, list] : elements_) {
      ElementBlock block{key.second, key.first, {}};
      for (const auto& element : list) {
        for (const std::int64_t tag : element) {
          const auto found = std::lower_bound(nodes_.begin(), nodes_.end(), tag,
                                              [](const auto& n, std::int64_t t) { return n.first < t; });
          if (found == nodes_.end() || found->first != tag)
            return bad("an element names node " + std::to_string(tag) + ", which does not exist");
          block.nodes.push_back(static_cast<std::uint32_t>(found - nodes_.begin()));
        }
      }
      mesh.blocks.push_back(std::move(block));
    }
    for (const auto& [key, entities] : members_) {
      const auto named = names_.find(key);
      const std::string name = named != names_.end() ? named->second : "group_" + std::to_string(key.first);
      if (entities.size() == 1 && name == made_up_name(*entities.begin())) continue;
      auto set = std::find_if(mesh.sets.begin(), mesh.sets.end(), [&](const MeshSet& s) { return s.name == name; });
      if (set == mesh.sets.end()) set = mesh.sets.insert(set, MeshSet{name, {}});
      set->entities.insert(set->entities.end(), entities.begin(), entities.end());
      std::sort(set->entities.begin(), set->entities.end());
    }
    return mesh;
  }

  Words words_;
  std::map<std::pair<int, int>, std::string> names_;            // by number and dimension
  std::map<std::pair<int, int>, std::set<EntityRef>> members_;  // by number and dimension
  std::vector<std::pair<std::int64_t, Vec3>> nodes_;
  std::map<std::pair<EntityRef, ElementType>, std::vector<std::vector<std::int64_t>>> elements_;
};

}  // namespace

Result<Mesh> from_msh(const std::string& text) {
  return MshReader(text).run();
}

Result<Mesh> read_msh(const std::string& path) {
  ARESTA_TRY(const std::string text, read_file(path));
  return from_msh(text);
}

}  // namespace aresta
