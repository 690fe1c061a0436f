// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include "runtime/c/plan.h"
#include "runtime/model/scene.h"
#include "runtime/plan/compile_plan.h"

// What is behind the handles of the C interface, for C++ code that hands its own scene to C:
//     return new sinew_scene{std::move(scene)};      // the scene has passed check(Scene)

struct sinew_scene {
  sinew::Scene scene;
};

struct sinew_plan {
  sinew::Plan plan;
  std::uint32_t max_adding_layers = 0;

  /// Room for the layers of one frame.
  std::size_t layer_room() const noexcept { return std::size_t{plan.needs.max_layers} + max_adding_layers; }
};
