// SPDX-License-Identifier: MIT
// Several files: who plays whose clips, and what a drop on the window changes.
#include "viewer/app/open/open_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "importer/export_glb.h"
#include "importer/import_gltf.h"
#include "runtime/asset_file/write_asset_file.h"
#include "runtime/plan/run_plan.h"
#include "samples/showcase/scene_builder.h"
#include "samples/showcase/shapes.h"
#include "viewer/app/open/add_clips.h"
#include "viewer/app/open/dropped_files.h"
#include "viewer/app/open/file_names.h"

namespace sinew::viewer {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

BoneAnimation turning(std::uint32_t joint) {
  BoneAnimation bone;
  bone.joint = joint;
  bone.rotation.times_s = {0.0f, 1.0f};
  bone.rotation.values = {{1, 0, 0, 0}, {0.8f, 0, 0.6f, 0}};
  return bone;
}

/// Two joints, "hip" and `tip`, `length` apart, with a box on each if it is drawn.
Scene limb(const char* tip, float length, bool is_drawn, bool moves) {
  showcase::SceneBuilder builder;
  const std::uint32_t hip = builder.add_joint("hip", kNone, {});
  Transform at;
  at.translation = {0, length, 0};
  const std::uint32_t end = builder.add_joint(tip, hip, at);
  if (is_drawn) {
    const std::uint32_t material = builder.add_material("red", {1, 0, 0}, 0.5f);
    for (const std::uint32_t joint : {hip, end}) {
      Mesh mesh{"box" + std::to_string(joint), {showcase::box({0, 0, 0}, glm::vec3(0.1f))}, {}, {}};
      mesh.primitives[0].material = material;
      builder.add_instance(joint, builder.add_mesh(std::move(mesh)));
    }
  }
  if (moves) builder.add_animation({"wave", 1.0, {turning(hip), turning(end)}, {}});
  return builder.finish();
}

class open_files_test : public testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder_); }
  void TearDown() override { fs::remove_all(folder_); }

  std::string glb(const char* name, const Scene& scene) {
    const fs::path file = folder_ / name;
    EXPECT_TRUE(export_glb(scene, file));
    return file.string();
  }
  std::string sinew(const char* name, const Scene& scene) {
    const std::vector<std::byte> bytes = write_asset_file(scene);
    const fs::path file = folder_ / name;
    std::ofstream(file, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    return file.string();
  }
  tl::expected<std::vector<LoadedScene>, LoadError> load(std::vector<std::string> files, Options options = {}) {
    options.file = files.front();
    options.more_files.assign(files.begin() + 1, files.end());
    options.environment = "none";
    messages_.clear();
    return load_scenes(options, [this](const std::string& line) { messages_.push_back(line); }, {});
  }
  Options light_off_ = [] {
    Options options;
    options.environment = "none";
    return options;
  }();

  fs::path folder_ = fs::temp_directory_path() / ("open" + std::to_string(::getpid()));
  std::vector<std::string> messages_;
};

TEST_F(open_files_test, clips_of_the_same_skeleton_play_on_every_character_with_their_bits) {
  const Scene moving = limb("tip", 1.0f, false, true);
  const auto scenes = load({glb("a.glb", limb("tip", 1.0f, true, false)), glb("walk.glb", moving),
                            glb("b.glb", limb("tip", 1.0f, true, true))});
  ASSERT_TRUE(scenes) << scenes.error().message;
  ASSERT_EQ(scenes->size(), 2u) << "the clip file is no scene of its own";
  EXPECT_THAT(messages_, IsEmpty());
  for (const auto& [loaded, clips] : {std::pair(&scenes->at(0), 1u), std::pair(&scenes->at(1), 2u)}) {
    ASSERT_EQ(loaded->scene.animations.size(), clips) << loaded->name;
    EXPECT_EQ(loaded->scene.clips.size(), clips);
    const Animation& added = loaded->scene.animations.back();
    EXPECT_EQ(added.name, "wave");
    ASSERT_EQ(added.bones.size(), 2u);
    EXPECT_EQ(added.bones[1].rotation.values, moving.animations[0].bones[1].rotation.values);
    EXPECT_EQ(check(loaded->scene), ErrorCode::ok);
    EXPECT_THAT(loaded->files, testing::Contains(folder_ / "walk.glb")) << "which --watch watches";
  }
}

TEST_F(open_files_test, clips_of_another_skeleton_are_retargeted_and_what_lacks_is_named) {
  const auto scenes =
      load({glb("a.glb", limb("tip", 2.0f, true, false)), glb("walk.glb", limb("tail", 1.0f, false, true))});
  ASSERT_TRUE(scenes) << scenes.error().message;
  ASSERT_EQ(scenes->front().scene.animations.size(), 1u);
  const Animation& added = scenes->front().scene.animations[0];
  ASSERT_EQ(added.bones.size(), 1u) << "the hip alone follows";
  EXPECT_EQ(added.bones[0].joint, 0u);
  EXPECT_THAT(messages_, ElementsAre("walk.glb: warning: a.glb has no \"tail\""));
  EXPECT_EQ(scenes->front().messages, messages_) << "the window lists them, too";
}

TEST_F(open_files_test, clips_that_fit_nothing_leave_the_character_as_it_is) {
  showcase::SceneBuilder builder;
  builder.add_animation({"turn", 1.0, {turning(builder.add_joint("wheel", kNone, {}))}, {}});
  const auto scenes = load({glb("a.glb", limb("tip", 1.0f, true, true)), glb("car.glb", builder.finish())});
  ASSERT_TRUE(scenes);
  EXPECT_EQ(scenes->front().scene.animations.size(), 1u);
  EXPECT_THAT(messages_, ElementsAre(HasSubstr("no joint is like one of a.glb; its clips are left out")));
}

TEST_F(open_files_test, clips_alone_show_their_skeleton) {
  const auto scenes = load({glb("walk.glb", limb("tip", 1.0f, false, true))});
  ASSERT_TRUE(scenes);
  ASSERT_EQ(scenes->size(), 1u);
  EXPECT_EQ(scenes->front().name, "walk.glb");
}

TEST_F(open_files_test, of_a_file_with_meshes_the_clips_alone_can_be_taken) {
  Options options;
  options.clip_files = {glb("full.glb", limb("tip", 1.0f, true, true))};
  const std::string character = glb("a.glb", limb("tip", 1.0f, true, false));
  const auto scenes = load({character}, options);
  ASSERT_TRUE(scenes);
  ASSERT_EQ(scenes->size(), 1u);
  EXPECT_EQ(scenes->front().scene.animations.size(), 1u);
  options.clip_files = {character};
  const auto none = load({character}, options);
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().message, "--clips: " + character + " has no clips");
}

TEST_F(open_files_test, asset_files_open_as_they_were_written_with_images_decoded) {
  Scene scene = limb("tip", 1.0f, true, true);
  Image image;
  image.name = "dot";
  image.width = image.height = 1;
  image.rgba = {10, 20, 30, 255};
  scene.images = {image};
  scene.textures = {Texture{0, {}}};
  scene.materials[0].base_color_texture.texture = 0;
  ImportOptions keep;
  keep.decode_images = false;
  keep.keep_encoded_images = true;
  const auto encoded = import_gltf(glb("a.glb", scene), keep);
  ASSERT_TRUE(encoded);
  ASSERT_TRUE(encoded->scene.images.at(0).rgba.empty()) << "the file keeps the encoded image";
  const auto scenes = load({sinew("a.sinew", encoded->scene)});
  ASSERT_TRUE(scenes) << scenes.error().message;
  EXPECT_EQ(scenes->front().scene.images.at(0).rgba, image.rgba);
  EXPECT_EQ(scenes->front().scene.animations.size(), 1u);
  EXPECT_EQ(scenes->front().name, "a.sinew");
  fs::resize_file(folder_ / "a.sinew", 100);
  const auto cut = load({(folder_ / "a.sinew").string()});
  ASSERT_FALSE(cut);
  EXPECT_THAT(cut.error().message, testing::AllOf(HasSubstr("a.sinew"), HasSubstr("asset-size")));
}

TEST_F(open_files_test, a_folder_stands_for_its_files_in_the_order_of_names) {
  glb("b.glb", limb("tip", 1.0f, true, false));
  glb("a.GLB", limb("tip", 1.0f, true, false));
  std::ofstream(folder_ / "notes.txt") << "no model";
  fs::create_directory(folder_ / "deeper.glb");
  EXPECT_THAT(expand_folders({"x.glb", folder_.string()}),
              ElementsAre("x.glb", (folder_ / "a.GLB").string(), (folder_ / "b.glb").string()));
  const auto scenes = load({folder_.string()});
  ASSERT_TRUE(scenes) << scenes.error().message;
  EXPECT_EQ(scenes->size(), 2u);
  EXPECT_THAT(names_of(*scenes), ElementsAre("a.GLB", "b.glb"));
  fs::create_directory(folder_ / "empty");
  const auto none = load({(folder_ / "empty").string()});
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().message, "the folder has no file that can be shown");
}

TEST_F(open_files_test, dropped_clips_join_the_shown_character_and_play) {
  const auto scenes = load({glb("a.glb", limb("tip", 1.0f, true, true))});
  ASSERT_TRUE(scenes);
  const std::string walk = glb("walk.glb", limb("tail", 1.0f, false, true));
  DropOutcome outcome = apply_dropped(open_dropped({walk}, light_off_), scenes->front(), light_off_);
  ASSERT_TRUE(outcome.changed);
  EXPECT_EQ(outcome.changed->scene.animations.size(), 2u);
  EXPECT_EQ(outcome.new_clip, 1u);
  EXPECT_THAT(outcome.added_files, ElementsAre(walk)) << "for the next reload";
  EXPECT_THAT(outcome.changed->messages, ElementsAre(HasSubstr("a.glb has no \"tail\"")));
  EXPECT_THAT(outcome.new_scenes, IsEmpty());
}

TEST_F(open_files_test, dropped_characters_are_scenes_and_faults_do_not_keep_others_away) {
  const auto scenes = load({glb("a.glb", limb("tip", 1.0f, true, false))});
  ASSERT_TRUE(scenes);
  std::ofstream(folder_ / "broken.glb") << "glTF";
  const DropOutcome outcome =
      apply_dropped(open_dropped({(folder_ / "broken.glb").string(), glb("b.glb", limb("tip", 1.0f, true, false)),
                                  glb("walk.glb", limb("tip", 1.0f, false, true)), (folder_ / "no.hdr").string()},
                                 light_off_),
                    scenes->front(), light_off_);
  EXPECT_FALSE(outcome.changed);
  ASSERT_EQ(outcome.new_scenes.size(), 1u);
  EXPECT_EQ(outcome.new_scenes[0].name, "b.glb");
  EXPECT_EQ(outcome.new_scenes[0].scene.animations.size(), 1u) << "with the clips of the same drop";
  EXPECT_THAT(outcome.messages, ElementsAre(HasSubstr("broken.glb"), HasSubstr("no.hdr")));
}

TEST_F(open_files_test, files_are_opened_beside_the_window) {
  FileDrop drop;
  EXPECT_FALSE(drop.follow(light_off_)) << "nothing was dropped";
  drop.add({glb("a.glb", limb("tip", 1.0f, true, false))});
  std::optional<DroppedFiles> opened;
  for (int i = 0; i < 12000 && !(opened = drop.follow(light_off_)); ++i) ::usleep(10000);
  ASSERT_TRUE(opened);
  EXPECT_EQ(opened->files.characters.size(), 1u);
  EXPECT_FALSE(drop.running());
}

}  // namespace
}  // namespace sinew::viewer
