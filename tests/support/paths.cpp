// SPDX-License-Identifier: Apache-2.0
#include "support/paths.h"

#include <charconv>
#include <cstdlib>
#include <string_view>

namespace aresta::test {

namespace fs = std::filesystem;

fs::path source_folder() {
  return ARESTA_SOURCE_FOLDER;
}

std::optional<fs::path> data_file(const std::string& name) {
  const char* folder = std::getenv("ARESTA_DATA");
  const fs::path path = (folder != nullptr ? fs::path(folder) : source_folder() / "../shared/data") / name;
  std::error_code ignored;
  if (!fs::exists(path, ignored)) return std::nullopt;
  return path;
}

fs::path program() {
  return fs::path(ARESTA_BUILD_FOLDER) / "apps/aresta/aresta";
}

fs::path output_folder(const std::string& name) {
  fs::path folder = fs::path(ARESTA_BUILD_FOLDER) / "out/tests" / name;
  fs::remove_all(folder);
  fs::create_directories(folder);
  return folder;
}

double scale() {
  double value = 0.01;
  if (const char* text = std::getenv("ARESTA_SCALE")) {
    const std::string_view view = text;
    std::from_chars(view.data(), view.data() + view.size(), value);
  }
  return value;
}

}  // namespace aresta::test
