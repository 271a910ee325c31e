// SPDX-License-Identifier: Apache-2.0
// One recipe tried: operands built, fragmented, compared; and faults planted to see that the comparison catches them.
#pragma once

#include <optional>

#include "fragment/oracle/comparison.h"

namespace aresta::grid {

/// One decision of a fragment turned over.
enum class Fault {
  none,
  label,   ///< a cell lies in another region of an operand
  parent,  ///< a face has one parent less
  sense,   ///< a face looks the other way than its parent
  fill,    ///< a region is empty, or a void filled
  piece    ///< an operand's entity has one piece less
};
std::optional<Fault> fault_named(const std::string& name);

struct Verdict {
  std::optional<Error> refusal;  ///< of the fragment, or (which never happens) of an operand
  std::vector<std::string> differences;
  std::optional<Error> finding;  ///< of the full checker, in a fragment that differs
  bool planted = false;
  bool agrees() const { return !refusal && differences.empty(); }
};

Verdict try_recipe(const Recipe& recipe, const FragmentOptions& options, Fault fault = Fault::none);
Verdict try_recipe(const Recipe& recipe, const Enumeration& expected, const FragmentOptions& options, Fault fault);

/// A recipe with as few shapes as possible for which `fails` still holds: operands and shapes are left out one by one.
template <class Predicate>
Recipe shrink(Recipe recipe, Predicate&& fails) {
  const auto leave_out_one = [&] {
    for (std::size_t o = 0; o < recipe.operands.size(); ++o) {
      for (std::size_t s = 0; s <= recipe.operands[o].size(); ++s) {
        Recipe less = recipe;
        const auto operand = less.operands.begin() + static_cast<std::ptrdiff_t>(o);
        if (s == 0) {
          less.operands.erase(operand);
        } else {
          operand->erase(operand->begin() + static_cast<std::ptrdiff_t>(s - 1));
        }
        if (less.operands.size() < 2 || !fails(less)) continue;
        recipe = std::move(less);
        return true;
      }
    }
    return false;
  };
  while (leave_out_one()) continue;
  return recipe;
}

}  // namespace aresta::grid
