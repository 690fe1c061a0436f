// SPDX-License-Identifier: MIT
#pragma once
/// Clips within an error budget in metres, for tools: key removal and rounding, measured at vertices against the
/// animation's truth.
///
///     const sinew::VirtualVertices vertices = virtual_vertices(scene);
///     const sinew::ClipWithin small = compile_clip_within(scene, scene.animations[0], vertices, 0.0001);
///     log(small.clip.certificate()->measured_m);
#include "runtime/compress/clip_error.h"
#include "runtime/compress/compile_clip_within.h"
#include "runtime/compress/fit_keys.h"
#include "runtime/compress/truth_samples.h"
#include "runtime/compress/virtual_vertices.h"
