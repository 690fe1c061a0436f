// SPDX-License-Identifier: MIT
#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "runtime/plan/run_plan.h"

namespace sinew::test {

inline Needs needs_with(SkeletonLod detail, Skinning skinning) {
  Needs needs;
  needs.skin.kind = skinning;
  needs.out.normals = needs.out.tangents = false;
  needs.out.skeleton_lod = std::move(detail);
  return needs;
}

/// World positions of the vertices of a primitive in a frame.
inline std::vector<glm::vec3> world_vertices(const Plan& plan, const FrameResult& frame, std::size_t p) {
  const DeformedPrimitive& shape = frame.primitives[p];
  const Primitive& primitive = primitive_of(plan, plan.primitives()[p]);
  const std::span<const glm::vec3> positions =
      shape.positions.empty() ? std::span<const glm::vec3>(primitive.positions) : shape.positions;
  std::vector<glm::vec3> world;
  for (const glm::vec3& v : positions)
    world.push_back(transform_point(frame.instances[shape.instance].world_from_mesh, v));
  return world;
}

struct Difference {
  double worst_m = 0.0;
  double far_m = 0.0;  ///< largest distance of a vertex from the origin; bounds the rounding error
};

/// Largest distance between vertices of frames with all joints and frames without the left-out joints, over `times`
/// times of a clip.
inline Difference difference_of(const Scene& scene, const SkeletonLod& detail, std::uint32_t clip, int times,
                                Skinning skinning = Skinning::linear) {
  const Plan full = compile_plan(lend(scene), needs_with({}, skinning)),
             lean = compile_plan(lend(scene), needs_with(detail, skinning));
  FrameBuffer all(full), some(lean);
  Difference found;
  for (int n = 0; n <= times; ++n) {
    const ClipLayer layer{clip, clip == kNone ? 0.0 : scene.animations[clip].duration_s * n / times};
    FrameInput input;
    if (clip != kNone) input.layers = {&layer, 1};
    EXPECT_EQ(run_plan(full, input, all), ErrorCode::ok);
    EXPECT_EQ(run_plan(lean, input, some), ErrorCode::ok);
    for (std::size_t p = 0; p < full.primitives().size(); ++p) {
      const std::vector<glm::vec3> a = world_vertices(full, all.result(), p),
                                   b = world_vertices(lean, some.result(), p);
      for (std::size_t v = 0; v < a.size(); ++v) {
        found.worst_m = std::max(found.worst_m, static_cast<double>(glm::length(a[v] - b[v])));
        found.far_m = std::max(found.far_m, static_cast<double>(glm::length(a[v])));
      }
    }
  }
  return found;
}

}  // namespace sinew::test
