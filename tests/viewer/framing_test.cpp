// SPDX-License-Identifier: MIT
#include <algorithm>

#include "viewer/app/camera/framing.h"

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "tests/viewer/flyer.h"

namespace sinew::viewer {
namespace {

Aabb box_of(std::span<const glm::vec3> points) {
  Aabb box;
  for (const glm::vec3& p : points) box.add(p);
  return box;
}

TEST(framing, a_pose_is_framed_alone) {
  const Scene scene = flyer(true);
  const Framed found = framed(Framing::pose, scene, 0, 1.0);
  const Aabb box = box_of(found.outline.points());
  EXPECT_NEAR(glm::length(box.lower - glm::vec3(5, 0, 0)), 0.0f, 1e-5f);
  EXPECT_NEAR(glm::length(box.upper - glm::vec3(6, 1, 0)), 0.0f, 1e-5f);
  EXPECT_EQ(found.offset_at(2.0), glm::dvec3(0.0)) << "the camera stays";
}

TEST(framing, what_is_followed_is_framed_in_place_and_the_camera_goes_along_over_the_ground) {
  const Scene scene = flyer(true);
  const Framed found = framed(Framing::follow, scene, 0, 0.0);
  const Aabb box = box_of(found.outline.points());
  EXPECT_NEAR(glm::length(box.lower - glm::vec3(-0.5f, 0, 0)), 0.0f, 1e-4f) << "no longer than one pose";
  EXPECT_NEAR(glm::length(box.upper - glm::vec3(0.5f, 1, 0)), 0.0f, 1e-4f);
  EXPECT_EQ(found.duration_s, 3.0);
  EXPECT_NEAR(glm::length(found.offset_at(0.0) - glm::dvec3(0.5, 0, 0)), 0.0, 1e-5);
  EXPECT_NEAR(glm::length(found.offset_at(1.0) - glm::dvec3(5.5, 0, 0)), 0.0, 1e-4) << "between the poses, too";
  EXPECT_NEAR(glm::length(found.offset_at(3.0) - glm::dvec3(4.5, 0, 0)), 0.0, 1e-4);
  EXPECT_EQ(found.offset_at(-1.0), found.offset_at(0.0));
  EXPECT_EQ(found.offset_at(9.0), found.offset_at(3.0));
}

TEST(framing, without_a_clip_or_meshes_there_is_still_something_to_frame) {
  const Scene skeleton = flyer(false), still = flyer(true);
  EXPECT_NEAR(framed(Framing::follow, skeleton, 0, 0.0).offset_at(1.0).x, 5.0, 1e-4);
  EXPECT_FALSE(framed(Framing::pose, skeleton, 0, 2.0).outline.points().empty());
  const Aabb followed = box_of(framed(Framing::follow, skeleton, 0, 0.0).outline.points());
  EXPECT_NEAR(glm::length(followed.upper - followed.lower), 0.0f, 1e-5f) << "joints are framed in place as well";
  const Framed rest = framed(Framing::follow, still, kNone, 0.0);
  EXPECT_EQ(rest.path.size(), 1u);
  EXPECT_NEAR(rest.offset_at(5.0).x, 0.5, 1e-6);
}

TEST(framing, the_whole_clip_is_the_extent_of_the_clip) {
  const Scene scene = flyer(true);
  const Framed found = framed(Framing::clip, scene, 0, 0.0);
  const ClipExtent extent = clip_extent(scene, 0);
  const auto points = found.outline.points(), expected = extent.outline.points();
  EXPECT_TRUE(std::equal(points.begin(), points.end(), expected.begin(), expected.end()));
  EXPECT_EQ(found.offset_at(1.0), glm::dvec3(0.0));
}

}  // namespace
}  // namespace sinew::viewer
