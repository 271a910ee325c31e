// SPDX-License-Identifier: Apache-2.0
// What the readers of topology/ must hold for any bytes: they refuse, or give a complex that is written and read back
// to the same bytes, as text and as JSON.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace aresta::test {

struct Verdict {
  bool accepted = false;
  std::string wrong;  ///< empty: as it should be
};

/// One notation that is read: its name is that of its folder in tests/corpus/topology.
struct Format {
  const char* name;
  Verdict (*check)(std::string_view text);
};

Verdict check_dump(std::string_view text);
Verdict check_json(std::string_view text);
Verdict check_notation(std::string_view text);

std::vector<Format> formats();

}  // namespace aresta::test
