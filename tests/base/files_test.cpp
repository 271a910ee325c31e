// SPDX-License-Identifier: Apache-2.0
#include "base/files.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <thread>

namespace aresta {
namespace {

namespace fs = std::filesystem;

class Files : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(::testing::TempDir()) / ("aresta_files_" + std::to_string(::getpid()));
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }
  std::string path(const char* name) const { return (folder_ / name).string(); }
  long entries() const { return std::distance(fs::directory_iterator(folder_), fs::directory_iterator()); }

  fs::path folder_;
};

TEST_F(Files, WritesReadsAndReplaces) {
  const std::string binary("a\0b\n\xff", 5);
  ASSERT_TRUE(write_file(path("f"), binary));
  EXPECT_EQ(*read_file(path("f")), binary);
  ASSERT_TRUE(write_file(path("f"), "second"));
  EXPECT_EQ(*read_file(path("f")), "second");
  EXPECT_EQ(entries(), 1);
}

TEST_F(Files, PipesAreWaitedForAndCanBeGivenUp) {
  ASSERT_EQ(::mkfifo(path("pipe").c_str(), 0600), 0);
  std::thread writer([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    std::ofstream(path("pipe")) << "late";
  });
  const auto text = read_file(path("pipe"));
  writer.join();
  ASSERT_TRUE(text.ok()) << text.error().to_line();
  EXPECT_EQ(*text, "late");

  std::atomic<bool> cancel{false};
  Context context;
  context.cancel = &cancel;
  std::thread stopper([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    cancel = true;
  });
  EXPECT_EQ(read_file(path("pipe"), 1000, context).error().code, errors::cancelled);
  stopper.join();
  EXPECT_EQ(read_file("/dev/zero", 100000).error().code, errors::file_unreadable);
  EXPECT_EQ(read_file("").error().message, "cannot read '': the name of the file is empty");
}

TEST_F(Files, FollowsALinkAndKeepsPermissions) {
  ASSERT_TRUE(write_file(path("real"), "old"));
  ASSERT_EQ(::chmod(path("real").c_str(), 0640), 0);
  fs::create_symlink("real", folder_ / "link");
  ASSERT_TRUE(write_file(path("link"), "new"));
  EXPECT_TRUE(fs::is_symlink(folder_ / "link"));
  EXPECT_EQ(*read_file(path("real")), "new");
  struct stat info {};
  ASSERT_EQ(::stat(path("real").c_str(), &info), 0);
  EXPECT_EQ(info.st_mode & 07777, 0640u);
}

TEST_F(Files, FilesThatBelongTogetherAreAllThereOrNone) {
  ASSERT_TRUE(write_files({{path("a"), "one"}, {path("b"), "two"}}));
  EXPECT_EQ(*read_file(path("a")) + *read_file(path("b")), "onetwo");
  for (const std::string& bad : {path("none/c"), std::string("/dev/full"), folder_.string(), std::string()}) {
    const Status failed = write_files({{path("a"), "new"}, {bad, "x"}, {path("d"), "new"}});
    ASSERT_FALSE(failed.ok()) << bad;
    EXPECT_EQ(failed.error().code, errors::file_unwritable);
    EXPECT_EQ(*read_file(path("a")), "one");
    EXPECT_EQ(entries(), 2);
  }
}

TEST_F(Files, WhatCannotBeWrittenIsKnownBefore) {
  EXPECT_TRUE(check_writable(path("new")).ok());
  EXPECT_TRUE(check_writable("/dev/full").ok());
  EXPECT_FALSE(fs::exists(path("new")));
  for (const std::string& bad : {path("none/f"), folder_.string(), std::string(), std::string("/nowhere/f")}) {
    const Status known = check_writable(bad);
    ASSERT_FALSE(known.ok()) << bad;
    EXPECT_EQ(known.error().message, write_file(bad, "x").error().message);
  }
}

TEST_F(Files, FailuresNameThePathAndLeaveNothing) {
  const Status no_folder = write_file(path("none/f"), "x");
  ASSERT_FALSE(no_folder.ok());
  EXPECT_EQ(no_folder.error().code, errors::file_unwritable);
  EXPECT_EQ(no_folder.error().code.failure, Failure::file);
  EXPECT_NE(no_folder.error().message.find(path("none/f")), std::string::npos);

  EXPECT_EQ(write_file(folder_.string(), "x").error().code, errors::file_unwritable);
  EXPECT_EQ(write_file("/dev/full", "x").error().code, errors::file_unwritable);
  EXPECT_TRUE(fs::is_character_file("/dev/full"));
  EXPECT_EQ(read_file(path("none")).error().code, errors::file_unreadable);
  EXPECT_EQ(read_file(folder_.string()).error().code, errors::file_unreadable);
  EXPECT_EQ(entries(), 0);
}

}  // namespace
}  // namespace aresta
