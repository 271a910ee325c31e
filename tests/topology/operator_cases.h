// SPDX-License-Identifier: Apache-2.0
// The operators and their sub-cases as a table: what tests of operators must reach, and what docs/operators.md says.
#pragma once

#include <span>
#include <string>

#include "topology/operators.h"

namespace aresta {

/// A sub-case of an operator. The test Operators.NAME_SUBCASE reaches it on the model named here.
struct OperatorCase {
  const char* name;      ///< of the operator
  const char* sub_case;  ///< as Applied::sub_case says it
  CountChange change;    ///< on the model of the test
  const char* inverse;   ///< operator and sub-case that lead back to the same dump, or "take_back"
  const char* model;     ///< what it is tried on

  std::string test() const { return std::string(name) + "_" + sub_case; }
};

/// What the page says of an operator.
struct OperatorText {
  const char* name;
  const char* call;           ///< its function
  const char* purpose;        ///< a sentence
  const char* sketch;         ///< before and after
  const char* preconditions;  ///< and the errors where they do not hold
  const char* attributes;     ///< which entities stay, and with them their attributes
};

/// Both in the order of the page.
std::span<const OperatorText> operator_texts();
std::span<const OperatorCase> operator_cases();

/// The page docs/operators.md.
std::string operators_page();

}  // namespace aresta
