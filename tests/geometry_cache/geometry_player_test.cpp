// SPDX-License-Identifier: MIT
#include "runtime/geometry_cache/geometry_player.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "runtime/base/same_bits.h"
#include "runtime/geometry_cache/scene_of_cache.h"
#include "runtime/plan/run_plan.h"
#include "tests/geometry_cache/takes.h"

namespace sinew::test {
namespace {

/// A flag that a cache of its own shows.
class geometry_player : public testing::Test {
 protected:
  geometry_player() : made_(*scene_of(cache_, mapped_)), player_(cache_, mapped_, made_.scene, made_.bindings) {
    needs_.cached_instances = player_.instances();
    plan_ = compile_plan(made_.scene, needs_);
  }

  const FrameResult& play(FrameBuffer& frame, double time_s, float weight = 1.0f) {
    const std::vector<GeometryInput> geometry(needs_.cached_instances.size(), player_.at(time_s, weight));
    FrameInput input;
    input.geometry = geometry;
    EXPECT_EQ(run_plan(plan_, input, frame), ErrorCode::ok);
    return frame.result();
  }

  std::vector<std::byte> file_ = *encode_geometry_cache(flag_take(20), {.segment_frames = 8});
  GeometryCache cache_ = *GeometryCache::open(file_);
  MappedFrames mapped_{cache_, file_};
  CacheScene made_;
  GeometryPlayer player_;
  Needs needs_;
  Plan plan_;
};

TEST_F(geometry_player, the_scene_of_a_cache_passes_the_checks_and_has_its_names) {
  EXPECT_EQ(check(made_.scene), ErrorCode::ok);
  ASSERT_EQ(made_.scene.instances.size(), 1u);
  EXPECT_EQ(made_.scene.skeleton.names[0], "mesh");
  EXPECT_EQ(made_.scene.meshes[0].name, "mesh");
  EXPECT_EQ(made_.scene.materials[0].name, "mesh");
  EXPECT_EQ(made_.scene.meshes[0].primitives[0].indices, cache_.meshes()[0].triangles);
  EXPECT_EQ(bind_by_name(cache_, made_.scene).bound.size(), 1u);
  EXPECT_TRUE(bind_by_name(cache_, made_.scene).unbound.empty());
}

TEST_F(geometry_player, frames_show_the_bits_of_the_decoder_in_any_order) {
  FrameBuffer frame(plan_);
  GeometryDecoder decoder(cache_);
  std::vector<glm::vec3> expected(cache_.meshes()[0].vertex_count);
  FixedRandom random(3);
  for (int k = 0; k < 60; ++k) {
    const double time_s = cache_.duration_s() * random.in(-0.1, 1.1);
    ASSERT_EQ(decoder.decode_time(time_s, mapped_), GeometryStatus::ok);
    ASSERT_EQ(decoder.write_vertices(0, expected), GeometryStatus::ok);
    const FrameResult& shown = play(frame, time_s);
    ASSERT_TRUE(same_bits<glm::vec3>(shown.primitives[0].positions, expected)) << time_s;
    const Aabb box = player_.bounds(0, time_s);
    for (const glm::vec3& x : expected)
      for (int axis = 0; axis < 3; ++axis) {
        ASSERT_LE(box.lower[axis], x[axis]);
        ASSERT_GE(box.upper[axis], x[axis]);
      }
  }
}

TEST_F(geometry_player, playing_forward_decodes_each_frame_once) {
  FrameBuffer frame(plan_);
  std::uint64_t decoded = 0;
  for (std::uint32_t f = 0; f < 20; ++f) {
    decoded += play(frame, f * cache_.frame_s()).work.cache_frames_decoded;
    EXPECT_EQ(decoded, f + 1u);
    EXPECT_EQ(play(frame, f * cache_.frame_s()).work, WorkCounters{});
  }
}

}  // namespace
}  // namespace sinew::test
