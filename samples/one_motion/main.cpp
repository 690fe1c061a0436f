// SPDX-License-Identifier: MIT
// One clip plays on three bodies with different proportions and rest poses. It is retargeted pose by pose, and also
// baked to clips; both give the same motion. With an argument, writes the three bodies as a .glb.
#include <algorithm>
#include <cstdio>
#include <cstring>
#include <utility>

#include "importer/export_glb.h"
#include "runtime/math/quaternion.h"
#include "runtime/pose/pose_memory.h"
#include "runtime/pose/sample_clip.h"
#include "runtime/retarget/retarget_animation.h"
#include "runtime/retarget/retarget_pose.h"
#include "samples/one_motion/body.h"
#include "samples/showcase/shapes.h"

namespace {

using namespace sinew;

constexpr int kFrames = 48;
constexpr double kSame_rad = 1e-5;

/// The largest angle between rotations of the poses retargeted frame by frame and of the baked clip.
double difference(const Scene& source, const Scene& target, const SkeletonMap& map, const Clip& baked) {
  const RetargetTables tables = make_retarget_tables(map, source.skeleton, target.skeleton);
  PoseMemory pose(kJoints), scratch(kJoints), live(kJoints), played(kJoints);
  double largest = 0.0;
  for (int f = 0; f < kFrames; ++f) {
    const double time_s = source.clips[0].duration_s() * f / kFrames;
    run_unchecked(SampleClipJob{.clip = &source.clips[0], .time_s = time_s, .pose = pose.span(), .weights = {}});
    run_unchecked(RetargetPoseJob{&tables, pose.span(), scratch.span(), live.span()});
    run_unchecked(SampleClipJob{.clip = &baked, .time_s = time_s, .pose = played.span(), .weights = {}});
    for (std::uint32_t j = 0; j < kJoints; ++j)
      largest = std::max(largest, static_cast<double>(rotation_angle_between(live.span().get(j).rotation,
                                                                             played.span().get(j).rotation)));
  }
  return largest;
}

/// All bodies side by side on a floor; each follows its own tracks.
Scene make_group(const std::array<Animation, kBuilds.size()>& clips) {
  showcase::SceneBuilder scene;
  std::array<std::array<std::uint32_t, kJoints>, kBuilds.size()> joints{};
  std::array<std::uint32_t, kBuilds.size()> stands{};
  for (std::size_t b = 0; b < kBuilds.size(); ++b)
    stands[b] =
        scene.add_joint(kBuilds[b].name, kNone, {.translation = {1.15f * (static_cast<float>(b) - 1.0f), 0, 0}});
  scene.add_prop("floor", showcase::box({0, -0.05f, 0}, {4.0f, 0.05f, 3.0f}),
                 scene.add_material("stone", {0.55f, 0.56f, 0.60f}, 0.9f));
  for (std::uint32_t level = 0; level < 5; ++level)
    for (std::size_t b = 0; b < kBuilds.size(); ++b)
      for (std::uint32_t j = 0; j < kJoints; ++j) {
        const BodyJoint& joint = body_joints()[j];
        if (joint.level != level) continue;
        const std::uint32_t parent = joint.parent == kNone ? stands[b] : joints[b][joint.parent];
        joints[b][j] = scene.add_joint(joint.name, parent, rest_of(kBuilds[b])[j]);
      }
  Animation all = clips[0];
  all.bones.clear();
  for (std::size_t b = 0; b < kBuilds.size(); ++b) {
    dress(kBuilds[b], joints[b], stands[b], scene);
    for (BoneAnimation bone : clips[b].bones) {
      bone.joint = joints[b][bone.joint];
      all.bones.push_back(std::move(bone));
    }
  }
  scene.add_animation(std::move(all));
  return scene.finish();
}

}  // namespace

int main(int argc, char** argv) {
  if (argc > 2 || (argc == 2 && std::strstr(argv[1], ".glb") == nullptr)) {
    std::fprintf(stderr, "usage: one_motion [OUT.glb]      one clip on three bodies, which OUT.glb shows\n");
    return 2;
  }
  Build animator = kBuilds[0];  // a fourth body, for which the clip was made
  animator.thigh = animator.shank = 0.45f;
  Scene source = make_body(animator);
  source.animations.push_back(make_run(animator));
  finish_scene(source);
  std::array<Animation, kBuilds.size()> clips;
  for (std::size_t b = 0; b < kBuilds.size(); ++b) {
    const Scene target = make_body(kBuilds[b]);
    SkeletonMapOptions options;
    for (std::uint32_t j = 0; j < kJoints; ++j) options.pairs.push_back({j, j});
    const SkeletonMap map = make_skeleton_map(source.skeleton, target.skeleton, options);
    clips[b] = retarget_animation(source.animations[0], map, source.skeleton, target.skeleton);
    const double off =
        difference(source, target, map, compile_clip(clips[b], target.skeleton, {}, target.first_weight));
    std::printf("%-6s %2zu joints follow, heights %.2f, frame by frame and baked differ by %.1e rad\n", kBuilds[b].name,
                map.joints.size(), map.height_ratio, off);
    if (off > kSame_rad) return 1;
  }
  if (argc == 2 && !export_glb(make_group(clips), argv[1])) return 1;
}
