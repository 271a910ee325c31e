// SPDX-License-Identifier: Apache-2.0
// Texts to begin with: the small models in each format, and the files of tests/corpus/topology, which keep what has
// gone wrong once.
#pragma once

#include <string>
#include <vector>

#include "fuzz/properties.h"

namespace aresta::test {

struct CorpusText {
  std::string name, text;
};

std::vector<CorpusText> corpus(const Format& format);

}  // namespace aresta::test
