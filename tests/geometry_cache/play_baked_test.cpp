// SPDX-License-Identifier: MIT
// A cache that `sinew bake` made from a clip plays like the clip.
#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "importer/geometry_cache/encode_geometry_cache.h"
#include "importer/tool/bake/bake_scene.h"
#include "runtime/geometry_cache/geometry_player.h"
#include "runtime/plan/run_plan.h"
#include "tests/scenes/random_scene.h"

namespace sinew::test {
namespace {

/// World position of a vertex of a frame.
glm::vec3 world_position(const Plan& plan, const FrameResult& frame, std::size_t p, std::size_t v) {
  const DeformedPrimitive& shape = frame.primitives[p];
  const Primitive& primitive = primitive_of(plan, plan.primitives()[p]);
  return transform_point(frame.instances[shape.instance].world_from_mesh,
                         shape.positions.empty() ? primitive.positions[v] : shape.positions[v]);
}

TEST(play_baked, a_baked_clip_plays_in_its_scene_as_the_clip_does_at_any_weight_and_root) {
  RandomSceneOptions options;
  options.triangles = 8;
  options.mirrored_joints = true;
  const Scene scene = random_scene(77, options);
  const auto baked = tool::bake_scene(scene, 0, 20.0, {});
  ASSERT_TRUE(baked.has_value());
  const auto file = encode_geometry_cache(baked->take);
  ASSERT_TRUE(file.has_value());
  const GeometryCache cache = *GeometryCache::open(*file);
  MappedFrames frames{cache, *file};
  const GeometryBindings bindings = bind_by_name(cache, scene);
  EXPECT_TRUE(bindings.unbound.empty());
  GeometryPlayer player(cache, frames, scene, bindings.bound);
  ASSERT_EQ(player.instances().size(), scene.instances.size());
  const Plan plan = compile_plan(lend(scene), {.in = {.cached_instances = player.instances()}});
  FrameBuffer posed(plan), played(plan);
  FrameInput input;
  input.root.row[0] = {0.0f, 0.0f, -2.0f, 3.0f};  // rotated by 90 degrees and doubled in size
  input.root.row[1] = {0.0f, 2.0f, 0.0f, 0.0f};
  input.root.row[2] = {2.0f, 0.0f, 0.0f, 1.0f};
  for (const double time_s : {0.0, 0.5, 1.05}) {
    const ClipLayer layer{.clip = 0, .time_s = time_s};
    input.layers = {&layer, 1};
    input.geometry = {};
    ASSERT_EQ(run_plan(plan, input, posed), ErrorCode::ok);
    for (const float weight : {0.5f, 1.0f}) {
      const std::vector<GeometryInput> geometry(scene.instances.size(), player.at(time_s, weight));
      input.geometry = geometry;
      ASSERT_EQ(run_plan(plan, input, played), ErrorCode::ok);
      for (std::size_t p = 0; p < plan.primitives().size(); ++p)
        for (std::size_t v = 0; v < primitive_of(plan, plan.primitives()[p]).vertex_count(); ++v)
          ASSERT_LT(
              glm::distance(world_position(plan, posed.result(), p, v), world_position(plan, played.result(), p, v)),
              2.5e-4f)
              << "twice the budget, since the root doubles it, and rounding; time " << time_s << " weight " << weight;
      for (std::size_t i = 0; i < scene.instances.size(); ++i)
        EXPECT_EQ(played.result().instances[i].mirrored, posed.result().instances[i].mirrored) << i;
    }
  }
}

}  // namespace
}  // namespace sinew::test
