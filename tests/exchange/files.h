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

/// A folder of the running test alone: tests run side by side, each in a process of its own.
inline std::filesystem::path own_folder(const std::string& name) {
  const testing::TestInfo& test = *testing::UnitTest::GetInstance()->current_test_info();
  std::string unique = "exchange_" + name + "_" + test.test_suite_name() + "_" + test.name();
  for (char& c : unique) c = c == '/' ? '_' : c;
  return output_folder(unique);
}

/// A file with the given bytes in the test's own folder.
inline std::string file_with(const std::string& name, const std::string& bytes) {
  const std::filesystem::path folder = own_folder("inputs");
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
