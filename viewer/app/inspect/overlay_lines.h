// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "viewer/app/clip_poses.h"
#include "viewer/app/inspect/inspected.h"
#include "viewer/app/loaded_scene.h"
#include "viewer/app/skeleton_lines.h"

namespace sinew::viewer {

/// The lines over a picture: the skeleton, and what shows the inspected joint and vertex.
class OverlayLines {
 public:
  /// in   loaded  must outlive this
  explicit OverlayLines(const LoadedScene& loaded) : loaded_(loaded), skeleton_(loaded.scene) {}

  /// A moment of a clip, for the ways through it.
  struct Moment {
    std::uint32_t clip = kNone;
    double time_s = 0.0;
    const MovedBy* moved = nullptr;  ///< layers or root motion; null = the clip alone
  };

  /// in   size  bounds of the character, which axes are scaled by
  /// out  valid until the next call
  /// cost O(lines); the first call for a clip evaluates 64 poses if a trail or ghosts are shown, and the first one with a
  ///      wireframe sorts all edges
  std::span<const LineVertex> make(const FrameResult& frame, const Inspected& inspected, bool skeleton,
                                   const Moment& moment, const Aabb& size);

 private:
  struct Edge {
    std::uint32_t a, b;
    friend auto operator<=>(const Edge&, const Edge&) = default;
  };

  void add_wireframe(const FrameResult& frame);
  void add_boxes(const FrameResult& frame);
  void add_joint(std::span<const Affine> model, std::uint32_t joint, float axis_m);
  void add_vertex(const FrameResult& frame, const VertexPlace& vertex, float axis_m);
  void add_trail(std::uint32_t joint);
  void add_ghosts(double time_s, float axis_m);
  void evaluate_poses(const Moment& moment);

  const LoadedScene& loaded_;
  SkeletonLines skeleton_;
  std::vector<std::vector<std::vector<Edge>>> edges_;  ///< [meshes][primitives] each edge once; made when first drawn
  std::uint32_t poses_clip_ = kNone;
  MotionSettings poses_moved_by_;
  std::vector<double> pose_times_s_;
  std::vector<std::vector<Affine>> poses_;  ///< [times][J] of the clip; empty = not evaluated
  std::vector<LineVertex> lines_;           ///< reused, so that frames do not allocate
};

}  // namespace sinew::viewer
