// SPDX-License-Identifier: Apache-2.0
// Where a test finds its files and leaves its own. Nothing is ever written into the source tree.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace aresta::test {

/// The root of the source tree; read only.
std::filesystem::path source_folder();

/// A file of the test data that are not part of the product, as in data_file("step/7pin.step"): below $ARESTA_DATA, or
/// the folder ../shared/data beside the source tree. Nothing when it is not there: the test says GTEST_SKIP() then.
std::optional<std::filesystem::path> data_file(const std::string& name);

/// The built program `aresta`.
std::filesystem::path program();

/// An empty folder for the results of one test, below the build folder; made anew at each call. The name must be unique
/// among all tests, as in "draw_png".
std::filesystem::path output_folder(const std::string& name);

/// How much of its full size a test with random or many cases runs: $ARESTA_SCALE, by default 0.01; 1 is the full size.
double scale();

}  // namespace aresta::test
