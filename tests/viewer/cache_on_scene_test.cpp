// SPDX-License-Identifier: MIT
#include "viewer/app/cache/cache_on_scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "samples/showcase/showcase.h"
#include "tests/viewer/cache_files.h"
#include "viewer/app/camera/frustum_culling.h"
#include "viewer/app/clip_extent.h"

namespace sinew::viewer {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const GeometryCache& showcase_cache() {
  static const GeometryCache cache = *GeometryCache::open(showcase::flag_cache());
  return cache;
}

TEST(cache_on_scene, binds_meshes_by_name_and_says_what_it_does_not) {
  const Scene scene = showcase::flag_in_wind({}).scene;
  std::vector<std::string> messages;
  const auto log_line = [&](const std::string& line) { messages.push_back(line); };
  const auto bound = bind_cache(*open_cache_bytes("showcase", showcase::flag_cache()), scene, log_line);
  ASSERT_TRUE(bound) << bound.error();
  EXPECT_THAT(messages, testing::IsEmpty());
  EXPECT_THAT((*bound)->instances(), ElementsAre(0u));
  EXPECT_NEAR((*bound)->duration_s(), 4.0, 1e-9);

  const Bytes other = flag_bytes(4);  // its mesh is called "mesh"
  const auto nothing = bind_cache(*open_cache_bytes("other.sgeo", other), scene, log_line);
  ASSERT_FALSE(nothing);
  EXPECT_THAT(nothing.error(), HasSubstr("other.sgeo"));
  EXPECT_THAT(messages, ElementsAre(testing::AllOf(HasSubstr("other.sgeo: warning: "), HasSubstr("\"mesh\""))));
}

TEST(cache_on_scene, a_cache_alone_plays_from_its_start_and_beside_clips_on_their_clock) {
  const Bytes bytes = flag_bytes(4, 2.0);
  const CacheAlone alone = flag_alone(bytes);
  EXPECT_EQ(alone.cache->start_s, 2.0);
  EXPECT_NEAR(alone.cache->duration_s(), 0.1, 1e-9);
  EXPECT_EQ(alone.scene.meshes[0].name, "mesh");
  Scene with_clip = alone.scene;
  with_clip.animations.emplace_back().duration_s = 1.0;
  const auto beside = bind_cache(*open_cache_bytes("flag", bytes), with_clip, [](const std::string&) {});
  ASSERT_TRUE(beside);
  EXPECT_EQ((*beside)->start_s, 0.0);
  EXPECT_NEAR((*beside)->duration_s(), 2.1, 1e-9);
}

TEST(cache_on_scene, a_first_frame_that_is_damaged_is_an_error_with_its_rule) {
  const Bytes bytes = with_damage(flag_bytes(4), 0);
  const auto alone = show_cache_alone(*open_cache_bytes("flag.sgeo", bytes));
  ASSERT_FALSE(alone);
  EXPECT_THAT(alone.error(), HasSubstr("flag.sgeo: cache-checksum: "));
}

TEST(cache_on_scene, its_extent_and_its_culling_are_those_of_all_its_frames) {
  const showcase::ShowcaseScene shown = showcase::flag_in_wind(showcase::flag_cache());
  const auto cache = *bind_cache(*open_cache_bytes("flag", showcase::flag_cache()), shown.scene, {});
  const std::vector<Aabb> reach = cache->reach(shown.scene);
  const Aabb& flag = showcase_cache().meshes()[0].bounds;
  EXPECT_EQ(reach[0].lower, flag.lower);
  EXPECT_EQ(reach[0].upper, flag.upper);
  EXPECT_TRUE(reach[1].empty());

  const View in_front = look_at({1.2, 3.0, 8.0}, {1.2, 3.0, 0.0}, 0.5, 0.05);
  const double depth = static_cast<double>(flag.upper.z);  // the flat flag lies at z = 0
  ASSERT_GT(depth, 0.2);
  const View beside_flat_flag = look_at({8.0, 3.0, 0.9 * depth}, {0.0, 3.0, 0.9 * depth}, 0.01, 0.05);
  FrustumCulling alone(shown.scene, {}), with_cache(shown.scene, {}, reach);
  EXPECT_FALSE(with_cache.of(kNone, in_front, 1.5).out_of_view[0]);
  EXPECT_TRUE(alone.of(kNone, beside_flat_flag, 1.0).out_of_view[0]);
  EXPECT_FALSE(with_cache.of(kNone, beside_flat_flag, 1.0).out_of_view[0]);

  Scene only_flag = shown.scene;
  only_flag.instances.resize(1);
  only_flag.clips.clear();
  finish_scene(only_flag);
  const ClipExtent still = clip_extent(only_flag, kNone), moving = clip_extent(only_flag, kNone, cache.get());
  EXPECT_EQ(still.reached.upper.z - still.reached.lower.z, 0.0f);
  EXPECT_GT(moving.reached.upper.z, 0.7f * flag.upper.z);
  EXPECT_LE(moving.reached.upper.z, flag.upper.z);
}

}  // namespace
}  // namespace sinew::viewer
