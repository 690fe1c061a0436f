// SPDX-License-Identifier: MIT
// Clips within the budgets that users give on the command line.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "importer/import_gltf.h"
#include "importer/tool/length_text.h"
#include "runtime/clip/unpack_clip.h"
#include "runtime/compress/compile_clip_within.h"
#include "tests/importer/tool_model.h"
#include "tests/reference/clip_error.h"
#include "tests/support/corpus.h"

namespace sinew::test {
namespace {
using testing::HasSubstr;

TEST(length_text, reads_lengths_with_and_without_units) {
  const std::pair<const char*, double> good[] = {{"0.1mm", 1e-4}, {"0.1 mm", 1e-4}, {"1e-4", 1e-4}, {"0.001m", 1e-3},
                                                 {"2cm", 0.02},   {"50um", 5e-5},   {"0", 0.0},     {"1e-3mm", 1e-6}};
  for (const auto& [text, metres] : good) {
    const auto read = tool::parse_length(text);
    ASSERT_TRUE(read) << text;
    EXPECT_DOUBLE_EQ(*read, metres) << text;
  }
}

TEST(length_text, refuses_what_is_no_length_and_says_what_would_be) {
  for (const char* text : {"", "mm", "-1mm", "0.1inch", "1e999", "nan", "inf", "0.1mmm", "0,1mm", "1 m m"}) {
    const auto read = tool::parse_length(text);
    ASSERT_FALSE(read) << text;
    EXPECT_THAT(read.error(), HasSubstr("0.1mm"));
  }
}

TEST(length_text, writes_lengths_in_a_unit_that_fits) {
  EXPECT_EQ(tool::length_text(1e-4), "0.1 mm");
  EXPECT_EQ(tool::length_text(9.7e-5), "97 um");
  EXPECT_EQ(tool::length_text(2.0), "2 m");
  EXPECT_EQ(tool::length_text(0.0), "0");
}

TEST(convert_budget, prints_a_certificate_for_every_clip_and_writes_a_file_that_keeps_it) {
  const ToolModelFile model;
  const std::string out = model.beside("out.glb");
  const CommandOutcome outcome = run_tool({"convert", model.path(), out, "--budget", "0.5mm"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  for (const char* text : {"asked", "measured", "0.5 mm", "bend", "talk", "yes"})
    EXPECT_THAT(outcome.out, HasSubstr(text));
  const auto before = import_gltf(model.path()), after = import_gltf(out);
  ASSERT_TRUE(before && after);
  const VirtualVertices vertices = virtual_vertices(before->scene);
  for (std::size_t i = 0; i < before->scene.animations.size(); ++i) {
    const Clip clip =
        compile_and_measure(before->scene, after->scene.animations[i], before->scene.animations[i], vertices, 5e-4);
    EXPECT_TRUE(clip.certificate()->is_met());
    EXPECT_EQ(after->scene.animations[i].duration_s, before->scene.animations[i].duration_s);
  }
}

TEST(convert_budget, of_zero_changes_nothing) {
  const ToolModelFile model;
  const std::string plain = model.beside("plain.glb"), zero = model.beside("zero.glb");
  ASSERT_EQ(run_tool({"convert", model.path(), plain}).status, 0);
  ASSERT_EQ(run_tool({"convert", model.path(), zero, "--budget", "0"}).status, 0);
  EXPECT_EQ(std::filesystem::file_size(plain), std::filesystem::file_size(zero));
  const std::string golden = model.beside("golden.json");
  ASSERT_EQ(run_tool({"sample", plain, "--vertices", "all", "-o", golden}).status, 0);
  EXPECT_EQ(run_tool({"verify", zero, golden, "--tolerance", "0"}).status, 0);
}

TEST(convert_budget, that_makes_no_sense_is_wrong_usage_and_writes_nothing) {
  const ToolModelFile model;
  const std::string out = model.beside("out.glb");
  const CommandOutcome outcome = run_tool({"convert", model.path(), out, "--budget", "a bit"});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_THAT(outcome.err, HasSubstr("--budget: \"a bit\""));
  EXPECT_FALSE(std::filesystem::exists(out));
}

TEST(compile_command, writes_clips_that_info_tells_about_and_that_keep_their_budget) {
  const ToolModelFile model;
  const std::string out = model.beside("clips.sinew");
  const CommandOutcome compiled = run_tool({"compile", model.path(), "-o", out, "--budget", "0.2mm"});
  ASSERT_EQ(compiled.status, 0) << compiled.err;
  for (const char* text : {"asked", "measured", "0.2 mm", "bend", "talk", "ns/joint", "2 clips"})
    EXPECT_THAT(compiled.out, HasSubstr(text));
  const CommandOutcome info = run_tool({"info", out});
  ASSERT_EQ(info.status, 0) << info.err;
  for (const char* text : {"compiled clips, version 3: 2", "0.2 mm", "bend"}) EXPECT_THAT(info.out, HasSubstr(text));
  const auto json = nlohmann::json::parse(run_tool({"info", out, "--json"}).out);
  ASSERT_EQ(json.at("compiled_clips").size(), 2u);
  EXPECT_LE(json["compiled_clips"][0]["certificate"]["measured_m"].get<double>(), 2e-4);
  EXPECT_EQ(json["compiled_clips"][0]["certificate"]["asked_m"].get<double>(), 2e-4);
}

TEST(compile_command, damaged_clips_are_refused_by_rule_and_place) {
  const ToolModelFile model;
  const std::string out = model.beside("clips.sinew");
  ASSERT_EQ(run_tool({"compile", model.path(), "-o", out}).status, 0);
  std::fstream file(out, std::ios::in | std::ios::out | std::ios::binary);
  file.seekp(100);
  file.put('?');
  file.close();
  const CommandOutcome info = run_tool({"info", out});
  EXPECT_EQ(info.status, 1);
  EXPECT_THAT(info.err, HasSubstr("byte 24: clip-checksum: "));
  EXPECT_EQ(run_tool({"compile", model.path(), "-o", model.path()}).status, 2);
  EXPECT_EQ(run_tool({"compile", model.path(), "-o", out, "--budget", "-1"}).status, 2);
  EXPECT_EQ(run_tool({"compile", model.beside("missing.glb"), "-o", out}).status, 1);
}

/// At times that the compiler did not look at.
TEST(convert_budget_corpus, every_clip_of_every_model_stays_within_its_budget) {
  if (!corpus()) GTEST_SKIP() << kNoCorpus;
  constexpr double kBudget = 1e-3;
  FixedRandom random(13);
  std::size_t clips = 0;
  for (const auto& path : corpus_files("models", {".gltf", ".glb"})) {
    const auto file = import_gltf(path, {.decode_images = false});
    if (!file) continue;
    const Scene& scene = file->scene;
    const VirtualVertices vertices = virtual_vertices(scene);
    for (std::size_t i = 0; i < std::min<std::size_t>(scene.animations.size(), 12); ++i) {
      const Animation& truth = scene.animations[i];
      const ClipWithin within = compile_clip_within(scene, truth, vertices, kBudget);
      EXPECT_TRUE(within.clip.certificate()->is_met()) << path << " clip " << i;
      const Clip full = unpacked(within.clip);
      for (int k = 0; k < (scene.skeleton.joint_count() > 100 ? 3 : 20); ++k) {
        const double time_s = random.in(0, truth.duration_s);
        for (const Clip* clip : {&within.clip, &full})
          for (const auto error : reference::joint_errors(scene.skeleton, truth, vertices.boxes, *clip, time_s))
            ASSERT_LE(static_cast<double>(error), kBudget) << path << " clip " << i << " at " << time_s;
      }
      ++clips;
    }
  }
  EXPECT_GT(clips, 0u);
}

}  // namespace
}  // namespace sinew::test
