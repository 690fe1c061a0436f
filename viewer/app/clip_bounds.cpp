// SPDX-License-Identifier: MIT
#include "viewer/app/clip_bounds.h"

#include <glm/geometric.hpp>

#include "runtime/plan/run_plan.h"
#include "viewer/app/skeleton_lines.h"
#include "viewer/upload/scene_bounds.h"

namespace sinew::viewer {
namespace {

constexpr int kPoses = 17;

float diagonal(const Aabb& box) { return box.empty() ? -1.0f : glm::length(box.upper - box.lower); }

}  // namespace

ClipBounds clip_bounds(const Scene& scene, std::uint32_t clip) {
  Needs needs;
  needs.normals = needs.tangents = false;
  const Plan plan = compile_plan(scene, needs);
  FrameBuffer frame(plan);
  const double duration = clip < scene.animations.size() ? scene.animations[clip].duration_s : 0.0;
  const int poses = duration > 0.0 ? kPoses : 1;
  ClipBounds bounds;
  for (int i = 0; i < poses; ++i) {
    const ClipLayer layer{clip, poses > 1 ? duration * i / (poses - 1) : 0.0, 1.0f};
    FrameInput input;
    if (clip < scene.animations.size()) input.layers = {&layer, 1};
    if (run_plan(plan, input, frame) != ErrorCode::ok) continue;
    Aabb box = bounds_of(scene, frame.result());
    if (box.empty()) box = bounds_of_joints(frame.result().model);
    if (box.empty()) continue;
    if (diagonal(box) > diagonal(bounds.largest)) bounds.largest = box;
    bounds.reached.add(box.lower);
    bounds.reached.add(box.upper);
  }
  return bounds;
}

}  // namespace sinew::viewer
