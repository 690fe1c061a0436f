// SPDX-License-Identifier: MIT
#include "runtime/model/scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/tiny_assets.h"

namespace sinew {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// Roots 0, 1 and 2, and joint 3 below joint 1.
Scene three_roots() {
  Scene scene;
  scene.skeleton = test::chain_skeleton(4);
  scene.skeleton.parents = {kNone, kNone, kNone, 1};
  scene.scenes = {{"first", {0}}, {"second", {3, 2}}, {"empty", {}}};
  return scene;
}

std::vector<std::uint32_t> hidden_by(std::uint32_t index, std::vector<std::uint32_t> already = {}) {
  Scene scene = three_roots();
  scene.hidden_joints = std::move(already);
  show_scene(scene, index);
  return scene.hidden_joints;
}

TEST(show_scene, G56_roots_of_other_scenes_and_of_none_are_hidden) {
  EXPECT_THAT(hidden_by(0), ElementsAre(1, 2));
  EXPECT_THAT(hidden_by(1), ElementsAre(0)) << "a scene that names a joint below a root shows the root";
  EXPECT_THAT(hidden_by(2), ElementsAre(0, 1, 2));
}

TEST(show_scene, G56_without_a_scene_all_roots_are_shown) { EXPECT_THAT(hidden_by(kNone), IsEmpty()); }

TEST(show_scene, what_is_hidden_stays_hidden_and_is_listed_once) {
  EXPECT_THAT(hidden_by(0, {1}), ElementsAre(1, 2));
  EXPECT_THAT(hidden_by(0, {3}), ElementsAre(3, 1, 2));
}

}  // namespace
}  // namespace sinew
