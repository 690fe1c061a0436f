// SPDX-License-Identifier: MIT
#include "runtime/retarget/retarget_weights.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace sinew {
namespace {

using testing::ElementsAre;

struct Face {
  std::string mesh;
  std::vector<std::string> targets;
};

/// One instance for each mesh, on one joint. Rest weights are 0.1, 0.2, ... over all meshes.
Scene faces(const std::vector<Face>& all) {
  Scene scene;
  scene.first_weight = {0};
  float rest = 0.0f;
  for (const Face& face : all) {
    Mesh& mesh = scene.meshes.emplace_back();
    mesh.name = face.mesh;
    mesh.target_names = face.targets;
    MeshInstance instance{0, static_cast<std::uint32_t>(scene.meshes.size() - 1)};
    for (std::size_t t = 0; t < face.targets.size(); ++t) instance.rest_weights.push_back(rest += 0.1f);
    scene.first_weight.push_back(scene.first_weight.back() + static_cast<std::uint32_t>(face.targets.size()));
    scene.instances.push_back(std::move(instance));
  }
  return scene;
}

TEST(retarget_weights, targets_follow_those_of_their_name_whatever_their_meshes) {
  const Scene from = faces({{"Head", {"jawOpen", "smile", "cheekPuff"}}, {"Lashes", {"smile", "blink"}}}),
              to = faces({{"Face", {"Face.M_JawOpen", "smile", "", "mouth_funnel"}}, {"Lashes", {"SMILE", "blink"}}});
  const WeightMap map = make_weight_map(from, to);
  EXPECT_THAT(map.source_of, ElementsAre(kNone, 1u, kNone, kNone, 3u, 4u)) << "the lashes follow the lashes";
  EXPECT_THAT(map.not_found, ElementsAre("jawOpen", "cheekPuff"));
  const WeightMap prefixed = make_weight_map(from, faces({{"Face", {"Face.jaw_Open"}}, {"Teeth", {"JawOpen"}}}));
  EXPECT_THAT(prefixed.source_of, ElementsAre(0u, 0u)) << "one name moves both";
  std::vector<float> weights = {9, 9, 9, 9, 9, 9};
  retarget_weights(map, std::vector<float>{1, 2, 3, 4, 5}, weights);
  EXPECT_THAT(weights, ElementsAre(9, 2, 9, 9, 4, 5));
}

TEST(retarget_weights, a_track_keeps_its_keys_and_targets_that_nothing_moves_rest) {
  const Scene from = faces({{"Head", {"a", "b"}}}), to = faces({{"Hat", {"x"}}, {"Face", {"b", "c", "a"}}});
  Animation animation{"talk", 1.0, {}, {{0, {Interpolation::linear, {0.0f, 1.0f}, {1, 2, 3, 4}, 2}}}};
  Animation made{"talk", 1.0, {}, {{5, {}, 0}}};
  const WeightMap map = make_weight_map(from, to);
  retarget_weights(map, animation, from, to, made);
  ASSERT_EQ(made.weights.size(), 1u) << "the hat has no track, and the one from before is gone";
  EXPECT_EQ(made.weights[0].instance, 1u);
  const WeightTrack& track = made.weights[0].weights;
  EXPECT_EQ(track.target_count, 3u);
  EXPECT_THAT(track.times_s, ElementsAre(0.0f, 1.0f));
  EXPECT_THAT(track.values, ElementsAre(2, 0.1f + 0.1f + 0.1f, 1, 4, 0.1f + 0.1f + 0.1f, 3));
  animation.weights[0].weights = {Interpolation::cubic_spline, {0.0f}, {10, 20, 1, 2, 30, 40}, 2};
  retarget_weights(map, animation, from, to, made);
  EXPECT_EQ(made.weights[0].weights.interpolation, Interpolation::cubic_spline);
  EXPECT_THAT(made.weights[0].weights.values, ElementsAre(20, 0, 10, 2, 0.1f + 0.1f + 0.1f, 1, 40, 0, 30))
      << "tangents of a target that rests are 0";
}

TEST(retarget_weights, a_track_without_keys_moves_nothing) {
  const Scene from = faces({{"Head", {"a", "b"}}}), to = faces({{"Face", {"b", "a"}}});
  Animation animation{"talk", 1.0, {}, {{0, {Interpolation::linear, {}, {}, 2}}}};
  Animation made;
  retarget_weights(make_weight_map(from, to), animation, from, to, made);
  EXPECT_TRUE(made.weights.empty());
  animation.weights.push_back({0, {Interpolation::step, {0.0f}, {7}, 1}, 1});
  retarget_weights(make_weight_map(from, to), animation, from, to, made);
  ASSERT_EQ(made.weights.size(), 1u);
  EXPECT_THAT(made.weights[0].weights.values, ElementsAre(7, 0.1f + 0.1f));
}

TEST(retarget_weights, a_mesh_that_follows_several_tracks_has_the_keys_of_all) {
  const Scene from = faces({{"Left", {"a"}}, {"Right", {"b", "unused", "c"}}}), to = faces({{"Face", {"a", "b", "c"}}});
  const Animation animation{"talk",
                            2.0,
                            {},
                            {{0, {Interpolation::linear, {0.0f, 2.0f}, {0, 2}, 1}},
                             {1, {Interpolation::step, {0.0f, 1.0f}, {5, 6}, 1}, 2},
                             {1, {Interpolation::linear, {0.0f}, {7}, 1}, 1}}};
  Animation made;
  retarget_weights(make_weight_map(from, to), animation, from, to, made);
  ASSERT_EQ(made.weights.size(), 1u);
  EXPECT_THAT(made.weights[0].weights.times_s, ElementsAre(0.0f, 1.0f, 2.0f));
  EXPECT_THAT(made.weights[0].weights.values, ElementsAre(0, 0.1f + 0.1f, 5, 1, 0.1f + 0.1f, 6, 2, 0.1f + 0.1f, 6));
}

}  // namespace
}  // namespace sinew
