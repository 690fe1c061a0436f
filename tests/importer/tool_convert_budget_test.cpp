// SPDX-License-Identifier: MIT
// Keys that `sinew convert --budget` leaves out, and what it prints about them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "importer/import_gltf.h"
#include "importer/rewrite_gltf.h"
#include "importer/tool/certificate_table.h"
#include "importer/tool/convert/written_clips.h"
#include "importer/tool/model_size.h"
#include "runtime/animation/track_sample.h"
#include "runtime/compress/fit_keys.h"
#include "tests/importer/tiny_gltf.h"
#include "tests/importer/tool_model.h"
#include "tests/support/corpus.h"

namespace sinew::test {
namespace {
using testing::HasSubstr;

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
    EXPECT_TRUE(
        measure_keys(before->scene, after->scene.animations[i], before->scene.animations[i], vertices, 5e-4).is_met());
    EXPECT_EQ(after->scene.animations[i].duration_s, before->scene.animations[i].duration_s);
  }
}

TEST(convert_budget, certificates_compare_what_was_written_with_what_was_read) {
  TinyGltf gltf;
  gltf.root["nodes"] = Json::array({Json::object()});
  gltf.animate("translation", gltf.times({0, 1, 2}), gltf.vec3({0, 0, 0, 0.5004f, 0, 0, 1, 0, 0}));
  const ToolModelFile model;
  const std::string in = model.beside("bent.gltf"), out = model.beside("straight.glb");
  std::ofstream(in) << gltf.text();
  const CommandOutcome outcome = run_tool({"convert", in, out, "--budget", "1mm"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const auto before = import_gltf(in), after = import_gltf(out);
  ASSERT_TRUE(before && after);
  EXPECT_LT(after->scene.animations[0].bones[0].translation.key_count(), 3u);
  const Animation &truth = before->scene.animations[0], &written = after->scene.animations[0];
  const std::vector<tool::CertifiedClip> clips{
      {0, "", truth.duration_s, measure_keys(before->scene, written, truth, virtual_vertices(before->scene), 1e-3)}};
  EXPECT_GT(clips[0].certificate.measured_m, 1e-4);
  EXPECT_THAT(outcome.out, HasSubstr(tool::certified_clips_table(clips, before->scene.skeleton.names)));
}

TEST(convert_budget, of_zero_holds_and_keeps_every_key) {
  const ToolModelFile model;
  const CommandOutcome outcome = run_tool({"convert", model.path(), model.beside("out.glb"), "--budget", "0"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("yes"));
  EXPECT_THAT(outcome.out, testing::Not(HasSubstr("NO")));
  EXPECT_THAT(outcome.out, HasSubstr("2 clips, 4 of 4 keys, farthest off 0 of 0"));
  const CommandOutcome compiled = run_tool({"compile", model.path(), "-o", model.beside("out.sinew"), "--budget", "0"});
  EXPECT_THAT(compiled.out, testing::Not(HasSubstr("NO"))) << "what is left is the rounding of float";
}

/// A file of one joint that moves evenly: two of its keys say everything.
std::string even_motion() {
  TinyGltf gltf;
  gltf.root["nodes"] = Json::array({Json::object()});
  std::vector<float> times, places;
  for (int k = 0; k < 40; ++k) {
    times.push_back(static_cast<float>(k));
    places.insert(places.end(), {0.5f * static_cast<float>(k), 0.0f, 0.0f});
  }
  gltf.animate("translation", gltf.times(times), gltf.vec3(places));
  return gltf.text();
}

TEST(convert_budget, of_several_files_each_line_says_what_was_kept_and_measured) {
  const ToolModelFile model;
  std::ofstream(model.beside("even.gltf")) << even_motion();
  const CommandOutcome outcome =
      run_tool({"convert", model.path(), model.beside("even.gltf"), model.beside("out"), "--budget", "1mm"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("even.glb: "));
  EXPECT_THAT(outcome.out, HasSubstr("; 1 clip, 2 of 40 keys, farthest off "));
  EXPECT_THAT(outcome.out, HasSubstr(" of 1 mm\n"));
}

TEST(convert_budget, holds_what_is_quantized_too_with_more_bits_where_it_needs_them) {
  const ToolModelFile model;
  for (const char* budget : {"0", "0.1um", "1um", "1mm", "5cm"})
    for (const bool meshopt : {false, true}) {
      std::vector<std::string> arguments{"convert",    model.path(), model.beside("out.glb"),
                                         "--quantize", "--budget",   budget};
      if (meshopt) arguments.emplace_back("--meshopt");
      const CommandOutcome outcome = run_tool(arguments);
      EXPECT_EQ(outcome.status, 0) << budget << outcome.out << outcome.err;
      EXPECT_THAT(outcome.out, testing::Not(HasSubstr("NO"))) << budget;
    }
}

TEST(convert_budget, a_gltf_with_its_buffer_is_what_was_measured) {
  const ToolModelFile model;
  std::ofstream(model.beside("even.gltf")) << even_motion();
  ASSERT_EQ(run_tool({"convert", model.beside("even.gltf"), model.beside("out.gltf"), "--budget", "1mm"}).status, 0);
  const auto written = import_gltf(std::filesystem::path(model.beside("out.gltf")));
  ASSERT_TRUE(written);
  EXPECT_EQ(written->scene.animations[0].bones[0].translation.key_count(), 2u);
}

TEST(convert_budget, clips_that_are_not_within_it_keep_all_keys_and_are_counted) {
  const ToolModelFile model;
  ImportOptions carrying;
  carrying.carry_document = true;
  const auto file = import_gltf(std::filesystem::path(model.path()), carrying);
  ASSERT_TRUE(file);
  std::vector<Animation> other = file->scene.animations;  // glTF has no squad: the file keeps its own keys
  other[0].bones[0].rotation.interpolation = Interpolation::squad;
  for (glm::quat& q : other[0].bones[0].rotation.values) q = glm::normalize(q * glm::quat(1.0f, 0.2f, 0, 0));
  const auto written = tool::write_within(*file, other, {}, 1e-3);
  ASSERT_TRUE(written);
  EXPECT_EQ(tool::clips_not_met(*written), 1u);
  EXPECT_EQ(written->clips[0].certificate.kept_keys, written->clips[0].certificate.source_keys);
  EXPECT_TRUE(written->clips[1].certificate.is_met());
}

TEST(convert_budget, no_file_grows_and_integers_stay_integers) {
  for (const auto& path : files_for_tests("models", {".gltf", ".glb"})) {
    ImportOptions carrying;
    carrying.decode_images = carrying.make_tangents = false;
    carrying.carry_document = true;
    const auto file = import_gltf(path, carrying);
    if (!file || file->scene.animations.empty() || file->scene.animations.size() > 12) continue;
    RewriteOptions plain;
    plain.drop = {"all"};
    const auto whole = rewrite_gltf(*file, plain);
    const double budget_m = 1e-3 * tool::model_size_m(file->scene);
    const auto written = tool::write_within(*file, file->scene.animations, plain, budget_m);
    ASSERT_TRUE(whole && written) << path;
    EXPECT_LE(written->file.file.size(), whole->file.size()) << path;
    EXPECT_EQ(tool::clips_not_met(*written), 0u) << path;
  }
}

TEST(convert_budget, cameras_turn_by_less_than_a_pixel) {
  TinyGltf gltf;
  gltf.root["nodes"] = Json::array({{{"camera", 0}}});
  gltf.root["cameras"] = Json::array({{{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 0.1}}}}});
  std::vector<float> times, rotations;
  for (int k = 0; k < 200; ++k) {
    const float half = 0.25f * std::sin(0.03f * static_cast<float>(k));
    times.push_back(static_cast<float>(k) / 30.0f);
    rotations.insert(rotations.end(), {0.0f, std::sin(half), 0.0f, std::cos(half)});
  }
  gltf.animate("rotation", gltf.times(times), gltf.vec4(rotations));
  const ToolModelFile model;
  std::ofstream(model.beside("camera.gltf")) << gltf.text();
  for (const char* budget : {"1mm", "10cm"}) {
    ASSERT_EQ(run_tool({"convert", model.beside("camera.gltf"), model.beside("out.glb"), "--budget", budget}).status,
              0);
    const auto before = import_gltf(std::filesystem::path(model.beside("camera.gltf"))),
               after = import_gltf(std::filesystem::path(model.beside("out.glb")));
    ASSERT_TRUE(before && after);
    const QuatTrack &a = before->scene.animations[0].bones[0].rotation,
                    &b = after->scene.animations[0].bones[0].rotation;
    EXPECT_LT(b.key_count(), 150u);
    double worst = 0.0;
    for (int i = 0; i < 1000; ++i) {
      const double time_s = before->scene.animations[0].duration_s * i / 999.0;
      const Quat<double> x = sample_track<double>(a, time_s), y = aligned_with(x, sample_track<double>(b, time_s));
      worst = std::max(worst, 2.0 * std::sqrt(quat_dot(x - y, x - y)));
    }
    EXPECT_LT(worst, 0.05 * M_PI / 180.0) << budget;
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

}  // namespace
}  // namespace sinew::test
