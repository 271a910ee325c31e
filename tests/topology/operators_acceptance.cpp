// SPDX-License-Identifier: Apache-2.0
// Random operators from each model of the catalogue in turn.
//
//   operators_acceptance APPLICATIONS SEED
//
// Prints how often which sub-case happened, was refused or left a complex without a place in space, what is wrong, and
// last a line of figures. The status is 1 when anything is wrong.
#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <set>

#include "catalogue.h"
#include "operator_cases.h"
#include "operators_run.h"

using namespace aresta;

namespace {

constexpr std::size_t at_once = 40;  ///< operators on one model before they are taken back

/// Sub-cases of the table that random operators can reach and did not.
std::set<std::string> missing(const OperatorsTally& tally) {
  std::set<std::string> names;
  for (const OperatorCase& row : operator_cases()) {
    const std::string name = std::string(row.name) + " " + row.sub_case;
    if (name != "M_MR mmr" && name != "K_M kmr" && !tally.sub_cases.contains(name)) names.insert(name);
  }
  return names;
}

}  // namespace

int main(int argument_count, char** arguments) {
  if (argument_count != 3) {
    std::cerr << "usage: operators_acceptance APPLICATIONS SEED\n";
    return 2;
  }
  const std::size_t wanted = std::strtoull(arguments[1], nullptr, 10);
  const std::uint64_t first_seed = std::strtoull(arguments[2], nullptr, 10);
  const auto models = catalogue();
  OperatorsTally tally;
  std::size_t runs = 0, wrong = 0;
  while (tally.applied < wanted && wrong < 10) {
    const CatalogueModel& model = models[runs % models.size()];
    const std::size_t length = std::min(at_once, wanted - tally.applied);
    run_random_operators(model.complex, model.name, first_seed + runs, length, tally);
    ++runs;
    for (const std::string& message : tally.wrong) std::cout << "wrong: " << message << "\n";
    wrong += tally.wrong.size();
    tally.wrong.clear();
  }
  std::cout << tally.histogram();
  const auto unreached = missing(tally);
  for (const std::string& name : unreached) std::cout << "not reached: " << name << "\n";
  const std::size_t rows = operator_cases().size() - 2;
  std::cout << "operators: seed " << first_seed << ", cases " << tally.applied << ", wrong " << wrong << ", refused "
            << tally.refused << ", skipped 0, coverage: " << runs << " runs from " << std::min(runs, models.size())
            << " models, " << rows - unreached.size() << " of " << rows << " listed sub-cases and "
            << tally.sub_cases.size() << " in all, " << tally.no_space << " runs ended for want of space\n";
  return wrong == 0 ? 0 : 1;
}
