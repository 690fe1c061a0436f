// SPDX-License-Identifier: MIT
#include "viewer/app/camera/camera_pose.h"

#include "runtime/base/contract.h"
#include "viewer/app/camera/file_camera.h"

namespace sinew::viewer {
namespace {

Needs needs_for(const Scene& scene, std::uint32_t camera) {
  Needs needs;
  needs.out.positions = needs.out.normals = needs.out.tangents = needs.out.weights = false;
  needs.in.max_layers = 1;
  needs.out.skeleton_lod.kept.assign(scene.skeleton.joint_count(), false);
  needs.out.skeleton_lod.kept[scene.cameras[camera].joint] = true;
  return needs;
}

}  // namespace

CameraPose::CameraPose(const Scene& scene, std::uint32_t camera)
    : scene_(&scene),
      camera_(camera),
      plan_(compile_plan(lend(scene), needs_for(scene, camera))),
      frame_(plan_),
      look_(scene) {}

View CameraPose::at(std::uint32_t clip, double time_s, double aspect, const Aabb& bounds) {
  const ClipLayer layer{clip, time_s, 1.0f};
  FrameInput input;
  if (clip != kNone) input.layers = {&layer, 1};
  const ErrorCode code = run_plan(plan_, input, frame_);
  CONTRACT(code == ErrorCode::ok);  // the clip is in range and the time is finite
  const FrameResult& pose = frame_.result();
  apply_properties(*scene_, pose.properties, look_);
  const Camera& camera = look_.cameras[camera_];
  return view_of_camera(camera, world_of(plan_, pose.model, camera.joint), aspect, bounds);
}

}  // namespace sinew::viewer
