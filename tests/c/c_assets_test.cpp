// SPDX-License-Identifier: MIT
// Asset files through the C interface give the scenes of the C++ interface.
#include <gtest/gtest.h>

#include <string>

#include "runtime/asset_file/write_asset_file.h"
#include "runtime/c/clips.h"
#include "runtime/c/handles.h"
#include "runtime/c_assets/sinew_assets.h"
#include "runtime/graph/graph_builder.h"
#include "runtime/graph/graph_bytes.h"
#include "tests/asset_file/played_frames.h"
#include "tests/scenes/hand_scenes.h"
#include "tests/scenes/random_scene.h"

namespace sinew::test {
namespace {

using Bytes = std::vector<std::byte>;

TEST(c_assets, a_file_gives_a_scene_that_owns_what_it_has) {
  const Scene scene = face_scene();
  sinew_scene* read = nullptr;
  {
    const Bytes file = write_asset_file(scene);
    EXPECT_TRUE(sinew_looks_like_assets(file.data(), file.size()));
    ASSERT_EQ(sinew_assets_read(file.data(), file.size(), &read, nullptr), SINEW_OK);
  }
  EXPECT_EQ(hashes_of_frames(read->scene), hashes_of_frames(scene));
  EXPECT_EQ(sinew_clip_count(read), 1u);
  sinew_scene_destroy(read);
}

TEST(c_assets, boxes_of_a_file_are_those_that_clip_bounds_answers) {
  const Scene scene = face_scene();
  const ClipBoxes boxes{std::vector<Aabb>(scene.instances.size(), {glm::vec3(-70.0f), glm::vec3(80.0f)})};
  const Bytes file = write_asset_file(scene, {.clip_boxes = boxes});
  sinew_scene* read = nullptr;
  ASSERT_EQ(sinew_assets_read(file.data(), file.size(), &read, nullptr), SINEW_OK);
  std::vector<sinew_box> found(scene.instances.size());
  std::size_t count = 0;
  ASSERT_EQ(sinew_clip_bounds(read, nullptr, 0, found.data(), found.size(), &count), SINEW_OK);
  ASSERT_EQ(count, found.size());
  EXPECT_NEAR(found[0].lower.x, -70.0f, 0.1f);
  EXPECT_NEAR(found[0].upper.z, 80.0f, 0.1f);
  ASSERT_EQ(sinew_clip_bounds(read, nullptr, SINEW_NONE, found.data(), found.size(), &count), SINEW_OK);
  EXPECT_LT(found[0].upper.z, 10.0f) << "the rest pose is not in the file";
  sinew_scene_destroy(read);
}

TEST(c_assets, boxes_that_do_not_fit_are_refused) {
  const Scene scene = face_scene();
  const ClipBoxes boxes(scene.clips.size() + 1);
  const Bytes file = write_asset_file(scene, {.clip_boxes = boxes});
  sinew_scene* read = nullptr;
  EXPECT_EQ(sinew_assets_read(file.data(), file.size(), &read, nullptr), SINEW_BAD_FILE);
}

TEST(c_assets, clips_of_the_same_skeleton_are_added_and_others_are_refused_in_words) {
  const Bytes body = write_asset_file(arm_scene(), {.clips = false}),
              clips = write_asset_file(arm_scene(), {.skeleton = false, .model = false}),
              others = write_asset_file(face_scene(), {.skeleton = false, .model = false});
  sinew_scene* scene = nullptr;
  ASSERT_EQ(sinew_assets_read(body.data(), body.size(), &scene, nullptr), SINEW_OK);
  EXPECT_EQ(sinew_assets_add_clips(scene, clips.data(), clips.size(), nullptr), SINEW_OK);
  EXPECT_EQ(sinew_clip_count(scene), 1u);
  sinew_messages* messages = nullptr;
  EXPECT_EQ(sinew_assets_add_clips(scene, others.data(), others.size(), &messages), SINEW_BAD_FILE);
  ASSERT_EQ(sinew_message_count(messages), 1u);
  EXPECT_NE(std::string(sinew_message(messages, 0)).find("asset-signature in block clips"), std::string::npos);
  sinew_messages_destroy(messages);
  EXPECT_EQ(sinew_clip_count(scene), 1u);
  sinew_plan* plan = nullptr;
  ASSERT_EQ(sinew_plan_create(scene, nullptr, &plan), SINEW_OK);
  EXPECT_EQ(sinew_assets_add_clips(scene, clips.data(), clips.size(), nullptr), SINEW_BUSY);
  sinew_plan_destroy(plan);
  sinew_scene_destroy(scene);
}

TEST(c_assets, bad_bytes_and_missing_arguments_are_refused) {
  Bytes file = write_asset_file(arm_scene());
  file.back() ^= std::byte{1};
  sinew_scene* scene = nullptr;
  sinew_messages* messages = nullptr;
  EXPECT_EQ(sinew_assets_read(file.data(), file.size(), &scene, &messages), SINEW_BAD_FILE);
  EXPECT_EQ(sinew_message_count(messages), 1u);
  sinew_messages_destroy(messages);
  EXPECT_EQ(sinew_assets_read(file.data(), 5, &scene, nullptr), SINEW_BAD_FILE);
  EXPECT_EQ(scene, nullptr);
  EXPECT_EQ(sinew_assets_read(nullptr, 5, &scene, nullptr), SINEW_NULL_ARGUMENT);
  EXPECT_EQ(sinew_assets_read(file.data(), file.size(), nullptr, nullptr), SINEW_NULL_ARGUMENT);
  EXPECT_EQ(sinew_assets_add_clips(nullptr, file.data(), file.size(), nullptr), SINEW_NULL_ARGUMENT);
  EXPECT_FALSE(sinew_looks_like_assets(nullptr, 40));
  EXPECT_FALSE(sinew_looks_like_assets(file.data() + 1, file.size() - 1));
}

TEST(c_assets, graphs_of_a_file_are_found_by_name) {
  GraphBuilder b;
  const GraphTables tables = b.tables(b.clip("wave"));
  const std::vector<StoredGraph> graphs = {{"other", {}}, {"wave", write_graph_bytes(tables)}};
  const Bytes file = write_asset_file(arm_scene(), {.graphs = graphs});
  sinew_graph* graph = nullptr;
  ASSERT_EQ(sinew_assets_read_graph(file.data(), file.size(), "wave", &graph, nullptr), SINEW_OK);
  EXPECT_EQ(sinew_graph_write(graph, nullptr, 0), graphs[1].bytes.size());
  sinew_graph_destroy(graph);
  graph = nullptr;
  EXPECT_EQ(sinew_assets_read_graph(file.data(), file.size(), "none", &graph, nullptr), SINEW_INDEX_OUT_OF_RANGE);
  EXPECT_EQ(sinew_assets_read_graph(file.data(), file.size(), "other", &graph, nullptr), SINEW_BAD_FILE);
  EXPECT_EQ(sinew_assets_read_graph(nullptr, 0, "wave", &graph, nullptr), SINEW_NULL_ARGUMENT);
  EXPECT_EQ(sinew_assets_read_graph(file.data(), file.size(), nullptr, &graph, nullptr), SINEW_NULL_ARGUMENT);
  EXPECT_EQ(sinew_assets_read_graph(file.data(), file.size(), "wave", nullptr, nullptr), SINEW_NULL_ARGUMENT);
  EXPECT_EQ(graph, nullptr);
}

TEST(c_assets, skeleton_lods_of_a_file_serve_plans) {
  const Scene scene = random_scene(3);
  const std::vector<CompiledSkeletonLod> lods = {compile_skeleton_lod(scene, 1e-9), compile_skeleton_lod(scene, 1e9)};
  ASSERT_GT(lods[1].left_out, lods[0].left_out);
  const std::vector<std::byte> file = write_asset_file(scene, {.skeleton_lods = lods});
  const sinew_scene in_c{scene};
  sinew_skeleton_lod* lod = nullptr;
  ASSERT_EQ(sinew_assets_read_skeleton_lod(file.data(), file.size(), &in_c, 1, &lod, nullptr), SINEW_OK);
  sinew_skeleton_lod_info info = {};
  info.struct_size = sizeof info;
  ASSERT_EQ(sinew_get_skeleton_lod(lod, &info), SINEW_OK);
  EXPECT_EQ(info.left_out, lods[1].left_out);
  EXPECT_EQ(info.tolerance_m, 1e9);
  EXPECT_EQ(info.kept.count, scene.skeleton.joint_count());
  sinew_needs needs = sinew_default_needs();
  needs.skeleton_lod = lod;
  sinew_plan* plan = nullptr;
  ASSERT_EQ(sinew_plan_create(&in_c, &needs, &plan), SINEW_OK);
  EXPECT_LT(kept_joints(plan->plan).size(), scene.skeleton.joint_count());
  sinew_plan_destroy(plan);
  sinew_skeleton_lod_destroy(lod);
  EXPECT_EQ(sinew_assets_read_skeleton_lod(file.data(), file.size(), &in_c, 2, &lod, nullptr),
            SINEW_INDEX_OUT_OF_RANGE);
  EXPECT_EQ(sinew_assets_read_skeleton_lod(file.data(), file.size(), nullptr, 0, &lod, nullptr), SINEW_NULL_ARGUMENT);
  EXPECT_EQ(sinew_assets_read_skeleton_lod(nullptr, 0, &in_c, 0, &lod, nullptr), SINEW_NULL_ARGUMENT);
  EXPECT_EQ(sinew_assets_read_skeleton_lod(file.data(), file.size(), &in_c, 0, nullptr, nullptr), SINEW_NULL_ARGUMENT);
  const sinew_scene other{random_scene(4)};
  sinew_messages* why = nullptr;
  EXPECT_EQ(sinew_assets_read_skeleton_lod(file.data(), file.size(), &other, 0, &lod, &why), SINEW_BAD_FILE);
  EXPECT_NE(std::string(sinew_message(why, 0)).find("asset-signature in block skeleton_lods"), std::string::npos);
  sinew_messages_destroy(why);
  EXPECT_EQ(sinew_assets_read_skeleton_lod(file.data(), 12, &in_c, 0, &lod, nullptr), SINEW_BAD_FILE);
}

}  // namespace
}  // namespace sinew::test
