// SPDX-License-Identifier: MIT
#pragma once
/// Less work for characters that are small or out of view. Tools compute the data in advance. clip_bounds gives boxes
/// that a mesh never leaves while a clip plays. A skeleton LOD leaves out joints that move no vertex farther than a
/// tolerance. update_rates.h is about evaluating less often.
///
///     const sinew::CompiledSkeletonLod lod = compile_skeleton_lod(scene, 0.002);
///     const std::vector<sinew::Aabb> boxes = clip_boxes(scene, clip);
#include "runtime/lod/clip_bounds.h"
#include "runtime/lod/compile_skeleton_lod.h"
#include "runtime/model/skeleton_lod.h"
