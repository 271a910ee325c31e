// SPDX-License-Identifier: Apache-2.0
// The last invariant of space: every closed surface bounds. With a number x for each face, a closed surface is a
// solution of, for each edge: the sum of x over its uses, with their senses, is 0. The boundary of a region is one, and
// in space there are no others but sums of these.
//
// Boundaries are set apart by x = 0 for the faces of a tree that links all regions; then no solution but 0 may be left.
// Edges with one unknown make it 0, edges with two make one a multiple of the other; this goes on as long as anything
// changes (solids and sheets come to nothing here, as when a surface is peeled off from a hole in it), in n log n.
// What is left is solved by elimination: cubic, but in the number of patches between edges of three and more of a part
// that cannot be peeled, of which common models have few or none.
//
// Numbers are residues modulo a large prime, so that closed sheets with one side, where x = -x, are no solutions.
#include <algorithm>
#include <deque>
#include <map>
#include <utility>

#include "topology/check_detail.h"
#include "topology/fans.h"

namespace aresta::check_detail {

namespace {

using Residue = std::uint64_t;
constexpr Residue prime = 2147483647;

Residue negative(Residue a) {
  return a == 0 ? 0 : prime - a;
}
Residue product(Residue a, Residue b) {
  return a * b % prime;
}
Residue inverse(Residue a) {
  if (a == 1 || a == prime - 1) return a;
  Residue result = 1;
  for (Residue power = prime - 2; power != 0; power >>= 1, a = product(a, a)) {
    if ((power & 1u) != 0) result = product(result, a);
  }
  return result;
}

/// An unknown, or the one that stands for a class of them, with its factor.
struct Term {
  std::uint32_t face = 0;
  Residue factor = 0;
};
/// A sum of terms that is 0, sorted by unknowns, each of which comes once.
using Equation = std::vector<Term>;

/// a + ratio * b
Equation combined(const Equation& a, Residue ratio, const Equation& b) {
  Equation result;
  auto x = a.begin();
  for (const Term& y : b) {
    for (; x != a.end() && x->face < y.face; ++x) result.push_back(*x);
    Residue factor = product(ratio, y.factor);
    if (x != a.end() && x->face == y.face) factor = (factor + (x++)->factor) % prime;
    if (factor != 0) result.push_back({y.face, factor});
  }
  result.insert(result.end(), x, a.end());
  return result;
}

class Surfaces {
 public:
  explicit Surfaces(const Complex& k)
      : k_(k),
        parent_(k.face_bound()),
        smallest_(k.face_bound()),
        is_zero_(k.face_bound(), false),
        edges_(k.face_bound()),
        waits_(k.edge_bound(), false) {
    for (std::uint32_t f = 0; f < parent_.size(); ++f) {
      parent_[f] = {f, 1};
      smallest_[f] = FaceId(f);
    }
    for (const CoedgeId c : k.coedges()) edges_[k.face(c).index()].push_back(k.edge(c));
  }

  void set_zero(FaceId f) { make_zero(find(f).face); }

  void peel() {
    for (const EdgeId e : k_.edges()) wait(e);
    while (!waiting_.empty()) {
      const EdgeId e = waiting_.front();
      waiting_.pop_front();
      waits_[e.index()] = false;
      equation(e, sum_);
      if (sum_.size() == 1) make_zero(sum_.front().face);
      if (sum_.size() == 2) join(sum_.front(), sum_.back());
    }
  }

  /// The smallest face of each unknown that is free.
  std::vector<FaceId> free_faces() {
    std::map<std::uint32_t, Equation> by_first;
    for (const EdgeId e : k_.edges()) {
      Equation sum;
      equation(e, sum);
      while (!sum.empty()) {
        const auto [pivot, fresh] = by_first.emplace(sum.front().face, sum);
        if (fresh) break;
        const Equation& other = pivot->second;
        sum = combined(sum, negative(product(sum.front().factor, inverse(other.front().factor))), other);
      }
    }
    std::vector<FaceId> result;
    for (const FaceId f : k_.faces()) {
      const std::uint32_t root = find(f).face;
      if (root == f.value && !is_zero_[root] && by_first.count(root) == 0) result.push_back(smallest_[root]);
    }
    return result;
  }

 private:
  /// The class of a face, and the factor of its unknown to that of the class.
  Term find(FaceId f) {
    std::uint32_t root = f.value;
    Residue factor = 1;
    for (; parent_[root].face != root; root = parent_[root].face) factor = product(factor, parent_[root].factor);
    // Then every link on the way leads there at once.
    const Term found{root, factor};
    for (std::uint32_t at = f.value; at != root;) {
      const Term link = parent_[at];
      parent_[at] = {root, factor};
      factor = product(factor, inverse(link.factor));
      at = link.face;
    }
    return found;
  }

  void equation(EdgeId e, Equation& sum) {
    sum.clear();
    for (const CoedgeId c : k_.coedges(e)) {
      const Term term = find(k_.face(c));
      if (!is_zero_[term.face]) sum.push_back({term.face, k_.reversed(c) ? negative(term.factor) : term.factor});
    }
    std::sort(sum.begin(), sum.end(), [](const Term& a, const Term& b) { return a.face < b.face; });
    std::size_t kept = 0;
    for (std::size_t i = 0; i < sum.size();) {
      Term term{sum[i].face, 0};
      for (; i < sum.size() && sum[i].face == term.face; ++i) term.factor = (term.factor + sum[i].factor) % prime;
      if (term.factor != 0) sum[kept++] = term;
    }
    sum.resize(kept);
  }

  void wait(EdgeId e) {
    if (waits_[e.index()]) return;
    waits_[e.index()] = true;
    waiting_.push_back(e);
  }

  void make_zero(std::uint32_t root) {
    is_zero_[root] = true;
    for (const EdgeId e : edges_[root]) wait(e);
    edges_[root].clear();
  }

  /// Two classes of which an edge says that a + b = 0 become one; the one with fewer edges joins the other.
  void join(Term a, Term b) {
    if (edges_[a.face].size() > edges_[b.face].size()) std::swap(a, b);
    parent_[a.face] = {b.face, negative(product(b.factor, inverse(a.factor)))};
    smallest_[b.face] = std::min(smallest_[a.face], smallest_[b.face]);
    for (const EdgeId e : edges_[a.face]) {
      wait(e);
      edges_[b.face].push_back(e);
    }
    edges_[a.face].clear();
  }

  const Complex& k_;
  std::vector<Term> parent_;
  std::vector<FaceId> smallest_;  ///< of the class
  std::vector<bool> is_zero_;
  std::vector<std::vector<EdgeId>> edges_;  ///< of the class; one may come several times
  std::deque<EdgeId> waiting_;
  std::vector<bool> waits_;
  Equation sum_;
};

}  // namespace

void check_voids(const Complex& k, Findings& findings) {
  Surfaces surfaces(k);
  UnionFind linked(k.region_bound());
  for (const FaceId f : k.faces()) {
    if (linked.unite(k.region(FaceUse(f, 0)).index(), k.region(FaceUse(f, 1)).index())) surfaces.set_zero(f);
  }
  surfaces.peel();
  for (const FaceId f : surfaces.free_faces()) findings.push_back(structure::SurfaceBoundsNothing{f});
}

}  // namespace aresta::check_detail
