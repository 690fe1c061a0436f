// SPDX-License-Identifier: MIT
#pragma once
#include <atomic>
#include <cstddef>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "runtime/c/library.h"
#include "runtime/c/messages.h"
#include "runtime/c/plan.h"
#include "runtime/c/retarget.h"
#include "runtime/c/root_motion.h"
#include "runtime/library/clip_library.h"
#include "runtime/lod/compile_skeleton_lod.h"
#include "runtime/model/mesh.h"
#include "runtime/model/scene.h"
#include "runtime/plan/compile_plan.h"
#include "runtime/playback/root_motion.h"
#include "runtime/pose/mirror_pose.h"
#include "runtime/retarget/feet_map.h"
#include "runtime/retarget/retarget_pose.h"
#include "runtime/retarget/retarget_weights.h"
#include "runtime/retarget/share_twist.h"

// The structs behind the handles of the C interface, for C++ code that hands its own scene to C:
//     return new sinew_scene{std::move(scene)};      // the scene has passed check(Scene)

struct sinew_scene {
  sinew::Scene scene;
  mutable std::atomic<std::size_t> plan_count{0};  // plans of this scene that exist; they refer to its clips
  sinew::ClipBoxes clip_boxes = {};                // boxes of the file; empty if it has none

  // Plans share the tables of the scene's meshes: each is compiled beside the one before, if that one still exists.
  sinew::Plan compile(std::span<const sinew::Clip> clips, const sinew::Needs& needs) const {
    const std::lock_guard lock(plan_mutex);
    const sinew::Plan beside(last_plan.lock());
    sinew::Plan plan = compile_plan(lend(scene), clips, needs, beside);
    last_plan = plan.compiled();
    return plan;
  }
  mutable std::mutex plan_mutex = {};
  mutable std::weak_ptr<const sinew::CompiledPlan> last_plan = {};
};

struct sinew_plan {
  sinew_plan(const sinew_scene& of, std::span<const sinew::Clip> clips, const sinew::Needs& needs)
      : scene(&of), plan(of.compile(clips, needs)) {
    ++scene->plan_count;
  }
  ~sinew_plan() { --scene->plan_count; }
  sinew_plan(const sinew_plan&) = delete;
  sinew_plan& operator=(const sinew_plan&) = delete;

  const sinew_scene* scene;
  sinew::Plan plan;
  std::vector<sinew::PlanStage> stages = plan.stages();  // C reads the texts of the stages through pointers into it
};

struct sinew_skeleton_lod {
  explicit sinew_skeleton_lod(sinew::CompiledSkeletonLod of)
      : lod(std::move(of)), kept(lod.detail.kept.begin(), lod.detail.kept.end()) {}

  sinew::CompiledSkeletonLod lod;
  std::vector<unsigned char> kept;  // [joints] 1 or 0 as C reads it; empty = all are kept
};

struct sinew_library {
  sinew::ClipLibrary clips;
};

struct sinew_mirror {
  std::shared_ptr<const sinew::MirrorMap> map;
  sinew::MirrorTables tables;
  std::vector<std::uint32_t> partner;  // [joints] partner of each joint
  std::uint32_t reference;             // a value of sinew_reference
};

struct sinew_skeleton_map {
  const sinew_scene *source, *target;
  sinew::SkeletonMap map;
  sinew::RetargetTables tables;
  sinew::TwistMap twists;
  sinew::FeetMap feet;
  std::vector<sinew_joint_pair> pairs;  // the joint pairs of `map` as C reads them
  sinew::WeightMap weights;
  std::uint32_t source_reference, target_reference;  // values of sinew_reference
};

struct sinew_root_track {
  sinew::BoneAnimation animation;
  sinew::Transform rest;
  sinew::RootMotionParts parts;
};

struct sinew_messages {
  std::vector<std::string> lines;
};
