// SPDX-License-Identifier: Apache-2.0
// Files that are not what they claim to be: typed errors, nothing on the standard streams, no output left behind.
#include <filesystem>
#include <random>

#include "construct/primitives.h"
#include "exchange/errors.h"
#include "files.h"

namespace aresta::test {
namespace {

std::string random_bytes(std::size_t n) {
  std::mt19937 random(7);
  std::string bytes;
  for (std::size_t i = 0; i < n; ++i) bytes.push_back(static_cast<char>(random() & 0xffu));
  return bytes;
}

std::string exported(const std::string& format, bool ascii = false) {
  auto model = cylinder(1, 2);
  EXPECT_TRUE(model.ok());
  const std::string path = (own_folder("good") / ("good." + format)).string();
  ExportOptions options;
  options.ascii = ascii;
  EXPECT_TRUE(export_file(*model, path, options).ok());
  auto data = read_file(path);
  EXPECT_TRUE(data.ok());
  return data.ok() ? *data : std::string();
}

const char* const formats[] = {"step", "brep", "stl", "obj", "ply", "off"};

TEST(BadInput, WhatCannotBeRead) {
  for (const std::string format : formats) {
    SCOPED_TRACE(format);
    auto missing = import_file("/nowhere/at/all." + format);
    ASSERT_FALSE(missing.ok());
    EXPECT_EQ(missing.error().code, errors::file_unreadable);
    const auto folder = output_folder("exchange_folder_" + format) / ("folder." + format);
    std::filesystem::create_directory(folder);
    auto directory = import_file(folder.string());
    ASSERT_FALSE(directory.ok());
    EXPECT_EQ(directory.error().code, errors::file_unreadable);
  }
}

TEST(BadInput, WhatIsNotTheFormat) {
  for (const std::string format : formats) {
    for (const std::string& content :
         {std::string(), random_bytes(5000), std::string("solid\n"), std::string("hello world")}) {
      SCOPED_TRACE(format + ": " + content.substr(0, 12));
      testing::internal::CaptureStdout();
      testing::internal::CaptureStderr();
      auto result = import_file(file_with("bad." + format, content));
      EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
      EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
      ASSERT_FALSE(result.ok());
      EXPECT_EQ(result.error().code.failure, Failure::file) << result.error().to_line();
      EXPECT_NE(result.error().message.find("bad." + format), std::string::npos) << result.error().to_line();
    }
  }
}

TEST(BadInput, FilesThatAreCutOff) {
  for (const std::string format : {"step", "brep", "stl"}) {
    const std::string good = exported(format);
    for (const double share : {0.1, 0.3, 0.5, 0.7, 0.9, 0.99}) {
      SCOPED_TRACE(format + " " + std::to_string(share));
      const auto length = static_cast<std::size_t>(share * static_cast<double>(good.size()));
      testing::internal::CaptureStdout();
      testing::internal::CaptureStderr();
      auto result = import_file(file_with("cut." + format, good.substr(0, length)));
      EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
      EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
      ASSERT_FALSE(result.ok());
      EXPECT_EQ(result.error().code, errors::bad_content) << result.error().to_line();
    }
  }
}

TEST(BadInput, DamageInTheMiddleIsNoCrash) {
  for (const std::string format : {"step", "brep"}) {
    const std::string good = exported(format);
    std::mt19937 random(3);
    for (int i = 0; i < 80; ++i) {
      std::string damaged = good;
      for (int k = 0; k < (i % 2 == 0 ? 1 : 5); ++k)
        damaged[random() % damaged.size()] = static_cast<char>('0' + random() % 75);
      auto result = import_file(file_with("damaged." + format, damaged));
      EXPECT_TRUE(result.ok() || !result.error().message.empty());
    }
  }
}

TEST(BadInput, ImagesThatLeadNowhere) {
  const std::string good = exported("step");
  for (const auto& [from, to] : {std::pair{"= LINE(", "= LcNE("},
                                 std::pair{"DEFINITIONAL_REPRESENTATION('',(", "DEFINITIONAL_REPRESENTATION(''E("}}) {
    std::string damaged = good;
    const std::size_t at = damaged.find(from);
    ASSERT_NE(at, std::string::npos);
    damaged.replace(at, std::string(from).size(), to);
    auto result = import_file(file_with("blind.step", damaged));
    EXPECT_TRUE(result.ok() || result.error().code == errors::bad_content) << result.error().to_line();
  }
}

TEST(BadInput, CoordinatesThatAreNoNumbers) {
  const struct {
    const char *name, *text;
  } cases[] = {
      {"nan.obj", "v 0 0 nan\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"},
      {"inf.obj", "v 0 0 inf\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"},
      {"word.obj", "v 0 0 x\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"},
      {"index.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n"},
      {"zero.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 0 1 2\n"},
      {"nan.off", "OFF\n3 1 0\n0 0 nan\n1 0 0\n0 1 0\n3 0 1 2\n"},
      {"index.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n"},
      {"count.off", "OFF\n9 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"},
      {"nan.stl",
       "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 nan\nvertex 0 1 0\nendloop\nendfacet\n"
       "endsolid s\n"},
      {"cut.stl", "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"},
      {"nan.ply",
       "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
       "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 nan\n0 1 0\n3 0 1 2\n"},
  };
  for (const auto& c : cases) {
    SCOPED_TRACE(c.name);
    auto result = import_file(file_with(c.name, c.text));
    ASSERT_FALSE(result.ok());
    EXPECT_EQ(result.error().code, errors::bad_content) << result.error().to_line();
  }
  // Binary STL: the same through bits.
  std::string data(84, '\0');
  data[80] = 1;
  data.append(50, '\0');
  for (int i = 0; i < 4; ++i) data[84 + 12 + static_cast<std::size_t>(i)] = '\xff';
  auto result = import_file(file_with("bits.stl", data));
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().code, errors::bad_content) << result.error().to_line();
}

TEST(BadInput, StepNumbersThatAreTooLarge) {
  std::string text = exported("step");
  const std::size_t point = text.find("CARTESIAN_POINT");
  ASSERT_NE(point, std::string::npos);
  const std::size_t first = text.find('(', text.find(',', point)) + 1;
  text.replace(first, text.find_first_of(",)", first) - first, "1.E400");
  auto result = import_file(file_with("large.step", text));
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().code, errors::bad_content) << result.error().to_line();
  EXPECT_NE(result.error().message.find("1.E400"), std::string::npos) << result.error().to_line();
}

TEST(BadInput, NothingInside) {
  auto flat = import_file(file_with("flat.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n"));
  ASSERT_FALSE(flat.ok());
  EXPECT_EQ(flat.error().code, errors::nothing_to_import);
  const char* empty_step =
      "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\nFILE_NAME('','',(''),(''),'','','');\n"
      "FILE_SCHEMA(('AUTOMOTIVE_DESIGN'));\nENDSEC;\nDATA;\nENDSEC;\nEND-ISO-10303-21;\n";
  auto step = import_file(file_with("empty.step", empty_step));
  ASSERT_FALSE(step.ok());
  EXPECT_EQ(step.error().code, errors::nothing_to_import) << step.error().to_line();
}

TEST(BadInput, FormatsThatAreUnknown) {
  auto none = import_file("model");
  ASSERT_FALSE(none.ok());
  EXPECT_EQ(none.error().code, errors::unknown_format);
  auto word = import_file("model.docx");
  ASSERT_FALSE(word.ok());
  EXPECT_EQ(word.error().code, errors::unknown_format);
  EXPECT_EQ(*format_of("A.STP", ""), "step");
  EXPECT_EQ(*format_of("anything", "obj"), "obj");
  auto model = block(1, 1, 1);
  ASSERT_TRUE(model.ok());
  EXPECT_EQ(export_file(*model, "out.ply").error().code, errors::unknown_format);
}

TEST(BadOutput, NothingIsLeftBehind) {
  auto model = block(1, 1, 1);
  ASSERT_TRUE(model.ok());
  const auto folder = output_folder("exchange_unwritable");
  for (const std::string format : {"step", "brep", "stl", "obj"}) {
    SCOPED_TRACE(format);
    auto status = export_file(*model, (folder / "no" / "such" / ("folder." + format)).string());
    ASSERT_FALSE(status.ok());
    EXPECT_EQ(status.error().code, errors::file_unwritable);
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder));
  EXPECT_EQ(export_file(Model(), (folder / "empty.step").string()).error().code, errors::export_failed);
  EXPECT_TRUE(std::filesystem::is_empty(folder));
}

}  // namespace
}  // namespace aresta::test
