// SPDX-License-Identifier: Apache-2.0
#include "fuzz/properties.h"

#include "topology/check.h"
#include "topology/dump.h"
#include "topology/dump_json.h"
#include "topology/notation.h"
#include "topology/parse_dump.h"

namespace aresta::test {

namespace {

Verdict judge(const Result<Complex>& k) {
  if (!k.ok()) {
    if (k.error().message.empty() || k.error().code.number < 300 || k.error().code.number > 399) {
      return {false, "an error without a message or with a foreign code"};
    }
    return {};
  }
  const auto findings = check_structure(*k, StructureLevel::shells);
  if (!findings.empty()) return {true, "the checker finds: " + describe(findings.front())};
  const std::string text = dump(*k), json = dump_json(*k);
  const auto from_text = parse_dump(text);
  if (!from_text.ok()) return {true, "its dump is refused: " + from_text.error().to_line()};
  if (dump(*from_text) != text) return {true, "its dump gives another dump"};
  const auto from_json = parse_json(json);
  if (!from_json.ok()) return {true, "its JSON is refused: " + from_json.error().to_line()};
  if (dump_json(*from_json) != json) return {true, "its JSON gives other JSON"};
  if (dump(*from_json) != text) return {true, "its JSON gives another dump"};
  return {true, {}};
}

}  // namespace

Verdict check_dump(std::string_view text) {
  return judge(parse_dump(text));
}

Verdict check_json(std::string_view text) {
  return judge(parse_json(text));
}

Verdict check_notation(std::string_view text) {
  return judge(parse_notation(text));
}

std::vector<Format> formats() {
  return {{"dump", check_dump}, {"json", check_json}, {"notation", check_notation}};
}

}  // namespace aresta::test
