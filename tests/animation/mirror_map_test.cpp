// SPDX-License-Identifier: MIT
#include "runtime/animation/mirror_map.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

#include "runtime/animation/mirror_animation.h"
#include "tests/reference/mirror.h"
#include "tests/scenes/two_sided.h"
#include "tests/support/near.h"

namespace sinew {
namespace {

using scenes::RightSide;
using scenes::TwoSided;
using Vec3d = Vec3<double>;

std::vector<std::uint32_t> partners(const MirrorMap& map) {
  std::vector<std::uint32_t> all;
  for (const MirroredJoint& joint : map.joints) all.push_back(joint.source);
  return all;
}

std::vector<Transform> mirrored(const MirrorMap& map, const std::vector<Transform>& local) {
  std::vector<Transform> out;
  for (std::uint32_t j = 0; j < local.size(); ++j)
    out.push_back(mirrored_transform(map, j, local[map.joints[j].source]));
  return out;
}

/// Model-space positions of all joints.
std::vector<Vec3d> places(const Skeleton& skeleton, const std::vector<Transform>& local) {
  std::vector<Transformd> exact;
  for (const Transform& t : local) exact.push_back(in_double(t));
  std::vector<Affined> model(local.size());
  model_from_local(skeleton, exact, model);
  std::vector<Vec3d> all;
  for (const Affined& m : model) all.push_back(translation_of(m));
  return all;
}

TEST(mirror_map, names_pair_joints_and_what_has_no_partner_is_listed) {
  for (const RightSide right : scenes::kRightSides) {
    const TwoSided body = scenes::two_sided(right);
    const MirrorMap map = make_mirror_map(body.skeleton);
    EXPECT_EQ(partners(map), body.partner);
    EXPECT_EQ(map.unpaired, (std::vector<std::uint32_t>{13})) << "the sword in the left hand";
    EXPECT_EQ(paired_joints(map), 10u);
    EXPECT_NEAR(std::abs(map.plane_normal.x), 1.0f, right == RightSide::another_posture ? 0.02f : 1e-6f);
  }
}

TEST(mirror_map, places_pair_joints_where_names_do_not_tell) {
  TwoSided body = scenes::two_sided(RightSide::any_axes);
  for (std::string& name : body.skeleton.names) name.clear();
  const MirrorMap map = make_mirror_map(body.skeleton);
  EXPECT_EQ(partners(map), body.partner);
  EXPECT_EQ(map.plane_normal, glm::vec3(1, 0, 0));
  EXPECT_EQ(paired_joints(make_mirror_map(scenes::biped())), 58u);
}

TEST(mirror_map, positions_pair_joints_at_other_planes_away_from_the_origin) {
  Skeleton skeleton = scenes::two_sided(RightSide::mirrored_axes).skeleton;
  for (std::string& name : skeleton.names) name.clear();
  const auto turn = quat_xyzw(0.0f, std::sqrt(0.5f), 0.0f, std::sqrt(0.5f));
  skeleton.rest[0].rotation = turn * skeleton.rest[0].rotation;
  skeleton.rest[0].translation = {3, 1, 0.25f};
  const MirrorMap map = make_mirror_map(skeleton);
  EXPECT_EQ(map.plane_normal, glm::vec3(0, 0, 1));
  EXPECT_NEAR(map.plane_offset, 0.25f, 1e-6f);
  EXPECT_EQ(paired_joints(map), 10u);
}

TEST(mirror_map, a_persons_own_pairs_come_before_names) {
  const TwoSided body = scenes::two_sided(RightSide::any_axes);
  MirrorOptions options;
  options.pairs = {{2, 6}, {13, 13}};  // the parents of 2 and 6 are not partners
  const MirrorMap map = make_mirror_map(body.skeleton, options);
  EXPECT_EQ(map.joints[2].source, 2u);
  EXPECT_EQ(map.joints[6].source, 6u);
  EXPECT_EQ(map.joints[11].source, 11u) << "below joints that have no partner any more";
  EXPECT_FALSE(map.unpaired.empty());
}

TEST(mirror_map, a_joint_that_is_its_own_partner_by_wish_is_not_paired_by_place) {
  TwoSided body = scenes::two_sided(RightSide::mirrored_axes);
  for (std::string& name : body.skeleton.names) name.clear();
  std::uint32_t left = 0;
  while (body.partner[left] == left) ++left;
  const std::uint32_t right = body.partner[left];
  ASSERT_EQ(make_mirror_map(body.skeleton).joints[left].source, right);
  MirrorOptions options;
  options.pairs = {{left, left}};
  const MirrorMap map = make_mirror_map(body.skeleton, options);
  EXPECT_EQ(map.joints[left].source, left);
  EXPECT_EQ(map.joints[right].source, right);
}

TEST(mirror_map, joints_of_one_parent_are_paired_by_place_up_to_256_of_them) {
  for (const std::uint32_t children : {256u, 257u}) {
    std::vector<std::uint32_t> parents(1 + children, 0);
    parents[0] = kNone;
    std::vector<glm::vec3> offsets = {glm::vec3(0.0f)};
    for (std::uint32_t c = 0; c < children; ++c) {
      const auto away = static_cast<float>(1 + c / 2);
      offsets.push_back({c % 2 == 0 ? away : -away, 0.5f * away, 0.0f});
    }
    MirrorOptions options;
    options.plane_normal = glm::vec3(1, 0, 0);
    Skeleton skeleton = scenes::breadth_first(parents, offsets);
    skeleton.names.assign(1 + children, "");
    EXPECT_EQ(paired_joints(make_mirror_map(skeleton, options)), children == 256 ? 256u : 0u);
  }
}

TEST(mirror_map, a_joint_on_the_plane_below_one_side_keeps_its_own_motion) {
  Skeleton skeleton = scenes::breadth_first({kNone, 0, 0, 1}, {{0, 1, 0}, {0.5f, 0, 0}, {-0.5f, 0, 0}, {-0.5f, 0, 0}});
  skeleton.names = {"hips", "hand.l", "hand.r", "staff"};
  const MirrorMap map = make_mirror_map(skeleton);
  EXPECT_EQ(map.joints[1].source, 2u);
  EXPECT_EQ(map.unpaired, (std::vector<std::uint32_t>{3}));
  const std::vector<Transform> local = scenes::moved_from_rest(skeleton, 2);
  EXPECT_EQ(mirrored(map, local)[3], local[3]);
}

TEST(mirror_map, a_plane_that_is_given_is_the_one_where_names_do_not_tell) {
  Skeleton skeleton = scenes::two_sided(RightSide::mirrored_axes).skeleton;
  for (std::string& name : skeleton.names) name.clear();
  MirrorOptions options;
  options.plane_normal = glm::vec3(0, 0, 2);
  const MirrorMap map = make_mirror_map(skeleton, options);
  EXPECT_EQ(map.plane_normal, glm::vec3(0, 0, 1));
  EXPECT_LT(paired_joints(map), 10u) << "the sides lie along x";
  options.plane_normal = glm::vec3(0.0f);
  EXPECT_EQ(make_mirror_map(skeleton, options).plane_normal, glm::vec3(1, 0, 0)) << "no direction";
}

TEST(mirror_map, poses_agree_with_their_definition_in_model_space) {
  for (const RightSide right : scenes::kRightSides)
    for (std::uint64_t seed = 1; seed < 6; ++seed) {
      TwoSided body = scenes::two_sided(right, seed);
      test::FixedRandom random(seed);
      for (Transform& rest : body.skeleton.rest)
        if (seed > 3) rest.scale = random.vec3(0.5, 2.0);
      MirrorOptions options;
      options.plane_normal = glm::vec3(1, 0, 0);
      const MirrorMap map = make_mirror_map(body.skeleton, options);
      const std::vector<Transform> local = scenes::moved_from_rest(body.skeleton, seed), out = mirrored(map, local);
      const std::vector<Transformd> truth =
          reference::mirrored_pose(body.skeleton, body.skeleton.rest, local, body.partner, {1, 0, 0});
      for (std::uint32_t j = 0; j < 13; ++j) {  // the sword keeps its own motion
        EXPECT_TRUE(test::is_near(Vec3d(out[j].translation), truth[j].translation, 1e-6)) << j;
        EXPECT_LT(test::angle_between(out[j].rotation, truth[j].rotation), 1e-6) << j;
        EXPECT_TRUE(test::is_near(Vec3d(out[j].scale), truth[j].scale, 1e-6)) << j;
      }
      EXPECT_EQ(out[13], local[13]);
    }
}

TEST(mirror_map, a_symmetric_body_comes_out_as_its_mirror_image) {
  for (const RightSide right : {RightSide::mirrored_axes, RightSide::opposite_axes, RightSide::any_axes}) {
    const TwoSided body = scenes::two_sided(right);
    const MirrorMap map = make_mirror_map(body.skeleton);
    const std::vector<Transform> local = scenes::moved_from_rest(body.skeleton, 3);
    const std::vector<Vec3d> before = places(body.skeleton, local), after = places(body.skeleton, mirrored(map, local));
    for (std::uint32_t j = 0; j < 13; ++j)
      EXPECT_TRUE(test::is_near(after[body.partner[j]], before[j] * Vec3d(-1, 1, 1), 2e-6)) << j;
  }
}

/// Reflecting local rotations, which assumes mirrored axes on both sides, would move these rest poses.
TEST(mirror_map, the_rest_pose_stays_whatever_axes_and_bones_the_other_side_has) {
  for (const RightSide right : scenes::kRightSides) {
    const TwoSided body = scenes::two_sided(right);
    const std::vector<Transform> out = mirrored(make_mirror_map(body.skeleton), body.skeleton.rest);
    for (std::uint32_t j = 0; j < out.size(); ++j) {
      EXPECT_TRUE(test::is_near(out[j].translation, body.skeleton.rest[j].translation, 1e-6)) << j;
      EXPECT_LT(test::angle_between(out[j].rotation, body.skeleton.rest[j].rotation), 1e-6) << j;
    }
  }
}

TEST(mirror_map, bones_keep_their_lengths_where_the_sides_have_others) {
  const TwoSided body = scenes::two_sided(RightSide::another_posture);
  std::vector<Transform> local = body.skeleton.rest;
  for (std::uint32_t j = 0; j < local.size(); ++j)
    local[j].rotation = scenes::moved_from_rest(body.skeleton, 4)[j].rotation;
  const std::vector<Transform> out = mirrored(make_mirror_map(body.skeleton), local);
  for (std::uint32_t j = 0; j < out.size(); ++j)
    EXPECT_TRUE(test::is_near(out[j].translation, body.skeleton.rest[j].translation, 1e-6)) << j;
}

TEST(mirror_map, twice_mirrored_is_the_same_bit_for_bit_where_the_sides_are_mirror_images) {
  for (const RightSide right : scenes::kRightSides) {
    const TwoSided body = scenes::two_sided(right);
    const MirrorMap map = make_mirror_map(body.skeleton);
    std::vector<Transform> local = scenes::moved_from_rest(body.skeleton, 5);
    local[0].rotation = quat_xyzw(-0.0f, 0.0f, -0.0f, 1.0f);
    const std::vector<Transform> twice = mirrored(map, mirrored(map, local));
    for (std::uint32_t j = 0; j < local.size(); ++j) {
      if (scenes::is_symmetric(right)) {
        EXPECT_EQ(0, std::memcmp(&twice[j], &local[j], sizeof(Transform))) << j;
      } else {  // sums of up to four rounded products, mirrored twice
        EXPECT_LT(test::angle_between(twice[j].rotation, local[j].rotation), 16 * test::kEps) << j;
        EXPECT_TRUE(test::is_near(twice[j].translation, local[j].translation, 8 * test::kEps)) << j;
      }
    }
  }
}

bool copies_rotation(const MirroredJoint& joint) {
  return std::all_of(joint.rotation.begin(), joint.rotation.end(),
                     [](const MirrorRow<4>& row) { return copied_entry(row) != 0; });
}

TEST(mirror_map, places_off_by_rounding_alone_have_no_offset) {
  for (const RightSide right : {RightSide::mirrored_axes, RightSide::opposite_axes}) {
    TwoSided body = scenes::two_sided(right);
    for (Transform& rest : body.skeleton.rest) rest.translation += 1e-8f * rest.translation.y;
    const MirrorMap map = make_mirror_map(body.skeleton);
    std::size_t without = 0;
    for (std::uint32_t j = 0; j < map.joints.size(); ++j)
      without += body.partner[j] != j && map.joints[j].offset == Vec3d(0.0);
    EXPECT_EQ(without, 10u * 2u - 10u) << "each of the paired joints";
  }
}

TEST(mirror_map, the_tolerance_of_positions_is_scaled_to_the_space_of_the_parent) {
  for (const float scale : {1.0f, 0.01f, 100.0f}) {
    TwoSided body = scenes::two_sided(RightSide::mirrored_axes);
    body.skeleton.rest[0].scale *= scale;
    for (std::size_t j = 1; j < body.skeleton.joint_count(); ++j) body.skeleton.rest[j].translation /= scale;
    const MirrorMap exact = make_mirror_map(body.skeleton);
    const float size = 1e-6f / scale;
    for (const float off : {0.1f * size, 1000.0f * size}) {
      body.skeleton.rest[2].translation.y += off;
      EXPECT_EQ(make_mirror_map(body.skeleton).joints[3].offset == Vec3d(0.0), off < size) << scale;
    }
    EXPECT_EQ(exact.joints[3].offset, Vec3d(0.0)) << scale;
  }
}

TEST(mirror_map, a_joint_that_a_name_pairs_is_no_partner_by_place) {
  Skeleton skeleton = scenes::two_sided(RightSide::mirrored_axes).skeleton;
  // The spine has two arms with names of sides. Before them comes a joint at the mirrored position of the right arm.
  skeleton.names[4] = "arm.r2";
  skeleton.rest[4].translation = skeleton.rest[5].translation;
  const MirrorMap map = make_mirror_map(skeleton);
  EXPECT_EQ(map.joints[5].source, 6u);
  EXPECT_EQ(map.joints[4].source, 4u);
}

TEST(mirror_map, axes_within_the_tolerance_count_as_mirror_images_and_others_do_not) {
  for (const RightSide right : {RightSide::mirrored_axes, RightSide::opposite_axes}) {
    TwoSided body = scenes::two_sided(right);
    const auto paired =
        static_cast<std::uint32_t>(std::find_if(body.partner.begin(), body.partner.end(),
                                                [&](const std::uint32_t& p) {
                                                  return p != static_cast<std::uint32_t>(&p - body.partner.data());
                                                }) -
                                   body.partner.begin());
    glm::quat& rest = body.skeleton.rest[paired].rotation;
    rest = glm::normalize(rest * glm::angleAxis(5e-5f, glm::vec3(0, 0, 1)));
    const MirrorMap near = make_mirror_map(body.skeleton),
                    exact = make_mirror_map(body.skeleton, {.angle_tolerance_rad = 1e-6});
    EXPECT_TRUE(copies_rotation(near.joints[paired]));
    EXPECT_FALSE(copies_rotation(exact.joints[paired]));
  }
}

TEST(mirror_map, another_reference_pose_mirrors_about_it) {
  const TwoSided body = scenes::two_sided(RightSide::mirrored_axes);
  Skeleton striding = body.skeleton;  // the file was written in the middle of a walk
  striding.rest = scenes::moved_from_rest(body.skeleton, 6);
  for (Transform& rest : striding.rest) rest.scale = glm::vec3(1.0f);
  MirrorOptions options;
  options.reference = body.skeleton.rest;
  const MirrorMap about_reference = make_mirror_map(striding, options), expected = make_mirror_map(body.skeleton);
  const std::vector<Transform> local = scenes::moved_from_rest(body.skeleton, 7);
  EXPECT_EQ(mirrored(about_reference, local), mirrored(expected, local));
  EXPECT_EQ(about_reference.reference, PoseReference::given);
  EXPECT_TRUE(is_moved_at_rest(about_reference, striding, 5));
  EXPECT_FALSE(is_moved_at_rest(expected, body.skeleton, 5));
}

TEST(mirror_map, an_empty_skeleton_has_an_empty_map) { EXPECT_TRUE(make_mirror_map(Skeleton{}).joints.empty()); }

}  // namespace
}  // namespace sinew
