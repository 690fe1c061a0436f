// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "importer/tool/cost/skin_probe.h"
#include "importer/tool/cost/study.h"
#include "runtime/model/scene.h"

namespace sinew::cost {

/// The subject of a study: a scene, one of its clips, and points of its surface. The scene must outlive it.
struct Subject {
  Subject(const Scene& looked_at, std::uint32_t chosen_clip, const Effort& effort);

  const Scene& scene;
  std::uint32_t clip;  ///< kNone = the scene has no clips
  double size_m;       ///< longest side of the box around the rest pose
  SkinProbe probe;
  Effort effort;

  const Animation* animation() const { return clip == kNone ? nullptr : &scene.animations[clip]; }
  /// "the clip "Walk""
  std::string clip_name() const;
  /// Model matrices of all joints in the poses for which vertices are compared: up to eight poses of the clip. Without
  /// a clip it is one invented pose.
  std::vector<ModelPose> compared_poses() const;
  /// An error that a viewer hardly sees: a ten-thousandth of the model's size, in mm.
  double hardly_seen_mm() const { return 0.1 * size_m; }
};

/// The clip that animates most joints, the first of several; kNone without clips.
std::uint32_t busiest_clip(const Scene& scene);

}  // namespace sinew::cost
