// SPDX-License-Identifier: Apache-2.0
#include "topology/check.h"

#include <algorithm>

#include "topology/check_detail.h"

namespace aresta {

std::vector<StructuralFinding> check_structure(const Complex& complex, StructureLevel level) {
  using namespace check_detail;
  const ComplexRows rows(complex);
  Findings findings;
  check_rows(rows, findings);
  if (findings.empty()) check_lists(rows, findings);
  if (findings.empty()) check_cells(rows, findings);
  if (findings.empty() && level != StructureLevel::fast) check_shells(complex, findings);
  if (findings.empty() && level == StructureLevel::full) {
    check_fans(complex, findings);
    if (findings.empty()) check_regions(complex, findings);
  }
  std::sort(findings.begin(), findings.end());
  findings.erase(std::unique(findings.begin(), findings.end()), findings.end());
  return findings;
}

}  // namespace aresta
