// SPDX-License-Identifier: MIT
// Characters kilometres from the origin: the precision that a float FrameInput::root leaves, and the way to keep all of
// it.
#include <gtest/gtest.h>

#include <algorithm>

#include "runtime/plan/run_plan.h"
#include "tests/plan/slow_frame.h"
#include "tests/scenes/skeletons.h"
#include "tests/scenes/skinned_surface.h"
#include "tests/scenes/swinging.h"
#include "tests/support/near.h"

namespace sinew::test {
namespace {

using Vec3d = Vec3<double>;
using Vertices = std::vector<Vec3d>;

constexpr double kOut_m = 16384.0, kGrid_m = 0x1p-9;  // distance from the origin, and the spacing of floats there
constexpr double kTime_s = 0.31;
const ClipLayer kWalking[] = {{.clip = 0, .time_s = kTime_s}};
const glm::vec3 kPlace(kOut_m, 12.0, -kOut_m);

/// A walking biped whose skin has centers of rotation.
Scene walker() {
  const Skeleton skeleton = scenes::biped();
  Scene scene = scenes::swinging_surface(skeleton, scenes::swinging(skeleton, 20), 600, 3);
  Primitive& surface = scene.meshes[0].primitives[0];
  surface.centers_of_rotation = surface.positions;
  return scene;
}

Affine turned_at(const glm::vec3& place) {
  return affine_from_transform(Transform{place, quat_xyzw(0.0f, 0.6f, 0.0f, 0.8f), glm::vec3(1)});
}

FrameInput walking(const Affine& root) { return {.layers = kWalking, .weights = {}, .root = root}; }

Vertices true_vertices(const Scene& scene, const Needs& needs, const Affine& root) {
  return evaluate_slowly(scene, needs, walking(root)).primitives[0].positions;
}

/// Vertices of a frame, moved by `place` in double precision.
Vertices vertices(const Scene& scene, const Needs& needs, const Affine& root, const Vec3d& place = Vec3d(0.0)) {
  const Plan plan = compile_plan(lend(scene), needs);
  FrameBuffer frame(plan);
  EXPECT_EQ(run_plan(plan, walking(root), frame), ErrorCode::ok);
  Vertices out;
  for (const glm::vec3& v : frame.result().primitives[0].positions) out.push_back(Vec3d(v) + place);
  return out;
}

double farthest_apart(const Vertices& a, const Vertices& b) {
  double farthest = a.size() == b.size() ? 0.0 : 1e9;
  for (std::size_t v = 0; v < std::min(a.size(), b.size()); ++v) farthest = std::max(farthest, distance(a[v], b[v]));
  return farthest;
}

Vertices seen_from_the_first(Vertices vertices) {
  const Vec3d first = vertices.front();
  for (Vec3d& v : vertices) v -= first;
  return vertices;
}

class far_characters : public ::testing::TestWithParam<Skinning> {
 protected:
  Scene scene_ = walker();
  Needs needs_{.skin = {.kind = GetParam()}};
};

TEST_P(far_characters, N25_a_root_near_the_origin_and_a_place_in_double_keep_all_digits) {
  const Vertices truth = true_vertices(scene_, needs_, turned_at(kPlace));
  EXPECT_LT(farthest_apart(vertices(scene_, needs_, turned_at({}), Vec3d(kPlace)), truth), 4e-6);
}

TEST_P(far_characters, N25_a_root_far_out_leaves_what_float_resolves_there) {
  const Vertices truth = true_vertices(scene_, needs_, turned_at(kPlace));
  const double off = farthest_apart(vertices(scene_, needs_, turned_at(kPlace)), truth);
  EXPECT_LT(off, 5.0 * kGrid_m) << "each joint of a chain is rounded to the grid";
  EXPECT_GT(off, 0.2 * kGrid_m);
}

TEST_P(far_characters, N25_a_clip_that_carries_far_out_keeps_the_shape_if_the_root_brings_it_back) {
  for (BoneAnimation& bone : scene_.animations[0].bones)
    for (glm::vec3& key : bone.translation.values) key += kPlace;
  finish_scene(scene_);
  const Affine back = affine_from(glm::mat3(1.0f), -kPlace);
  const Vertices truth = true_vertices(scene_, needs_, back), brought_back = vertices(scene_, needs_, back);
  EXPECT_LT(farthest_apart(seen_from_the_first(brought_back), seen_from_the_first(truth)), 4e-6);
  EXPECT_LT(farthest_apart(brought_back, truth), kGrid_m) << "keys in float take steps of the grid";
}

INSTANTIATE_TEST_SUITE_P(skinning, far_characters,
                         ::testing::Values(Skinning::linear, Skinning::dual_quaternion, Skinning::center_of_rotation));

TEST(weights_far_out, N23_a_missing_255th_of_weight_pulls_by_the_size_of_the_character_and_not_by_its_distance) {
  const Scene right = walker();
  Scene wrong = right;
  for (float& w : wrong.meshes[0].primitives[0].influences.weights) w *= 254.0f / 255.0f;
  const glm::vec3 place(24.0f, 0.0f, 0.0f);
  const Vertices truth = true_vertices(right, {}, turned_at(place));
  double height = 0.0;
  for (const Vec3d& v : true_vertices(right, {}, turned_at({}))) height = std::max(height, safe_length(v));
  EXPECT_LT(height, 2.5);
  EXPECT_NEAR(farthest_apart(vertices(wrong, {}, turned_at({}), Vec3d(place)), truth), height / 255.0, 1e-5);
  EXPECT_GT(farthest_apart(vertices(wrong, {}, turned_at(place)), truth), 22.0 / 255.0);
}

}  // namespace
}  // namespace sinew::test
