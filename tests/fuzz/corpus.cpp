// SPDX-License-Identifier: Apache-2.0
#include "fuzz/corpus.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "support/paths.h"
#include "topology/dump.h"
#include "topology/dump_json.h"
#include "topology/notation.h"
#include "topology/small_models.h"

namespace aresta::test {

std::vector<CorpusText> corpus(const Format& format) {
  std::vector<CorpusText> texts;
  const std::string name = format.name;
  for (const SmallModel& model : small_models()) {
    const Complex k = *parse_notation(model.text);
    texts.push_back({model.name, name == "dump" ? dump(k) : name == "json" ? dump_json(k) : std::string(model.text)});
  }
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(source_folder() / "tests/corpus/topology" / name)) {
    files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  for (const auto& file : files) {
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    texts.push_back({file.filename().string(), text.str()});
  }
  return texts;
}

}  // namespace aresta::test
