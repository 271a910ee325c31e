// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "base/files.h"
#include "exchange/exchange.h"
#include "model/measure.h"
#include "support/paths.h"

namespace aresta::test {

inline std::string counts(const Model& model) {
  const Complex& k = model.topology();
  return std::to_string(model.regions().size()) + "/" + std::to_string(k.face_count()) + "/" +
         std::to_string(k.edge_count()) + "/" + std::to_string(k.vertex_count());
}

inline double volume(const Model& model) {
  auto v = total_volume(model);
  EXPECT_TRUE(v.ok()) << v.error().to_line();
  return v.ok() ? *v : -1;
}

/// A file with the given bytes in the test's own folder.
inline std::string file_with(const std::string& name, const std::string& bytes) {
  static const std::filesystem::path folder = output_folder("exchange_inputs");
  const std::string path = (folder / name).string();
  EXPECT_TRUE(write_file(path, bytes).ok());
  return path;
}

inline std::string notes(const ImportReport& report) {
  std::string all;
  for (const std::string& note : report.notes) all += note + "; ";
  return all;
}

}  // namespace aresta::test
