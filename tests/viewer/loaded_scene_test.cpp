// SPDX-License-Identifier: MIT
// Files as the viewer loads them: the chosen scene, messages, and the needs for the runtime.
#include "viewer/app/open/open_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>

#include "tests/geometry_cache/takes.h"
#include "tests/scenes/hand_scenes.h"
#include "viewer/app/camera/framed_camera.h"
#include "viewer/passes/frame_uniforms.h"

namespace sinew::viewer {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class loaded : public testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder_); }
  void TearDown() override { fs::remove_all(folder_); }

  tl::expected<std::vector<LoadedScene>, LoadError> load(const std::string& json, Options options = {}) {
    options.file = (folder_ / "thing.gltf").string();
    std::ofstream(options.file) << json;
    messages_.clear();
    parts_.clear();
    return load_scenes(
        options, [this](const std::string& line) { messages_.push_back(line); },
        [this](double done) { parts_.push_back(done); });
  }

  fs::path folder_ = fs::temp_directory_path() / ("scene" + std::to_string(::getpid()));
  std::vector<std::string> messages_;
  std::vector<double> parts_;
};

constexpr const char* kTwoScenes =
    R"({"asset": {"version": "2.0"}, "scene": 1, "materials": [{"name": "plain"}], "scenes": [{"nodes": [0]}, {"nodes": [1]}],
        "nodes": [{"name": "first"}, {"name": "second"}]})";

TEST_F(loaded, has_the_name_of_its_file_and_tells_of_other_scenes) {
  const auto shown = load(kTwoScenes);
  ASSERT_TRUE(shown) << shown.error().message;
  ASSERT_EQ(shown->size(), 1u);
  EXPECT_EQ(shown->front().name, "thing.gltf");
  EXPECT_EQ(cache_duration_s(shown->front()), 0.0);
  EXPECT_THAT(messages_, ElementsAre(HasSubstr("2 scenes; scene 1 is shown")));
  EXPECT_THAT(parts_, testing::Not(IsEmpty()));
  Options first;
  first.scene = 0;
  EXPECT_TRUE(load(kTwoScenes, first));
  EXPECT_THAT(messages_, IsEmpty()) << "it was asked for";
  EXPECT_TRUE(load(R"({"asset": {"version": "2.0"}, "scenes": [{"nodes": [0]}], "nodes": [{"name": "only"}]})"));
  EXPECT_THAT(messages_, IsEmpty()) << "there is no other";
}

TEST_F(loaded, of_a_scene_that_the_file_has_not_names_those_that_it_has) {
  Options options;
  options.scene = 2;
  const auto none = load(kTwoScenes, options);
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().exit_code, 2);
  EXPECT_THAT(none.error().message, HasSubstr("scenes 0 to 1"));
  const auto empty = load(R"({"asset": {"version": "2.0"}})", options);
  ASSERT_FALSE(empty);
  EXPECT_THAT(empty.error().message, HasSubstr("no scenes"));
}

TEST_F(loaded, of_a_file_that_cannot_be_read_says_why) {
  const auto none = load("{");
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().exit_code, 1);
  EXPECT_THAT(none.error().message, HasSubstr("thing.gltf"));
  Options options;
  options.environment = "no/sky.hdr";
  const auto dark = load(kTwoScenes, options);
  ASSERT_FALSE(dark);
  EXPECT_EQ(dark.error().exit_code, 1);
  EXPECT_THAT(dark.error().message, HasSubstr("no/sky.hdr: there is no such file"));
}

TEST_F(loaded, without_a_file_is_one_of_the_built_in_scenes) {
  Options options;
  options.environment = "plain";
  const auto log_line = [this](const std::string& line) { messages_.push_back(line); };
  const auto all = load_scenes(options, log_line, {});
  ASSERT_TRUE(all) << all.error().message;
  EXPECT_THAT(messages_, IsEmpty());
  for (const LoadedScene& shown : *all) {
    EXPECT_FALSE(shown.name.empty() || shown.note.empty());
    EXPECT_EQ(shown.environment, plain_environment()) << shown.name;
  }
  options.scene = static_cast<std::uint32_t>(all->size()) - 1;
  EXPECT_TRUE(load_scenes(options, log_line, {})) << "the last one";
  options.scene = static_cast<std::uint32_t>(all->size());
  const auto none = load_scenes(options, log_line, {});
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().exit_code, 2);
  EXPECT_THAT(none.error().message, HasSubstr("--scene " + std::to_string(all->size()) +
                                              ": the built-in scenes are 0 to " + std::to_string(all->size() - 1)));
}

constexpr const char* kWithBuffer =
    R"({"asset": {"version": "2.0"}, "buffers": [{"uri": "part.bin", "byteLength": 4}], "nodes": [{"name": "first"}]})";

TEST_F(loaded, knows_the_files_that_it_was_read_from) {
  std::ofstream(folder_ / "part.bin") << "four";
  const auto shown = load(kWithBuffer);
  ASSERT_TRUE(shown) << shown.error().message;
  EXPECT_THAT(shown->front().files,
              testing::UnorderedElementsAre(folder_ / "thing.gltf", fs::canonical(folder_) / "part.bin"));
}

TEST_F(loaded, is_read_again_in_the_same_light) {
  const auto first = load(kTwoScenes);
  ASSERT_TRUE(first);
  Options options;
  options.file = (folder_ / "thing.gltf").string();
  const auto log_line = [this](const std::string& line) { messages_.push_back(line); };
  const auto again = reload_scene(options, first->front().environment, log_line);
  ASSERT_TRUE(again) << again.error().message;
  EXPECT_EQ(again->environment, first->front().environment);
  EXPECT_EQ(again->scene.skeleton.parents.size(), first->front().scene.skeleton.parents.size());
  EXPECT_THAT(messages_.back(), HasSubstr("2 scenes; scene 1 is shown"));
  std::ofstream(options.file) << "{";
  const auto broken = reload_scene(options, nullptr, log_line);
  ASSERT_FALSE(broken);
  EXPECT_THAT(broken.error().message, HasSubstr("thing.gltf"));
}

/// A triangle that is called "mesh".
constexpr const char* kTriangle =
    R"({"asset": {"version": "2.0"}, "nodes": [{"mesh": 0}],
        "meshes": [{"name": "mesh", "primitives": [{"attributes": {"POSITION": 0}}]}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]}],
        "bufferViews": [{"buffer": 0, "byteLength": 36}],
        "buffers": [{"byteLength": 36, "uri": "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]})";

class scene_of_a_cache : public loaded {
 protected:
  /// A cache of a second with a mesh of three vertices; returns its path.
  std::string cache(const std::string& mesh) const {
    GeometryTake take =
        test::take_of({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 0, 1}, {1, 0, 1}, {0, 1, 1}}}, {0, 1, 2});
    take.meshes[0].name = mesh;
    take.frame_s = 1.0;
    const auto bytes = encode_geometry_cache(take, {});
    std::string path = (folder_ / (mesh + ".sgeo")).string();
    std::ofstream(path, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes->data()), static_cast<std::streamsize>(bytes->size()));
    return path;
  }
  static std::string refusal(const Options& options, int code) {
    const auto none = load_scenes(options, [](const std::string&) {}, {});
    if (none) return "none";
    EXPECT_EQ(none.error().exit_code, code);
    return none.error().message;
  }
};

TEST_F(scene_of_a_cache, shows_it_alone) {
  Options options;
  options.file = cache("mesh");
  const auto shown = load_scenes(options, [](const std::string&) {}, {});
  ASSERT_TRUE(shown) << shown.error().message;
  const LoadedScene& alone = shown->at(0);
  EXPECT_EQ(alone.name, "mesh.sgeo");
  EXPECT_EQ(alone.scene.meshes.size(), 1u);
  EXPECT_THAT(alone.files, ElementsAre(options.file));
  EXPECT_EQ(cache_duration_s(alone), 1.0);
  const Needs needs = needs_of(alone, {});
  EXPECT_THAT(needs.in.cached_instances, ElementsAre(0));
  EXPECT_TRUE(needs.out.stage_times) << "decoding is a stage";
}

TEST_F(scene_of_a_cache, plays_it_over_a_file) {
  Options options;
  options.cache = cache("mesh");
  const auto shown = load(kTriangle, options);
  ASSERT_TRUE(shown) << shown.error().message;
  EXPECT_EQ(shown->at(0).name, "thing.gltf");
  EXPECT_EQ(cache_duration_s(shown->at(0)), 1.0);
  EXPECT_THAT(shown->at(0).files, testing::Contains(fs::path(options.cache))) << "which --watch watches";
}

TEST_F(scene_of_a_cache, says_what_is_wrong) {
  Options options;
  options.file = cache("mesh");
  options.scene = 0;
  EXPECT_EQ(refusal(options, 2), "--scene: " + options.file + " is a geometry cache, which has no scenes");
  options.scene.reset();
  options.cache = options.file;
  EXPECT_EQ(refusal(options, 2), "--cache: " + options.file + " is a geometry cache itself");
  options.file = (folder_ / "gone.sgeo").string();
  options.cache.clear();
  EXPECT_THAT(refusal(options, 1), HasSubstr("gone.sgeo"));
  std::ofstream(folder_ / "thing.gltf") << kTriangle;
  options.file = (folder_ / "thing.gltf").string();
  options.cache = (folder_ / "gone.sgeo").string();
  EXPECT_THAT(refusal(options, 1), HasSubstr("gone.sgeo"));
  options.cache = cache("other");
  EXPECT_EQ(refusal(options, 1), "other.sgeo: no mesh of the scene fits one of the cache");
}

TEST_F(loaded, says_which_material_has_more_images_than_are_shown) {
  // Base colour and normal map leave five of the seven places to the textures of layers.
  const auto wall = [](const std::string& transmission) {
    std::string textures;
    for (int i = 0; i < 8; ++i) textures += std::string(i > 0 ? "," : "") + R"({"source": 0})";
    return R"({"asset": {"version": "2.0"}, "images": [{"uri": "data:image/png;base64,AAAA"}], "textures": [)" +
           textures +
           R"(], "extensionsUsed": ["KHR_materials_clearcoat", "KHR_materials_sheen", "KHR_materials_transmission"],
              "materials": [{"name": "wall", "pbrMetallicRoughness": {"baseColorTexture": {"index": 0}},
                "normalTexture": {"index": 1}, "extensions": {
                "KHR_materials_clearcoat": {"clearcoatFactor": 1, "clearcoatTexture": {"index": 2},
                  "clearcoatRoughnessTexture": {"index": 3}, "clearcoatNormalTexture": {"index": 4}},
                "KHR_materials_sheen": {"sheenColorFactor": [1, 1, 1], "sheenColorTexture": {"index": 5},
                  "sheenRoughnessTexture": {"index": 6}},
                "KHR_materials_transmission": {"transmissionFactor": 1)" +
           transmission + "}}}]}";
  };
  const auto of_images = testing::Contains(HasSubstr("material \"wall\" has more images than the viewer shows"));
  EXPECT_TRUE(load(wall("")));
  EXPECT_THAT(messages_, testing::Not(of_images));
  EXPECT_TRUE(load(wall(R"(, "transmissionTexture": {"index": 7})")));
  EXPECT_THAT(messages_, of_images);
}

TEST_F(loaded, says_what_the_viewer_leaves_out) {
  const auto lights = [](int count) {
    std::string nodes, all;
    for (int i = 0; i < count; ++i) {
      nodes += std::string(i > 0 ? "," : "") + R"({"extensions": {"KHR_lights_punctual": {"light": )" +
               std::to_string(i) + "}}}";
      all += std::string(i > 0 ? "," : "") + R"({"type": "point"})";
    }
    return R"({"asset": {"version": "2.0"}, "extensionsUsed": ["KHR_lights_punctual"], "nodes": [)" + nodes +
           R"(], "extensions": {"KHR_lights_punctual": {"lights": [)" + all + "]}}}";
  };
  ASSERT_TRUE(load(lights(kMaxLights)));
  EXPECT_THAT(messages_, IsEmpty());
  ASSERT_TRUE(load(lights(kMaxLights + 1)));
  EXPECT_THAT(messages_, ElementsAre(HasSubstr(std::to_string(kMaxLights + 1) + " lights; the viewer uses the first " +
                                               std::to_string(kMaxLights))));
  const auto extended = [&](const std::string& names) {
    EXPECT_TRUE(load(R"({"asset": {"version": "2.0"}, "extensionsUsed": [)" + names + "]}"));
    const auto found = std::find_if(messages_.begin(), messages_.end(),
                                    [](const std::string& line) { return line.find("not shown") != line.npos; });
    return found == messages_.end() ? "" : found->substr(found->find("not shown"));
  };
  EXPECT_EQ(extended(R"("ACME_materials_glow", "ACME_texture_moss", "ACME_wind")"),
            "not shown: ACME_materials_glow, ACME_texture_moss");
  EXPECT_EQ(extended(R"("ACME_wind", "KHR_materials_unlit", "KHR_texture_transform")"), "");
  const auto set = [](int texcoord) {
    return R"({"asset": {"version": "2.0"}, "images": [{"uri": "data:image/png;base64,AAAA"}], "textures": [{"source": 0}],
               "materials": [{"name": "wall", "occlusionTexture": {"index": 0, "texCoord": )" +
           std::to_string(texcoord) + "}}]}";
  };
  const auto about_sets = HasSubstr("material \"wall\" uses TEXCOORD_2; the viewer takes TEXCOORD_0 instead");
  EXPECT_TRUE(load(set(1)));
  EXPECT_THAT(messages_, testing::Not(testing::Contains(HasSubstr("TEXCOORD"))));
  EXPECT_TRUE(load(set(2)));
  EXPECT_THAT(messages_, testing::Contains(about_sets));
}

TEST(add_missing_centers, makes_them_where_the_scene_itself_says_so_else_where_the_user_does) {
  const Skinning linear = Skinning::linear, centers = Skinning::center_of_rotation;
  for (const std::vector<Skinning>& own : {std::vector<Skinning>{}, {linear}, {linear, centers}})
    for (const Skinning skinning : {linear, Skinning::dual_quaternion, centers}) {
      LoadedScene shown;
      shown.scene = test::arm_scene();
      shown.instance_skinning = own;
      add_missing_centers(shown, skinning);
      EXPECT_EQ(shown.scene.meshes[0].primitives[0].centers_of_rotation.empty(),
                own.empty() ? skinning != centers : own.size() < 2);
    }
}

TEST(needs_of, ask_for_bounds_of_one_layer_and_what_the_evaluation_says) {
  LoadedScene shown;
  shown.instance_skinning = {Skinning::linear};
  const Needs plain = needs_of(shown, {});
  EXPECT_TRUE(plain.out.bounds);
  EXPECT_EQ(plain.in.max_layers, 1u);
  EXPECT_EQ(plain.skin.per_instance, shown.instance_skinning);
  EXPECT_FALSE(plain.out.stage_times || plain.in.between_updates);
  const Needs asked =
      needs_of(shown, {.skinning = Skinning::dual_quaternion, .updates = Updates::interpolated, .stage_times = true});
  EXPECT_EQ(asked.skin.kind, Skinning::dual_quaternion);
  EXPECT_TRUE(asked.out.stage_times && asked.in.between_updates);
}

/// A character of VRM `version`, with the extension's member "meta".
std::string vrm_file(const std::string& extension, const std::string& version, const std::string& meta) {
  return R"({"asset": {"version": "2.0"}, "extensionsUsed": [")" + extension + R"("], "nodes": [{"name": "hips"}],
      "scenes": [{"nodes": [0]}], "extensions": {")" +
         extension + R"(": {"specVersion": ")" + version + R"(", "meta": )" + meta + "}}}";
}

TEST_F(loaded, vrm_0_is_seen_from_the_side_that_it_faces) {
  const glm::dvec3 towards_1(0.447, 0.0, 0.894), towards_0 = -towards_1;
  for (const bool old : {false, true}) {
    const auto shown = load(old ? vrm_file("VRM", "0.0", "{}") : vrm_file("VRMC_vrm", "1.0", R"({"name": "A"})"));
    ASSERT_TRUE(shown) << shown.error().message;
    OrbitCamera camera = opening_camera(shown->front(), {});
    camera.pitch_rad = 0.0;
    EXPECT_LT(glm::length(camera.eye() / camera.distance_m - (old ? towards_0 : towards_1)), 1e-3) << old;
  }
}

TEST_F(loaded, vrm_meta_is_told) {
  const auto old = load(vrm_file("VRM", "0.0", R"({"title": "Aoi", "author": "B", "licenseName": "CC0"})"));
  ASSERT_TRUE(old) << old.error().message;
  EXPECT_EQ(old->front().note, R"(VRM 0.0: "Aoi" by B, licence CC0)");
  const auto now = load(vrm_file("VRMC_vrm", "1.0", R"({"name": "Aoi", "authors": ["B", "C"], "licenseUrl": "l"})"));
  ASSERT_TRUE(now) << now.error().message;
  EXPECT_EQ(now->front().note, R"(VRM 1.0: "Aoi" by B, C, licence l)");
}

}  // namespace
}  // namespace sinew::viewer
