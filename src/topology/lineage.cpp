// SPDX-License-Identifier: Apache-2.0
#include "topology/lineage.h"

#include <algorithm>
#include <map>

namespace aresta {

namespace {

using Kind = LineageEvent::Kind;

std::string name_of(EntityRef e) {
  return std::string(to_string(e.kind)) + " " + std::to_string(e.index);
}

/// Collects the events of a change made forwards.
struct Reader {
  std::vector<LineageEvent> events;

  void made(EntityRef e, EntityRef on = {}) { events.push_back({Kind::made, e, on}); }
  void killed(EntityRef e) { events.push_back({Kind::killed, e, {}}); }
  void split(EntityRef old, EntityRef piece) { events.push_back({Kind::split, old, piece}); }
  void merged(EntityRef gone, EntityRef kept) { events.push_back({Kind::merged, gone, kept}); }

  void operator()(const PointChange& x) { made(x.vertex); }
  void operator()(const WireChange& x) { made(x.edge); }
  void operator()(const FaceChange& x) {
    made(x.face);
    if (x.division.region.valid()) split(x.region, x.division.region);
  }
  void operator()(const LoopPointChange& x) { made(x.vertex); }
  void operator()(const AcrossChange& x) {
    made(x.edge);
    split(x.face, x.new_face);
  }
  void operator()(const JoiningChange& x) { made(x.edge); }
  void operator()(const VertexMergeChange& x) {
    if (x.split_of.valid()) {
      killed(x.gone);
      merged(x.edge, x.split_of);
      return;
    }
    if (x.edge.valid()) killed(x.edge);
    merged(x.gone, x.kept);
  }
  void operator()(const EdgeMergeChange& x) {
    merged(x.gone, x.kept);
    if (x.division.region.valid()) split(x.division.of, x.division.region);
  }
  void operator()(const DigonChange& x) {
    killed(x.face);
    merged(x.gone, x.kept);
  }
  void operator()(const FaceMergeChange& x) {
    killed(x.region);
    merged(x.gone, x.kept);
  }
};

LineageEvent reverse_of(const LineageEvent& event) {
  switch (event.kind) {
    case Kind::made:
      return {Kind::killed, event.entity, {}};
    case Kind::killed:
      return {Kind::made, event.entity, {}};
    case Kind::split:
      return {Kind::merged, event.other, event.entity};
    case Kind::merged:
      break;
  }
  return {Kind::split, event.other, event.entity};
}

/// An entity from its first to its last mention. An id that is killed and used again is two of them.
struct Life {
  static constexpr std::size_t none = ~std::size_t{0};
  EntityRef entity;
  bool is_new = false;               ///< came within the events
  bool is_over = false;              ///< went within the events
  std::size_t from = none;           ///< new, a piece of this one
  std::size_t into = none;           ///< over, gone into this one
  std::vector<std::size_t> went_in;  ///< that were to appear as gone into this one, which does not appear itself

  bool appears() const { return !(is_new && is_over); }
};

}  // namespace

std::string describe(const LineageEvent& event) {
  switch (event.kind) {
    case Kind::made:
      return "made " + name_of(event.entity);
    case Kind::killed:
      return "killed " + name_of(event.entity);
    case Kind::split:
      return "split " + name_of(event.entity) + " -> " + name_of(event.other);
    case Kind::merged:
      break;
  }
  return "merged " + name_of(event.entity) + " -> " + name_of(event.other);
}

std::vector<LineageEvent> lineage(const Change& change) {
  Reader reader;
  std::visit(reader, change.what);
  if (!change.reversed) return std::move(reader.events);
  std::vector<LineageEvent> events;
  for (auto e = reader.events.rbegin(); e != reader.events.rend(); ++e) events.push_back(reverse_of(*e));
  // A point in the middle of an edge says where it lies.
  if (const auto* x = std::get_if<VertexMergeChange>(&change.what); x != nullptr && x->split_of.valid()) {
    for (LineageEvent& e : events) {
      if (e.kind == Kind::made) e.other = x->split_of;
    }
  }
  return events;
}

std::vector<LineageEvent> net_effect(std::span<const LineageEvent> events) {
  // First the lives, then the events again with those of lives that do not appear passed on.
  std::vector<Life> lives;
  std::map<EntityRef, std::size_t> current;
  const auto life_of = [&](EntityRef e) {
    const auto [at, is_first] = current.try_emplace(e, lives.size());
    if (is_first) lives.emplace_back().entity = e;
    return at->second;
  };
  const auto begin = [&](EntityRef e, std::size_t from) {
    current[e] = lives.size();
    lives.push_back({e, true, false, from, Life::none, {}});
    return lives.size() - 1;
  };
  struct Told {
    std::size_t entity, other = Life::none;
  };
  std::vector<Told> told;
  for (const LineageEvent& e : events) {
    switch (e.kind) {
      case Kind::made:
        told.push_back({begin(e.entity, Life::none), Life::none});
        break;
      case Kind::killed:
        told.push_back({life_of(e.entity), Life::none});
        lives[told.back().entity].is_over = true;
        current.erase(e.entity);
        break;
      case Kind::split: {
        const std::size_t old = life_of(e.entity);
        told.push_back({old, begin(e.other, old)});
        break;
      }
      case Kind::merged: {
        const std::size_t gone = life_of(e.entity), kept = life_of(e.other);
        told.push_back({gone, kept});
        lives[gone].is_over = true;
        lives[gone].into = kept;
        current.erase(e.entity);
        break;
      }
    }
  }

  // Where an entity ends: itself, what it went into at last, or nowhere.
  const auto end_of = [&](std::size_t i) {
    while (i != Life::none && lives[i].is_over) i = lives[i].into;
    return i;
  };
  std::vector<LineageEvent> result;
  const auto put = [&](Kind kind, std::size_t entity, std::size_t other) {
    result.push_back({kind, lives[entity].entity, other == Life::none ? EntityRef{} : lives[other].entity});
  };
  const auto go = [&](std::size_t gone, std::size_t kept) {
    if (!lives[kept].appears()) {
      lives[kept].went_in.push_back(gone);
    } else {
      put(end_of(kept) == Life::none ? Kind::killed : Kind::merged, gone,
          end_of(kept) == Life::none ? Life::none : kept);
    }
  };
  for (std::size_t i = 0; i < events.size(); ++i) {
    const auto [entity, other] = told[i];
    switch (events[i].kind) {
      case Kind::made:
        if (lives[entity].appears()) result.push_back(events[i]);
        break;
      case Kind::killed:
        for (const std::size_t gone : lives[entity].went_in) put(Kind::killed, gone, Life::none);
        if (lives[entity].appears()) put(Kind::killed, entity, Life::none);
        break;
      case Kind::split: {
        if (!lives[other].appears()) break;
        std::size_t old = entity;
        while (old != Life::none && !lives[old].appears()) old = lives[old].from;
        if (old == Life::none) {
          put(Kind::made, other, Life::none);
        } else {
          put(Kind::split, old, other);
        }
        break;
      }
      case Kind::merged:
        for (const std::size_t gone : lives[entity].went_in) go(gone, other);
        if (lives[entity].appears()) go(entity, other);
        break;
    }
  }
  return result;
}

std::vector<LineageEvent> lineage(const Applied& applied) {
  std::vector<LineageEvent> all;
  for (const Change& step : applied.steps) {
    const auto events = lineage(step);
    all.insert(all.end(), events.begin(), events.end());
  }
  return net_effect(all);
}

std::vector<LineageEvent> lineage_of_take_back(const Applied& applied) {
  std::vector<LineageEvent> all;
  for (auto step = applied.steps.rbegin(); step != applied.steps.rend(); ++step) {
    const auto events = lineage(Change{step->what, !step->reversed});
    all.insert(all.end(), events.begin(), events.end());
  }
  return net_effect(all);
}

}  // namespace aresta
