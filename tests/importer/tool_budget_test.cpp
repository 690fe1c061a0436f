// SPDX-License-Identifier: MIT
// Clips within the budgets that users give on the command line.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <span>
#include <string_view>

#include <fmt/format.h>

#include "importer/import_gltf.h"
#include "importer/tool/length_text.h"
#include "importer/tool/model_size.h"
#include "runtime/asset_file/read_assets.h"
#include "runtime/clip/clip_file.h"
#include "runtime/clip/unpack_clip.h"
#include "runtime/compress/compile_clip_within.h"
#include "runtime/lod/clip_bounds.h"
#include "tests/asset_file/played_frames.h"
#include "tests/importer/tool_model.h"
#include "tests/reference/clip_error.h"
#include "tests/support/corpus.h"
#include "tests/support/file_text.h"

namespace sinew::test {
namespace {
using testing::HasSubstr;

TEST(length_text, reads_lengths_with_and_without_units) {
  const std::pair<const char*, double> good[] = {{"0.1mm", 1e-4}, {"0.1 mm", 1e-4}, {"1e-4", 1e-4}, {"0.001m", 1e-3},
                                                 {"2cm", 0.02},   {"50um", 5e-5},   {"0", 0.0},     {"1e-3mm", 1e-6}};
  for (const auto& [text, metres] : good) {
    const auto read = tool::parse_length(text);
    ASSERT_TRUE(read) << text;
    EXPECT_DOUBLE_EQ(read->metres, metres) << text;
    EXPECT_EQ(read->of_model, 0.0) << text;
  }
}

TEST(length_text, reads_shares_of_the_model) {
  for (const char* text : {"0.01%", "0.01 %", "1e-2%"}) {
    const auto read = tool::parse_length(text);
    ASSERT_TRUE(read) << text;
    EXPECT_DOUBLE_EQ(read->of_model, 1e-4) << text;
    EXPECT_EQ(read->metres, 0.0) << text;
  }
}

TEST(length_text, refuses_what_is_no_length_and_says_what_would_be) {
  for (const char* text :
       {"", "mm", "-1mm", "0.1inch", "1e999", "nan", "inf", "0.1mmm", "0,1mm", "1 m m", "%", "-1%", "1%%", "1% m"}) {
    const auto read = tool::parse_length(text);
    ASSERT_FALSE(read) << text;
    EXPECT_THAT(read.error(), HasSubstr("0.1mm"));
  }
}

TEST(length_text, reads_angles_and_ratios) {
  EXPECT_DOUBLE_EQ(tool::parse_angle("1deg").value(), M_PI / 180.0);
  EXPECT_DOUBLE_EQ(tool::parse_angle("0.5").value(), M_PI / 360.0);
  EXPECT_DOUBLE_EQ(tool::parse_angle("0.25 rad").value(), 0.25);
  for (const char* text : {"", "deg", "-1deg", "181deg", "4rad", "1mm", "nan"}) {
    ASSERT_FALSE(tool::parse_angle(text)) << text;
    EXPECT_THAT(tool::parse_angle(text).error(), HasSubstr("1deg"));
  }
  EXPECT_DOUBLE_EQ(tool::parse_ratio("0.01").value(), 0.01);
  EXPECT_DOUBLE_EQ(tool::parse_ratio("1%").value(), 0.01);
  for (const char* text : {"", "-1", "1mm", "inf"}) EXPECT_FALSE(tool::parse_ratio(text)) << text;
}

TEST(length_text, writes_lengths_in_a_unit_that_fits) {
  EXPECT_EQ(tool::length_text(1e-4), "0.1 mm");
  EXPECT_EQ(tool::length_text(9.7e-5), "97 um");
  EXPECT_EQ(tool::length_text(2.0), "2 m");
  EXPECT_EQ(tool::length_text(0.0), "0");
}

TEST(compile_command, writes_an_asset_file_that_info_tells_about_and_whose_clips_keep_their_budget) {
  const ToolModelFile model;
  const std::string out = model.beside("model.sinew");
  const CommandOutcome compiled = run_tool({"compile", model.path(), "-o", out, "--budget", "0.2mm"});
  ASSERT_EQ(compiled.status, 0) << compiled.err;
  for (const char* text : {"asked", "measured", "0.2 mm", "bend", "talk", "2 clips"})
    EXPECT_THAT(compiled.out, HasSubstr(text));
  const CommandOutcome info = run_tool({"info", out});
  ASSERT_EQ(info.status, 0) << info.err;
  for (const char* text : {"asset file, version 1: 4 blocks, 2 clips", "skeleton", "bounds", "joints 4, meshes 2",
                           "memory: ", "(skeletons ", "0.2 mm", "bend"})
    EXPECT_THAT(info.out, HasSubstr(text));
  const auto json = nlohmann::json::parse(run_tool({"info", out, "--json"}).out);
  ASSERT_EQ(json.at("compiled_clips").size(), 2u);
  EXPECT_LE(json["compiled_clips"][0]["certificate"]["measured_m"].get<double>(), 2e-4);
  EXPECT_EQ(json["compiled_clips"][0]["certificate"]["asked_m"].get<double>(), 2e-4);
}

/// Changes a byte of a file.
void spoil(const std::string& path, std::streamoff at) {
  std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
  file.seekp(at);
  file.put('?');
}

TEST(compile_command, damaged_files_are_refused_by_rule_and_place) {
  const ToolModelFile model;
  const std::string out = model.beside("model.sinew");
  ASSERT_EQ(run_tool({"compile", model.path(), "-o", out}).status, 0);
  EXPECT_EQ(run_tool({"check", out}).status, 0);
  spoil(out, 600);
  const CommandOutcome info = run_tool({"info", out}), checked = run_tool({"check", out});
  EXPECT_EQ(info.status, 1);
  EXPECT_THAT(info.err, HasSubstr("asset-checksum in block skeleton, byte 0: "));
  EXPECT_EQ(checked.status, 1);
  EXPECT_THAT(checked.out, HasSubstr("asset-checksum"));
  EXPECT_THAT(checked.out, HasSubstr("block skeleton, byte 0: "));
  EXPECT_EQ(run_tool({"compile", model.path(), "-o", model.path()}).status, 2);
  EXPECT_EQ(run_tool({"compile", model.path(), "-o", out, "--budget", "-1"}).status, 2);
  EXPECT_EQ(run_tool({"compile", model.beside("missing.glb"), "-o", out}).status, 1);
}

TEST(compile_command, the_file_plays_what_the_model_plays) {
  const ToolModelFile model;
  const std::string out = model.beside("model.sinew");
  ASSERT_EQ(run_tool({"compile", model.path(), "-o", out, "--budget", "0", "--zstd", "3", "--truth"}).status, 0);
  const std::string bytes = text_of_file(out);
  const auto file = AssetFile::open(std::as_bytes(std::span(bytes)));
  ASSERT_TRUE(file);
  EXPECT_NE(file->find(AssetKind::animations), nullptr);
  const auto scene = read_scene(*file);
  ASSERT_TRUE(scene) << describe(scene.error());
  const auto imported = import_gltf(model.path(), {.decode_images = false});
  ASSERT_TRUE(imported);
  EXPECT_EQ(hashes_of_frames(*scene), hashes_of_frames(imported->scene));
}

TEST(compile_command, pages_play_what_whole_clips_play) {
  const ToolModelFile model;
  const std::string whole = model.beside("whole.sinew"), paged = model.beside("paged.sinew");
  ASSERT_EQ(run_tool({"compile", model.path(), "-o", whole}).status, 0);
  ASSERT_EQ(run_tool({"compile", model.path(), "-o", paged, "--page", "0.25"}).status, 0);
  const std::string bytes = text_of_file(paged);
  const auto file = AssetFile::open(std::as_bytes(std::span(bytes)));
  ASSERT_TRUE(file);
  EXPECT_NE(file->find(AssetKind::page_keys), nullptr);
  EXPECT_EQ(run_tool({"check", paged}).status, 0);
  EXPECT_THAT(run_tool({"info", paged}).out, HasSubstr("page_keys"));
  const std::string whole_bytes = text_of_file(whole);
  const auto from_pages = read_scene(*file),
             from_whole = read_scene(*AssetFile::open(std::as_bytes(std::span(whole_bytes))));
  ASSERT_TRUE(from_pages && from_whole);
  EXPECT_EQ(hashes_of_frames(*from_pages), hashes_of_frames(*from_whole));
  EXPECT_EQ(run_tool({"compile", model.path(), "-o", paged, "--page", "0"}).status, 2);
}

TEST(compile_command, zstd_takes_fewer_bytes_for_the_same_assets) {
  const ToolModelFile model;
  const std::string plain = model.beside("plain.sinew"), packed = model.beside("packed.sinew");
  ASSERT_EQ(run_tool({"compile", model.path(), "-o", plain}).status, 0);
  ASSERT_EQ(run_tool({"compile", model.path(), "-o", packed, "--zstd", "3"}).status, 0);
  const std::string plain_bytes = text_of_file(plain), packed_bytes = text_of_file(packed);
  EXPECT_LT(packed_bytes.size(), plain_bytes.size());
  const auto a = read_scene(*AssetFile::open(std::as_bytes(std::span(plain_bytes)))),
             b = read_scene(*AssetFile::open(std::as_bytes(std::span(packed_bytes))));
  ASSERT_TRUE(a && b);
  EXPECT_EQ(hashes_of_frames(*a), hashes_of_frames(*b));
}

TEST(compile_command, levels_of_detail_are_stored_with_what_they_cost) {
  const ToolModelFile model;
  const std::string out = model.beside("levels.sinew");
  const CommandOutcome made =
      run_tool({"compile", model.path(), "-o", out, "--joint-tolerance", "0", "--joint-tolerance", "100m"});
  ASSERT_EQ(made.status, 0) << made.err;
  EXPECT_THAT(made.out, HasSubstr("skeleton LOD within 100 m: "));
  const std::string bytes = text_of_file(out);
  const auto file = AssetFile::open(std::as_bytes(std::span(bytes)));
  ASSERT_TRUE(file);
  const auto lods = read_skeleton_lods(*file, *read_skeleton(*file));
  ASSERT_TRUE(lods);
  ASSERT_EQ(lods->size(), 2u);
  EXPECT_EQ((*lods)[0].tolerance_m, 0.0);
  EXPECT_EQ((*lods)[1].tolerance_m, 100.0);
  EXPECT_GT((*lods)[1].left_out, (*lods)[0].left_out);
  EXPECT_THAT(run_tool({"info", out}).out, HasSubstr("skeleton LOD within 100 m: "));
  EXPECT_THAT(run_tool({"info", out, "--json"}).out, HasSubstr("\"tolerance_m\": 100.0"));
  const CommandOutcome wrong = run_tool({"compile", model.path(), "-o", out, "--joint-tolerance", "much"});
  EXPECT_EQ(wrong.status, 2);
  EXPECT_THAT(wrong.err, HasSubstr("--joint-tolerance"));
}

TEST(compile_command, the_file_knows_where_meshes_are_while_its_clips_play) {
  const ToolModelFile model;
  const std::string out = model.beside("model.sinew");
  ASSERT_EQ(run_tool({"compile", model.path(), "-o", out, "--budget", "5mm"}).status, 0);
  const std::string bytes = text_of_file(out);
  const auto read = read_scene(*AssetFile::open(std::as_bytes(std::span(bytes))));
  ASSERT_TRUE(read);
  const auto boxes = read_clip_boxes(*AssetFile::open(std::as_bytes(std::span(bytes))), *read);
  ASSERT_TRUE(boxes);
  ASSERT_EQ(boxes->size(), 2u);
  auto imported = import_gltf(model.path(), {.decode_images = false});
  ASSERT_TRUE(imported);
  imported->scene.clips = read->clips;  // with their errors, which bounds hold too
  for (std::uint32_t clip = 0; clip < 2; ++clip) {
    const std::vector<Aabb> of_truth = clip_bounds(imported->scene, {}, clip),
                            of_file = clip_bounds(*read, {}, clip, boxes->at(clip));
    ASSERT_EQ(of_truth.size(), of_file.size());
    for (std::size_t i = 0; i < of_truth.size(); ++i) {
      EXPECT_EQ(of_file[i].lower, of_truth[i].lower) << i;
      EXPECT_EQ(of_file[i].upper, of_truth[i].upper) << i;
    }
  }
}

TEST(compile_command, parts_of_a_model_are_files_of_one_skeleton) {
  const ToolModelFile model;
  const std::string body = model.beside("body.sinew"), clips = model.beside("clips.sinew");
  ASSERT_EQ(run_tool({"compile", model.path(), "-o", body, "--parts", "skeleton,model"}).status, 0);
  ASSERT_EQ(run_tool({"compile", model.path(), "-o", clips, "--parts", "clips"}).status, 0);
  EXPECT_EQ(run_tool({"compile", model.path(), "-o", clips, "--parts", "bones"}).status, 2);
  const auto of_body = nlohmann::json::parse(run_tool({"info", body, "--json"}).out),
             of_clips = nlohmann::json::parse(run_tool({"info", clips, "--json"}).out);
  EXPECT_EQ(of_body["asset_file"]["skeleton_signature"], of_clips["asset_file"]["skeleton_signature"]);
  EXPECT_EQ(of_body["compiled_clips"].size(), 0u);
  EXPECT_EQ(of_body["model"]["meshes"], 2);
  EXPECT_EQ(of_clips["compiled_clips"].size(), 2u);
  EXPECT_FALSE(of_clips.contains("model"));
  EXPECT_EQ(run_tool({"check", clips}).status, 0);
}

TEST(compile_command, info_and_check_know_files_of_compiled_clips_alone) {
  const ToolModelFile model;
  const auto imported = import_gltf(model.path());
  ASSERT_TRUE(imported);
  const Clip* saved[] = {&imported->scene.clips[0], &imported->scene.clips[1]};
  const std::string out = model.beside("clips.sinew");
  const std::vector<std::byte> bytes = save_clips(saved);
  std::ofstream(out, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  EXPECT_THAT(run_tool({"info", out}).out, HasSubstr("compiled clips, version 4: 2"));
  EXPECT_EQ(run_tool({"check", out}).status, 0);
  spoil(out, 100);
  EXPECT_THAT(run_tool({"info", out}).err, HasSubstr("byte 24: clip-checksum: "));
  EXPECT_THAT(run_tool({"check", out}).out, HasSubstr("clip-checksum"));
}

TEST(compile_command, same_input_gives_the_same_file_and_the_same_words) {
  const ToolModelFile model;
  const std::string out = model.beside("clips.sinew");
  std::string files[2], words[2];
  for (int i = 0; i < 2; ++i) {
    words[i] = run_tool({"compile", model.path(), "-o", out}).out;
    words[i] += run_tool({"info", out}).out;
    words[i] += run_tool({"info", out, "--json"}).out;
    files[i] = text_of_file(out);
  }
  EXPECT_FALSE(files[0].empty());
  EXPECT_EQ(files[0], files[1]);
  EXPECT_EQ(words[0], words[1]);
  EXPECT_THAT(words[0], testing::Not(HasSubstr("ns/joint"))) << "times of this machine";
}

TEST(compile_command, takes_the_clips_that_are_named_each_once) {
  const ToolModelFile model;
  const std::string out = model.beside("clips.sinew");
  const auto names = [&](std::vector<std::string> clips) {
    std::vector<std::string> arguments{"compile", "-o", out};
    for (const std::string& clip : clips) arguments.insert(arguments.end(), {"--clip", clip});
    arguments.push_back(model.path());
    const CommandOutcome outcome = run_tool(arguments);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    std::vector<std::string> found;
    const auto info = nlohmann::json::parse(run_tool({"info", out, "--json"}).out);
    for (const auto& clip : info.at("compiled_clips")) found.push_back(clip.at("name"));
    return found;
  };
  EXPECT_THAT(names({}), testing::ElementsAre("bend", "talk"));
  EXPECT_THAT(names({"talk"}), testing::ElementsAre("talk"));
  EXPECT_THAT(names({"talk", "0", "1"}), testing::ElementsAre("talk", "bend"));
  for (const char* wrong : {"jump", "none", "2"}) {
    const CommandOutcome outcome = run_tool({"compile", model.path(), "-o", out, "--clip", wrong});
    EXPECT_EQ(outcome.status, 2) << wrong;
    EXPECT_THAT(outcome.err, HasSubstr("--clip " + std::string(wrong)));
  }
}

/// The box around the model at rest is 3 m long: the strip begins at 0, the face ends at 3.
TEST(budgets, may_be_shares_of_the_model) {
  const ToolModelFile model;
  const double size_m = tool::model_size_m(import_gltf(std::filesystem::path(model.path()))->scene);
  ASSERT_GT(size_m, 1.5);
  const std::string metres = fmt::format("{:.17g}", 0.001 * size_m);
  for (const auto& [command, ending] : {std::pair("compile", ".sinew"), {"bake", ".sgeo"}, {"convert", ".glb"}}) {
    const std::string share = model.beside(std::string("share") + ending),
                      plain = model.beside(std::string("plain") + ending);
    std::vector<std::string> arguments{command, model.path(), "--budget"};
    const auto run = [&, command = command](const std::string& budget, const std::string& out) {
      std::vector<std::string> all = arguments;
      all.push_back(budget);
      if (std::string_view(command) != "convert") all.push_back("-o");
      all.push_back(out);
      if (std::string_view(command) == "bake") all.insert(all.end(), {"--clip", "0"});
      const CommandOutcome outcome = run_tool(all);
      EXPECT_EQ(outcome.status, 0) << command << outcome.err;
      return outcome.out.substr(0, outcome.out.rfind('\n', outcome.out.size() - 2));
    };
    EXPECT_EQ(run("0.1%", share), run(metres, plain)) << command;
    EXPECT_FALSE(text_of_file(share).empty());
    EXPECT_EQ(text_of_file(share), text_of_file(plain)) << command;
  }
}

TEST(budgets, of_a_mesh_without_a_scene_are_shares_of_its_first_frame) {
  const ToolModelFile model;
  for (const char* frame : {"1", "2"})
    std::ofstream(model.beside(std::string("cloth_") + frame + ".obj"))
        << "v 0 0 0\nv 4 0 0\nv 0 " << frame << " 0\nf 1 2 3\n";
  const std::string share = model.beside("share.sgeo"), plain = model.beside("plain.sgeo");
  ASSERT_EQ(run_tool({"bake", model.beside("cloth_1.obj"), "--budget", "1%", "-o", share}).status, 0);
  ASSERT_EQ(run_tool({"bake", model.beside("cloth_1.obj"), "--budget", "4cm", "-o", plain}).status, 0);
  EXPECT_EQ(text_of_file(share), text_of_file(plain));
}

TEST(budgets, of_verify_and_plan_may_be_shares_too) {
  const ToolModelFile model;
  const std::string golden = model.beside("golden.json");
  ASSERT_EQ(run_tool({"sample", model.path(), "-o", golden}).status, 0);
  auto poses = nlohmann::json::parse(text_of_file(golden));
  poses["extent"] = 4.0;
  auto& x = poses["clips"][0]["samples"][0]["nodes"][0]["world"][12];
  x = x.get<double>() + 0.1;
  std::ofstream(golden) << poses;
  EXPECT_NE(run_tool({"verify", model.path(), golden, "--tolerance", "2%"}).status, 0);
  EXPECT_EQ(run_tool({"verify", model.path(), golden, "--tolerance", "3%"}).status, 0);
  EXPECT_EQ(run_tool({"verify", model.path(), golden, "--tolerance", "11cm"}).status, 0);
  const auto left_out = [&](const char* tolerance) {
    const auto outcome = run_tool({"plan", model.path(), "--json", "--joint-tolerance", tolerance});
    return nlohmann::json::parse(outcome.out)["left_out_joints"];
  };
  EXPECT_EQ(left_out("0%"), left_out("0"));
  EXPECT_NE(left_out("1000%"), left_out("0"));
}

/// At times that the compiler did not look at.
TEST(convert_budget_corpus, every_clip_of_every_model_stays_within_its_budget) {
  constexpr double kBudget = 1e-3;
  FixedRandom random(13);
  std::size_t clips = 0;
  for (const auto& path : files_for_tests("models", {".gltf", ".glb"})) {
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
