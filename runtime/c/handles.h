// SPDX-License-Identifier: MIT
#pragma once
#include <atomic>
#include <cstddef>
#include <string>
#include <vector>

#include "runtime/c/messages.h"
#include "runtime/c/plan.h"
#include "runtime/lod/compile_skeleton_lod.h"
#include "runtime/model/scene.h"
#include "runtime/plan/compile_plan.h"

// What is behind the handles of the C interface, for C++ code that hands its own scene to C:
//     return new sinew_scene{std::move(scene)};      // the scene has passed check(Scene)

struct sinew_scene {
  sinew::Scene scene;
  mutable std::atomic<std::size_t> plan_count{0};  // that refer to the scene's clips
};

struct sinew_plan {
  sinew_plan(const sinew_scene& of, const sinew::Needs& needs) : scene(&of), plan(compile_plan(of.scene, needs)) {
    ++scene->plan_count;
  }
  ~sinew_plan() { --scene->plan_count; }
  sinew_plan(const sinew_plan&) = delete;
  sinew_plan& operator=(const sinew_plan&) = delete;

  /// Room for the layers of one input, and for those of a later time after them.
  std::size_t input_room() const noexcept { return plan.needs().layer_room() * (plan.needs().between_updates ? 2 : 1); }

  /// Room for what plays in an input.
  std::size_t geometry_room() const noexcept { return plan.needs().cached_instances.size(); }

  const sinew_scene* scene;
  sinew::Plan plan;
  std::vector<sinew::PlanStage> stages = plan.stages();  // their texts, which C reads through pointers
};

struct sinew_skeleton_lod {
  sinew::CompiledSkeletonLod lod;
  std::vector<unsigned char> kept;  // [joints] as C reads it; empty = all
};

struct sinew_messages {
  std::vector<std::string> lines;
};
