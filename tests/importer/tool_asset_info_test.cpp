// SPDX-License-Identifier: MIT
// Text and JSON of `sinew info` for asset files: every entry of the document and every line of the tables.
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include <fmt/format.h>

#include "importer/tool/assets/asset_info.h"
#include "importer/tool/certificate_table.h"
#include "importer/tool/info/memory_kinds.h"
#include "runtime/asset_file/asset_file.h"
#include "runtime/asset_file/write_asset_file.h"
#include "runtime/clip/clip_file.h"
#include "tests/asset_file/full_scene.h"
#include "tests/importer/tool_json.h"
#include "tests/importer/tool_model.h"
#include "tests/support/json.h"

namespace sinew::test {
namespace {

/// A small scene whose first clip has a certificate.
Scene certified_scene() {
  Scene scene = full_scene(3);
  scene.clips[0] = with_certificate(scene.clips[0], {.asked_m = 1e-3,
                                                     .measured_m = 2e-3,
                                                     .weights_m = 5e-4,
                                                     .worst_time_s = 0.5,
                                                     .worst_joint = 4,
                                                     .times_checked = 33,
                                                     .animated_joints = 3,
                                                     .source_keys = 40,
                                                     .kept_keys = 30,
                                                     .source_bytes = 5000,
                                                     .bytes = 4000});
  return scene;
}

tool::AssetInfo info_of(const std::vector<std::byte>& bytes) {
  const ToolModelFile model;
  const std::string file = model.beside("a.sinew");
  std::ofstream(file, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  auto info = tool::asset_info(file);
  EXPECT_TRUE(info && *info);
  if (!info || !*info) return {};
  (*info)->json["file"] = std::filesystem::path((*info)->json["file"].get<std::string>()).filename().string();
  return **std::move(info);
}

TEST(tool_asset_info, of_compiled_clips_alone) {
  const Scene scene = certified_scene();
  const Clip& first = scene.clips[0];
  const Clip* const saved[] = {&first, &scene.clips[1]};
  const std::vector<std::byte> bytes = save_clips(saved);
  const tool::AssetInfo info = info_of(bytes);
  const auto clip = [](const Clip& of) {
    return Json{{"name", of.name()},
                {"duration_s", of.duration_s()},
                {"joints", 9},
                {"weights", of.weight_count()},
                {"properties", of.property_count()},
                {"bytes", of.byte_size()},
                {"events", Json::array()},
                {"curves", Json::array()}};
  };
  Json with = clip(first), without = clip(scene.clips[1]);
  without["certificate"] = nullptr;
  with["certificate"] = {
      {"asked_m", 1e-3},      {"measured_m", 2e-3}, {"weights_m", 5e-4},
      {"is_met", false},      {"worst_joint", 4},   {"worst_time_s", 0.5},
      {"times_checked", 33},  {"source_keys", 40},  {"kept_keys", 30},
      {"source_bytes", 5000}, {"bytes", 4000},      {"bytes_per_joint_second", 4000.0 / (3.0 * first.duration_s())}};
  EXPECT_EQ(Json(parsed(info.json)),
            (Json{{"file", "a.sinew"}, {"version", 4}, {"bytes", bytes.size()}, {"compiled_clips", {with, without}}}));
  EXPECT_EQ(info.headline, fmt::format("compiled clips, version 4: 2 in {} bytes", bytes.size()));
  EXPECT_EQ(info.tables, tool::certificate_table(scene.clips, {}));
}

TEST(tool_asset_info, of_blocks_and_what_the_model_has) {
  const Scene scene = certified_scene();
  CompiledSkeletonLod lod;
  lod.detail.kept.assign(9, true);
  lod.tolerance_m = 0.5;
  lod.measured_m = 0.25;
  const std::vector<CompiledSkeletonLod> lods = {lod};
  const std::vector<std::byte> bytes = write_asset_file(scene, {.truth = true, .skeleton_lods = lods, .zstd_level = 3});
  const tool::AssetInfo info = info_of(bytes);
  const auto opened = AssetFile::open(bytes);
  ASSERT_TRUE(opened);
  const std::string signature = fmt::format("{:016x}", opened->blocks()[0].skeleton_signature);
  EXPECT_EQ(parsed(info.json)["asset_file"]["version"], 1);
  EXPECT_EQ(parsed(info.json)["asset_file"]["skeleton_signature"], signature);
  EXPECT_EQ(parsed(info.json)["bytes"], bytes.size());
  EXPECT_EQ(info.headline, fmt::format("asset file, version 1: 5 blocks, {} clips, {} bytes, skeleton {}",
                                       scene.clips.size(), bytes.size(), signature));
  std::istringstream lines(info.tables);
  std::string line;
  std::getline(lines, line);
  std::size_t packed = 0;
  for (std::size_t b = 0; b < opened->blocks().size(); ++b) {
    const AssetBlock& block = opened->blocks()[b];
    EXPECT_EQ(Json(parsed(info.json)["asset_file"]["blocks"][b]), (Json{{"kind", name_of(block.kind)},
                                                                        {"version", block.version},
                                                                        {"offset", block.offset},
                                                                        {"stored_bytes", block.stored_bytes},
                                                                        {"bytes", block.bytes},
                                                                        {"packed", block.is_packed}}));
    std::getline(lines, line);
    std::istringstream words(line);
    std::string kind;
    std::uint64_t version = 0, offset = 0, stored = 0, unpacked = 0;
    words >> kind >> version >> offset >> stored;
    EXPECT_EQ(kind, name_of(block.kind));
    EXPECT_EQ(version, block.version);
    EXPECT_EQ(offset, block.offset);
    EXPECT_EQ(stored, block.stored_bytes);
    EXPECT_EQ(static_cast<bool>(words >> unpacked), block.is_packed);
    if (block.is_packed) {
      EXPECT_EQ(unpacked, block.bytes);
    }
    packed += block.is_packed;
  }
  EXPECT_GT(packed, 0u);

  std::size_t primitives = 0, vertices = 0, targets = 0;
  for (const Mesh& mesh : scene.meshes) {
    targets += mesh.target_count();
    for (const Primitive& primitive : mesh.primitives) {
      ++primitives;
      vertices += primitive.vertex_count();
    }
  }
  EXPECT_GT(primitives, scene.meshes.size());
  EXPECT_EQ(Json(parsed(info.json)["model"]), (Json{{"joints", 9},
                                                    {"meshes", scene.meshes.size()},
                                                    {"primitives", primitives},
                                                    {"vertices", vertices},
                                                    {"morph_targets", targets},
                                                    {"skins", scene.skins.size()},
                                                    {"instances", scene.instances.size()},
                                                    {"materials", 2},
                                                    {"images", 2},
                                                    {"animations", scene.animations.size()}}));
  std::getline(lines, line);
  EXPECT_EQ(line,
            fmt::format("  joints 9, meshes {}, primitives {}, vertices {}, morph_targets {}, skins {}, instances {}, "
                        "materials 2, images 2, animations {}",
                        scene.meshes.size(), primitives, vertices, targets, scene.skins.size(), scene.instances.size(),
                        scene.animations.size()));
  EXPECT_EQ(Json(parsed(info.json)["skeleton_lods"]),
            Json::array({{{"tolerance_m", 0.5}, {"measured_m", 0.25}, {"left_out", 0}}}));
  std::getline(lines, line);
  EXPECT_EQ(line, "skeleton LOD within 500 mm: 0 of 9 joints left out, measured 250 mm");
  std::getline(lines, line);
  EXPECT_EQ(line + '\n', "  " + tool::memory_text(info.json["memory"]));
  EXPECT_EQ(info.json["compiled_clips"].size(), scene.clips.size());
  EXPECT_TRUE(info.tables.ends_with(tool::certificate_table(scene.clips, scene.skeleton.names)));
}

TEST(tool_asset_info, of_a_skeleton_alone) {
  const std::vector<std::byte> bytes = write_asset_file(certified_scene(), {.model = false, .clips = false});
  const tool::AssetInfo plain = info_of(bytes);
  EXPECT_EQ(parsed(plain.json)["asset_file"]["blocks"].size(), 1u);
  EXPECT_EQ(parsed(plain.json)["asset_file"]["blocks"][0]["packed"], false);
  EXPECT_EQ(plain.tables.find("unpacked"), std::string::npos) << "the same size twice";
  EXPECT_TRUE(parsed(plain.json)["compiled_clips"].empty());
  EXPECT_FALSE(plain.json.contains("skeleton_lods"));
}

}  // namespace
}  // namespace sinew::test
