// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <vector>

#include "runtime/compress/compile_clip_within.h"
#include "runtime/model/mesh.h"

namespace sinew::tool {

/// Every animation within a budget (compile_clip_within.h), on all cores. The clips do not depend on the number of
/// threads. Progress is shown on a terminal.
/// in   animations  of the scene, its own or mirrored ones      budget_m  in the file's units, >= 0
std::vector<ClipWithin> fit_clips(const Scene& scene, std::span<const Animation> animations, double budget_m);

/// Compiles `written`, one for each of `truths`, and measures it, on all cores (compile_and_measure).
std::vector<Clip> certify_clips(const Scene& scene, std::span<const Animation> truths,
                                std::span<const Animation> written, double budget_m);

/// Boxes of the mesh instances over each clip, from the animations of the scene (clip_boxes), on all cores.
ClipBoxes bound_clips(const Scene& scene);

}  // namespace sinew::tool
