// SPDX-License-Identifier: MIT
// Clip choice of `sinew cost`, refused inputs, and reports that cannot be written.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <optional>
#include <span>
#include <string>

#include "importer/tool/cost/write_report.h"
#include "runtime/geometry_cache/geometry_cache.h"
#include "tests/importer/tiny_gltf.h"
#include "tests/importer/tool_model.h"
#include "tests/support/file_text.h"
#include "tests/support/full_disk.h"

namespace sinew::test {
namespace {
namespace fs = std::filesystem;
using testing::HasSubstr;

TEST(cost_command, refuses_a_clip_of_what_has_none) {
  const ToolModelFile model;
  const std::string cache = model.beside("talk.sgeo"), folder = model.beside("costs");
  EXPECT_EQ(run_tool({"cost", "-o", folder, "--clip", "0"}).err,
            "sinew: --clip: names a clip of FILE, and there is no FILE\n");
  ASSERT_EQ(run_tool({"bake", model.path(), "--clip", "talk", "-o", cache}).status, 0);
  const CommandOutcome outcome = run_tool({"cost", cache, "-o", folder, "--clip", "0"});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_EQ(outcome.err, "sinew: --clip: names a clip of a glTF file, and FILE is none\n");
}

TEST(cost_command, refuses_a_folder_that_holds_other_things) {
  const ToolModelFile model;
  const fs::path other = model.beside("photos");
  fs::create_directory(other);
  std::ofstream(other / "cat.jpg") << "meow";
  const CommandOutcome refused = run_tool({"cost", model.path(), "--quick", "-o", other.string()});
  EXPECT_EQ(refused.status, 2);
  EXPECT_THAT(refused.err, HasSubstr("cat.jpg"));
  EXPECT_EQ(text_of_file(other / "cat.jpg"), "meow");
}

TEST(cost_command, leaves_no_folder_behind_for_a_broken_file) {
  const ToolModelFile model;
  const fs::path broken = model.beside("broken.gltf"), out = model.beside("none");
  std::ofstream(broken) << "{\"asset\": {";
  EXPECT_EQ(run_tool({"cost", broken.string(), "-o", out.string()}).status, 1);
  EXPECT_FALSE(fs::exists(out));
}

TEST(cost_command, refuses_wrong_usage_before_any_work) {
  const ToolModelFile model;
  EXPECT_EQ(run_tool({"cost", model.path()}).status, 2);
  EXPECT_EQ(run_tool({"cost", model.path(), "-o", model.beside("no/such/folder")}).status, 2);
  EXPECT_EQ(run_tool({"cost", model.path(), "--clip", "nobody", "-o", model.beside("x")}).status, 2);
  EXPECT_EQ(run_tool({"cost", "--clip", "0", "-o", model.beside("x")}).status, 2);
}

TEST(cost_command, looks_at_the_clip_that_was_named) {
  TinyGltf gltf;
  gltf.root["nodes"] = Json::array({Json::object()});
  gltf.animate("translation", gltf.times({0, 1}), gltf.vec3({0, 0, 0, 1, 0, 0}));
  gltf.root["animations"].push_back(gltf.root["animations"][0]);
  gltf.root["animations"][0]["name"] = "first";
  gltf.root["animations"][1]["name"] = "second";
  const ToolModelFile model;
  const fs::path file = model.beside("two.gltf"), out = model.beside("costs");
  std::ofstream(file) << gltf.text();
  ASSERT_EQ(run_tool({"cost", file.string(), "--quick", "--clip", "second", "-o", out.string()}).status, 0);
  const std::string report = text_of_file(out / "report.json");
  EXPECT_THAT(report, HasSubstr("of the clip \\\"second\\\""));
  EXPECT_THAT(report, testing::Not(HasSubstr("the clip \\\"first\\\"")));
}

TEST(cost_command, refuses_a_cache_with_a_damaged_frame) {
  const ToolModelFile model;
  const std::string cache = model.beside("out.sgeo"), out = model.beside("costs");
  ASSERT_EQ(run_tool({"bake", model.path(), "--clip", "talk", "-o", cache}).status, 0);
  std::string bytes = text_of_file(cache);
  const auto intact = GeometryCache::open(std::as_bytes(std::span(bytes)));
  ASSERT_TRUE(intact);
  bytes[intact->frames()[1].offset + 5] ^= 1;
  std::ofstream(cache, std::ios::binary) << bytes;
  const CommandOutcome outcome = run_tool({"cost", cache, "--quick", "-o", out});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(outcome.err, "sinew: " + cache + ": cache-frame: frame 1 is not as it was written\n");
  EXPECT_FALSE(fs::exists(out));
}

/// A folder in which a file blocks the name that the older report is moved to. So no new report can be written.
fs::path blocked_report(const ToolModelFile& model) {
  const fs::path out = model.beside("costs");
  EXPECT_FALSE(cost::write_report(cost::Report{}, out));
  const fs::path aside = out.string() + "." + std::to_string(::getpid()) + ".old";
  fs::create_directory(aside);
  std::ofstream(aside / "left.txt") << "behind";
  return out;
}

TEST(cost_command, an_older_report_stays_where_the_new_one_cannot_take_its_place) {
  const ToolModelFile model;
  const std::string cache = model.beside("out.sgeo");
  ASSERT_EQ(run_tool({"bake", model.path(), "--clip", "talk", "-o", cache}).status, 0);
  const fs::path out = blocked_report(model);
  const std::string before = text_of_file(out / "report.json");
  const CommandOutcome outcome = run_tool({"cost", cache, "--quick", "-o", out.string()});
  EXPECT_EQ(outcome.status, 3);
  EXPECT_EQ(outcome.err, "sinew: " + out.string() + ": Directory not empty\n");
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(text_of_file(out / "report.json"), before);
  EXPECT_FALSE(fs::exists(out.string() + "." + std::to_string(::getpid()) + ".new"));
}

TEST(cost_command, a_report_that_does_not_fit_on_the_disk_leaves_nothing) {
  const ToolModelFile model;
  const fs::path out = model.beside("costs");
  std::optional<std::string> failed;
  {
    const FullDisk disk(10);
    failed = cost::write_report(cost::Report{}, out);
  }
  const std::string made = out.string() + "." + std::to_string(::getpid()) + ".new";
  EXPECT_EQ(failed, made + "/report.json cannot be written");
  EXPECT_FALSE(fs::exists(out));
  EXPECT_FALSE(fs::exists(made));
}

}  // namespace
}  // namespace sinew::test
