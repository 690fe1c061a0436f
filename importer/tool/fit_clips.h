// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <vector>

#include "runtime/compress/compile_clip_within.h"
#include "runtime/compress/fit_keys.h"
#include "runtime/model/mesh.h"

namespace sinew::tool {

/// Every animation within a budget (compile_clip_within.h), on all cores. The clips do not depend on the number of
/// threads. Progress is shown on a terminal.
/// in   animations  of the scene, its own or mirrored ones      budget_m  in the file's units, >= 0
std::vector<ClipWithin> fit_clips(const Scene& scene, std::span<const Animation> animations, double budget_m);

/// The keys of each of `truths` that a file needs within a budget (fit_keys.h), on all cores.
/// Besides vertices, the direction of cameras and lights is held within 0.05 degrees.
/// in   stored   the same keys as a reader of the file will see them
std::vector<Animation> fit_file_keys(const Scene& scene, std::span<const Animation> truths,
                                     std::span<const Animation> stored, double budget_m);

/// Measures the keys of a file, one animation for each of `truths`, on all cores (measure_keys).
std::vector<ClipCertificate> certify_keys(const Scene& scene, std::span<const Animation> truths,
                                          std::span<const Animation> written, double asked_m);

/// Boxes of the mesh instances over each clip, from the animations of the scene (clip_boxes), on all cores.
ClipBoxes bound_clips(const Scene& scene);

}  // namespace sinew::tool
