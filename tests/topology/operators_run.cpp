// SPDX-License-Identifier: Apache-2.0
#include "operators_run.h"

#include <set>

#include "random_operators.h"
#include "topology/check.h"
#include "topology/dump.h"

namespace aresta {

namespace {

/// Cells as they are found by walking, not as they are counted by the complex.
struct Walked {
  int vertices = 0, edges = 0, faces = 0, loops = 0, shells = 0, regions = 0;
  int chi = 0;  ///< V - E + the sum over faces of 2 - (loops of the face)

  explicit Walked(const Complex& k) {
    for ([[maybe_unused]] const VertexId v : k.vertices()) ++vertices;
    for ([[maybe_unused]] const EdgeId e : k.edges()) ++edges;
    chi = vertices - edges;
    for (const FaceId f : k.faces()) {
      ++faces;
      const auto of_face = static_cast<int>(k.loops(f).count());
      loops += of_face;
      chi += 2 - of_face;
    }
    for (const RegionId r : k.regions()) {
      ++regions;
      shells += static_cast<int>(k.shells(r).count());
    }
  }

  bool follows(const Walked& before, const CountChange& d) const {
    const CountChange walked{vertices - before.vertices, edges - before.edges,   faces - before.faces,
                             loops - before.loops,       shells - before.shells, regions - before.regions};
    return walked == d && chi - before.chi == d.vertices - d.edges + 2 * d.faces - d.loops;
  }
};

/// The names of sub-cases say what was made and killed; every letter must be true.
bool says_the_change(const std::string& sub_case, const CountChange& d) {
  int direction = 0;
  for (const char c : sub_case) {
    int change = 0;
    switch (c) {
      case 'm':
        direction = 1;
        continue;
      case 'k':
        direction = -1;
        continue;
      case 'v':
        if (direction == 0) continue;  // of "gv"
        change = d.vertices;
        break;
      case 'e':
        if (direction == 0) continue;
        change = d.edges;
        break;
      case 'f':
        if (direction == 0) continue;
        change = d.faces;
        break;
      case 'l':
        change = d.loops;
        break;
      case 's':
        change = d.shells;
        break;
      case 'r':
        change = d.regions;
        break;
      default:
        continue;
    }
    if (change * direction <= 0) return false;
  }
  return true;
}

/// How many voids faces enclose, over the field of two elements: faces less the rank of their boundaries.
std::size_t voids(const Complex& k) {
  std::map<EdgeId, std::set<EdgeId>> rows;  // by their first edge
  std::size_t found = 0;
  const auto add = [](std::set<EdgeId>& sum, EdgeId e) {
    if (!sum.erase(e)) sum.insert(e);
  };
  for (const FaceId f : k.faces()) {
    std::set<EdgeId> boundary;
    for (const LoopId l : k.loops(f)) {
      for (const CoedgeId c : k.coedges(l)) add(boundary, k.edge(c));
    }
    while (!boundary.empty()) {
      const auto [at, fresh] = rows.try_emplace(*boundary.begin(), boundary);
      if (fresh) break;
      const std::set<EdgeId> row = at->second;
      for (const EdgeId e : row) add(boundary, e);
    }
    found += boundary.empty();
  }
  return found;
}

/// What lies in space divides it into one region more than it encloses voids (J. W. Alexander, 1922).
bool has_no_place_in_space(const Complex& k) {
  return voids(k) + 1 != k.region_count();
}

bool kills(const Applied& applied) {
  return applied.name[0] == 'K';
}

class Run {
 public:
  Run(Complex start, std::string name, std::uint64_t seed, OperatorsTally& tally)
      : k_(std::move(start)), name_(std::move(name)), seed_(seed), random_(seed), tally_(tally) {
    dumps_.push_back(dump(k_));
    displaced_ = has_no_place_in_space(k_);
  }

  void forth(std::size_t applications) {
    for (std::size_t tries = 0; going_ && history_.size() < applications && tries < 8 * applications; ++tries) step();
  }

  void back() {
    while (tally_.wrong.empty() && !history_.empty()) {
      take_back(k_, history_.back());
      history_.pop_back();
      dumps_.pop_back();
      if (dump(k_) != dumps_.back())
        wrong("step " + std::to_string(history_.size()) + " taken back gives another dump");
    }
  }

 private:
  void step() {
    const Walked before(k_);
    auto applied = random_.apply(k_);
    std::string now = dump(k_);
    if (!applied) {
      ++tally_.refused;
      const std::string& tried = random_.tried();
      ++tally_.refusals[tried.substr(0, tried.find(' ')) + " " + random_.refusal()->code.name];
      if (now != dumps_.back()) wrong("refused, and the complex has changed");
      return;
    }
    ++tally_.applied;
    ++tally_.sub_cases[applied->name + " " + applied->sub_case];
    check(*applied, before, now);
    history_.push_back(std::move(*applied));
    dumps_.push_back(std::move(now));
    if (!tally_.wrong.empty()) return;
    take_back(k_, history_.back());
    if (dump(k_) != dumps_[dumps_.size() - 2]) wrong("taken back gives another dump");
    make_again(k_, history_.back());
    if (dump(k_) != dumps_.back()) wrong("made again gives another dump");
  }

  void check(const Applied& applied, const Walked& before, const std::string& now) {
    const std::string what = applied.sub_case + ": ";
    if (!Walked(k_).follows(before, applied.change)) wrong(what + "counts did not change as it says\nafter\n" + now);
    if (!says_the_change(applied.sub_case, applied.change)) wrong(what + "is not what has changed\nafter\n" + now);
    const auto findings = check_structure(k_, StructureLevel::full);
    if (findings.empty()) {
      if (!displaced_ && has_no_place_in_space(k_)) {
        displaced_ = true;
        ++tally_.displaced[applied.name + " " + applied.sub_case];
      }
      return;
    }
    // Findings of the structure come alone; only where it is whole is space looked at.
    Complex earlier = k_;
    Applied again = applied;
    take_back(earlier, again);
    for (const auto& finding : findings) {
      // A closed surface that bounds nothing is found when it is made; a region that it divides when a face of it goes.
      if (std::holds_alternative<structure::SurfaceBoundsNothing>(finding) && has_no_place_in_space(k_)) continue;
      if (kills(applied) && std::holds_alternative<structure::RegionDivided>(finding) &&
          has_no_place_in_space(earlier)) {
        continue;
      }
      return wrong(what + describe(finding) + "\nafter\n" + now);
    }
    ++tally_.no_space;
    ++tally_.ended[applied.name + " " + applied.sub_case];
    going_ = false;
  }

  void wrong(const std::string& message) {
    tally_.wrong.push_back("from " + name_ + ", seed " + std::to_string(seed_) + ": " + random_.tried() + ": " +
                           message + "\nbefore\n" + dumps_.back());
    going_ = false;
  }

  Complex k_;
  std::string name_;
  std::uint64_t seed_;
  RandomOperators random_;
  OperatorsTally& tally_;
  std::vector<Applied> history_;
  std::vector<std::string> dumps_;
  bool going_ = true, displaced_ = false;
};

}  // namespace

void run_random_operators(Complex start, const std::string& name, std::uint64_t seed, std::size_t applications,
                          OperatorsTally& tally) {
  Run run(std::move(start), name, seed, tally);
  run.forth(applications);
  run.back();
}

std::string OperatorsTally::histogram() const {
  std::string text;
  const auto add = [&](const char* prefix, const std::map<std::string, std::size_t>& counts) {
    for (const auto& [what, count] : counts) text += prefix + what + ": " + std::to_string(count) + "\n";
  };
  add("", sub_cases);
  add("refused ", refusals);
  add("no place in space after ", displaced);
  add("run ended for want of space by ", ended);
  return text;
}

}  // namespace aresta
