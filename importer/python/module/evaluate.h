// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "importer/python/module/arrays.h"
#include "importer/python/module/scene_handle.h"
#include "runtime/plan/needs.h"
#include "runtime/pose/pose.h"

namespace sinew::python {

/// Local poses of any number of frames, as arrays.
struct PoseArrays {
  ArrayMemory<float> translations;  ///< [frame, joint, 3]
  ArrayMemory<float> rotations;     ///< [frame, joint, 4] x y z w
  ArrayMemory<float> scales;        ///< [frame, joint, 3]
  ArrayMemory<float> weights;       ///< [frame, weight]

  PoseArrays(std::size_t frames, std::size_t joints, std::size_t weights);
};

/// Views of poses that the caller holds.
struct PoseViews {
  std::size_t frames = 0, joints = 0, weights = 0;
  const float *translations = nullptr, *rotations = nullptr, *scales = nullptr, *morph_weights = nullptr;
};

/// Copies one frame into the planes that jobs read.
/// in   pose  of poses.joints joints
void load_pose(const PoseViews& poses, std::size_t frame, const PoseSpan& pose);

/// Local poses of a clip. See SampleClipJob.
/// in   times_s  finite
PoseArrays sample_clip(const ClipHandle& clip, std::span<const double> times_s, std::size_t threads);

/// World matrices. See LocalToModelJob.
/// out  [frame, joint, 4, 4] rows before columns: `matrix @ (x, y, z, 1)`
ArrayMemory<float> world_matrices(const Scene& scene, const PoseViews& poses, std::size_t threads);

/// Weighted mean of poses of the same frames. See BlendPosesJob.
/// in   weights  [poses]
PoseArrays blend(const Scene& scene, std::span<const PoseViews> poses, std::span<const float> weights);

/// Vertices of one primitive of one mesh instance in world space.
struct SkinnedPrimitive {
  std::uint32_t node = 0, mesh = 0, primitive = 0;
  ArrayMemory<float> positions;  ///< [frame, vertex, 3]
  ArrayMemory<float> normals;    ///< [frame, vertex, 3]; without vertices if not asked for
};

/// Morphed and skinned vertices of all mesh instances, in the order of the file's vertices.
/// in   threads  run frames at the same time; results have the same bits for any number
std::vector<SkinnedPrimitive> skin(const SceneHandle& scene, const PoseViews& poses, Skinning kind, bool normals,
                                   std::size_t threads);

}  // namespace sinew::python
