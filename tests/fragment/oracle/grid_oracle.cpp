// SPDX-License-Identifier: Apache-2.0
// Fragments of random operands on a grid against an enumeration of the grid.
//
//   grid_oracle COUNT SEED [--engine NAME] [--rotated] [--plant FAULT] [--least N] [--checked] [--may-refuse]
//   grid_oracle --recipe FILE [--engine NAME] [--plant FAULT]
//
// Prints each failure as a recipe made as small as possible (which --recipe takes), how often operands met in which
// way, and last a line of figures. The status is 1 when a fragment is wrong or refused (--may-refuse: wrong), or some
// kind of contact occurred less than N times. --rotated turns each model by a rational rotation; --plant turns one
// decision of each fragment over (label, parent, sense, fill or piece), so that all must be wrong. With --checked a
// fragment that differs counts as refused when the full checker finds a defect in it.
#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <limits>
#include <sstream>

#include "fragment/oracle/contacts.h"
#include "fragment/oracle/random_recipe.h"
#include "fragment/oracle/trial.h"

using namespace aresta;
using namespace aresta::grid;

namespace {

struct Options {
  std::size_t count = 0;
  std::uint64_t seed = 0;
  std::string recipe_file;
  const FragmentEngine* engine = nullptr;
  bool rotated = false;
  bool checked = false;
  bool may_refuse = false;
  Fault fault = Fault::none;
  std::size_t least = 0;
};

constexpr std::size_t most_printed = 10;

/// Null: no such engine.
const FragmentEngine* engine_named(const std::string& name) {
  for (const FragmentEngine* engine : {&occt_engine(), &planar_engine()}) {
    if (name == engine->name()) return engine;
  }
  return nullptr;
}

std::optional<Options> parse(int count, char** arguments) {
  Options options;
  int plain = 0;
  for (int i = 1; i < count; ++i) {
    const std::string word = arguments[i];
    const bool has_value = i + 1 < count;
    if (word == "--rotated") {
      options.rotated = true;
    } else if (word == "--checked") {
      options.checked = true;
    } else if (word == "--may-refuse") {
      options.may_refuse = true;
    } else if (word == "--engine" && has_value) {
      options.engine = engine_named(arguments[++i]);
      if (options.engine == nullptr) return std::nullopt;
    } else if (word == "--plant" && has_value) {
      const auto fault = fault_named(arguments[++i]);
      if (!fault) return std::nullopt;
      options.fault = *fault;
    } else if (word == "--recipe" && has_value) {
      options.recipe_file = arguments[++i];
    } else if (word == "--least" && has_value) {
      options.least = std::strtoull(arguments[++i], nullptr, 10);
    } else if (plain < 2 && word.find_first_not_of("0123456789") == std::string::npos) {
      (plain++ == 0 ? options.count : options.seed) = std::strtoull(word.c_str(), nullptr, 10);
    } else {
      return std::nullopt;
    }
  }
  if (plain != (options.recipe_file.empty() ? 2 : 0)) return std::nullopt;
  return options;
}

void print(const Verdict& verdict) {
  if (verdict.refusal) std::cout << "refused: " << verdict.refusal->to_line() << "\n";
  for (const std::string& line : verdict.differences) std::cout << "wrong: " << line << "\n";
  if (verdict.finding) std::cout << "the full checker: " << verdict.finding->to_line() << "\n";
}

int run_file(const Options& options) {
  std::ifstream file(options.recipe_file);
  std::ostringstream text;
  text << file.rdbuf();
  const auto recipe = parse_recipe(text.str());
  if (!file || !recipe.ok()) {
    std::cerr << options.recipe_file << ": " << (recipe.ok() ? "cannot be read" : recipe.error().to_line()) << "\n";
    return 2;
  }
  FragmentOptions of_engine;
  of_engine.engine = options.engine;
  const Verdict verdict = try_recipe(*recipe, of_engine, options.fault);
  print(verdict);
  std::cout << (verdict.agrees() ? "agrees\n" : "differs\n");
  return verdict.agrees() ? 0 : 1;
}

class RandomRun {
 public:
  explicit RandomRun(const Options& options) : options_(options) { fragment_.engine = options.engine; }

  int run() {
    for (std::size_t i = 0; i < options_.count; ++i) try_case(options_.seed + i);
    print_contacts();
    for (const auto& [reason, times] : refusals_) std::cout << "refused with " << reason << ": " << times << "\n";
    print_figures();
    return wrong_ + rare_ + (options_.may_refuse ? 0 : refused_) == 0 ? 0 : 1;
  }

 private:
  /// Why a failure counts as refused; none when it is wrong.
  std::optional<std::string> refusal(const Verdict& verdict) const {
    if (verdict.refusal) return verdict.refusal->code.name;
    if (options_.checked && verdict.finding) return "a finding of the full checker";
    return std::nullopt;
  }

  /// Each case has a seed of its own, so that it can be looked at by itself.
  void try_case(std::uint64_t seed) {
    const Recipe recipe = RandomRecipes(seed).next(options_.rotated);
    const Enumeration expected = enumerate(recipe);
    shapes_ += recipe.shape_count();
    count_contacts(recipe, expected, contacts_);
    const Verdict verdict = try_recipe(recipe, expected, fragment_, options_.fault);
    planted_ += verdict.planted ? 1 : 0;
    caught_ += verdict.planted && !verdict.agrees() ? 1 : 0;
    if (verdict.agrees()) return;
    const auto reason = refusal(verdict);
    if (reason) ++refusals_[*reason];
    const std::size_t so_far = reason ? refused_++ : wrong_++;
    if (options_.fault != Fault::none || so_far >= (reason && options_.may_refuse ? 1 : most_printed)) return;
    const Recipe small = shrink(recipe, [&](const Recipe& less) {
      const Verdict again = try_recipe(less, fragment_);
      return !again.agrees() && refusal(again) == reason;
    });
    std::cout << "case " << seed << "\n";
    print(try_recipe(small, fragment_));
    std::cout << small.text();
  }

  void print_contacts() {
    for (const std::string& kind : contact_kinds()) {
      const std::size_t times = contacts_[kind];
      rarest_ = std::min(rarest_, times);
      if (times < options_.least) ++rare_;
      std::cout << "  " << times << "\t" << kind << (times < options_.least ? "  too few" : "") << "\n";
    }
  }

  void print_figures() const {
    std::cout << "grid_oracle: seed " << options_.seed << ", cases " << options_.count << ", wrong " << wrong_
              << ", refused " << refused_ << ", skipped 0, coverage: " << shapes_ << " shapes"
              << (options_.rotated ? ", rotated" : "") << ", " << contact_kinds().size()
              << " kinds of contact, the rarest " << rarest_ << " times";
    if (options_.fault != Fault::none) std::cout << ", faults planted " << planted_ << ", caught " << caught_;
    std::cout << "\n";
  }

  const Options& options_;
  FragmentOptions fragment_;
  std::map<std::string, std::size_t> contacts_, refusals_;
  std::size_t wrong_ = 0, refused_ = 0, planted_ = 0, caught_ = 0, shapes_ = 0, rare_ = 0;
  std::size_t rarest_ = std::numeric_limits<std::size_t>::max();
};

}  // namespace

int main(int count, char** arguments) {
  const auto options = parse(count, arguments);
  if (!options) {
    std::cerr << "usage: grid_oracle COUNT SEED [--engine NAME] [--rotated] [--plant FAULT] [--least N] [--checked] "
                 "[--may-refuse]\n"
                 "       grid_oracle --recipe FILE [--engine NAME] [--plant FAULT]\n";
    return 2;
  }
  return options->recipe_file.empty() ? RandomRun(*options).run() : run_file(*options);
}
