// SPDX-License-Identifier: Apache-2.0
// The stages of the checker. Each appends findings, and needs those before it to have found nothing.
#pragma once

#include <vector>

#include "topology/rows_detail.h"

namespace aresta::check_detail {

using Findings = std::vector<StructuralFinding>;

void check_rows(const ComplexRows& rows, Findings& findings);
void check_lists(const ComplexRows& rows, Findings& findings);
void check_cells(const ComplexRows& rows, Findings& findings);
void check_shells(const Complex& k, Findings& findings);
void check_fans(const Complex& k, Findings& findings);
void check_regions(const Complex& k, Findings& findings);

}  // namespace aresta::check_detail
