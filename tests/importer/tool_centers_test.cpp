// SPDX-License-Identifier: MIT
// Centers of rotation take long: they are computed where a command needs them, and kept for the next time.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdlib.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>

#include "importer/file/cache_folder.h"
#include "runtime/base/checksum.h"
#include "tests/importer/tool_model.h"

namespace sinew::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using Arguments = std::vector<std::string>;

/// The files of a cache; none where there is no such folder.
std::vector<fs::path> files_in(const std::string& folder) {
  std::error_code error;
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder, error)) files.push_back(entry.path());
  return files;
}

/// Moves all centers of a cache file by 1 m, and makes its checksum right: whoever reads them has other poses.
void move_centers(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(in), {}};
  constexpr std::size_t kHeader = 24, kChecksumAt = 16;
  for (std::size_t at = kHeader; at < bytes.size(); at += sizeof(float)) {
    float number = 0.0f;
    std::memcpy(&number, &bytes[at], sizeof number);
    number += 1.0f;
    std::memcpy(&bytes[at], &number, sizeof number);
  }
  const std::uint64_t sum = checksum(std::as_bytes(std::span(bytes).subspan(kHeader)));
  std::memcpy(&bytes[kChecksumAt], &sum, sizeof sum);
  std::ofstream(file, std::ios::binary) << bytes;
}

TEST(tool_centers, sample_computes_them_only_when_asked) {
  const ToolModelFile model;
  const std::string cache = model.beside("cache");
  const CommandOutcome plain = run_tool({"sample", model.path(), "--clip", "0", "--times", "1", "--cache", cache});
  ASSERT_EQ(plain.status, 0) << plain.err;
  EXPECT_TRUE(files_in(cache).empty());
  const json sample = json::parse(plain.out)["clips"][0]["samples"][0];
  for (const char* key : {"positions", "dqs"}) EXPECT_TRUE(sample["skinned"][0].contains(key)) << key;
  EXPECT_FALSE(sample["skinned"][0].contains("cors"));
  EXPECT_FALSE(sample["bits"].contains("centerOfRotation"));
  for (const char* asked : {"all", "center-of-rotation", "linear,center-of-rotation"}) {
    const CommandOutcome outcome =
        run_tool({"sample", model.path(), "--clip", "0", "--times", "1", "--cache", cache, "--skinning", asked});
    EXPECT_TRUE(json::parse(outcome.out)["clips"][0]["samples"][0]["skinned"][0].contains("cors")) << asked;
  }
  EXPECT_EQ(files_in(cache).size(), 1u) << "no unfinished file is left";
}

TEST(tool_centers, are_read_from_the_cache_the_next_time_by_every_command) {
  const ToolModelFile model;
  const std::string cache = model.beside("cache"), golden = model.beside("golden.json");
  const auto sample = [&](const std::string& folder) {
    return run_tool({"sample", model.path(), "--skinning", "center-of-rotation", "--cache", folder}).out;
  };
  const std::string computed = sample(cache);
  EXPECT_EQ(sample(cache), computed);
  ASSERT_EQ(files_in(cache).size(), 1u);
  ASSERT_EQ(run_tool({"sample", model.path(), "--skinning", "all", "--cache", cache, "-o", golden}).status, 0);
  EXPECT_EQ(run_tool({"verify", model.path(), golden, "--exact", "--cache", cache}).status, 0);
  move_centers(files_in(cache)[0]);
  EXPECT_NE(sample(cache), computed);
  EXPECT_EQ(sample("none"), computed);
  EXPECT_EQ(run_tool({"verify", model.path(), golden, "--exact", "--cache", cache}).status, 1);
  EXPECT_EQ(run_tool({"verify", model.path(), golden, "--exact", "--cache", "none"}).status, 0);
  const std::string other = model.beside("other");
  EXPECT_EQ(run_tool({"plan", model.path(), "--skinning", "center-of-rotation", "--cache", other}).status, 0);
  EXPECT_EQ(files_in(other).size(), 1u);
}

/// Sets an environment variable while it lives.
class Variable {
 public:
  Variable(const char* name, const char* value) : name_(name) {
    const char* old = getenv(name);
    if (old != nullptr) old_ = old;
    value != nullptr ? setenv(name, value, 1) : unsetenv(name);
  }
  ~Variable() { old_ ? setenv(name_, old_->c_str(), 1) : unsetenv(name_); }
  Variable(const Variable&) = delete;
  Variable& operator=(const Variable&) = delete;

 private:
  const char* name_;
  std::optional<std::string> old_;
};

TEST(tool_centers, the_environment_says_where_they_are_kept) {
  const Variable home("HOME", "/home/someone"), base("XDG_CACHE_HOME", nullptr), own("SINEW_CACHE", nullptr);
  EXPECT_EQ(default_cache_folder(), "/home/someone/.cache/sinew");
  {
    const Variable no_home("HOME", nullptr);
    EXPECT_EQ(default_cache_folder(), "") << "nothing is kept";
  }
  const Variable other_base("XDG_CACHE_HOME", "/var/cache/someone");
  EXPECT_EQ(default_cache_folder(), "/var/cache/someone/sinew");
  {
    const Variable named("SINEW_CACHE", "/centers");
    EXPECT_EQ(default_cache_folder(), "/centers");
  }
  const Variable none("SINEW_CACHE", "none");
  EXPECT_EQ(default_cache_folder(), "");
}

TEST(tool_centers, a_cache_that_cannot_be_written_is_no_fault) {
  const ToolModelFile model;
  std::ofstream(model.beside("file")) << "not a folder";
  const CommandOutcome outcome =
      run_tool({"sample", model.path(), "--skinning", "all", "--cache", model.beside("file") + "/inside"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
}

}  // namespace
}  // namespace sinew::test
