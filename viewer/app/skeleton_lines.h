// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <vector>

#include "runtime/math/affine.h"
#include "runtime/model/scene.h"
#include "viewer/passes/frame_renderer.h"

namespace sinew::viewer {

/// Lines that show the skeleton: the joints of the skins and every joint between two of them, or all joints when the
/// scene has no skin.
class SkeletonLines {
 public:
  explicit SkeletonLines(const Scene& scene);

  static constexpr std::size_t kVerticesPerBone = 24;

  /// For each bone the outline of a long octahedron from parent to joint, thick at the parent; for each joint its x, y
  /// and z axes in red, green and blue. A bone of length zero has no outline.
  /// in   model[J]  world matrices;   axis_m  length of an axis: axis_length_m()
  /// out  valid until the next call
  std::span<const LineVertex> make(std::span<const Affine> model, float axis_m);

  /// A small part of the size of what is shown, so that axes do not hide bones; longer if the scene has only joints.
  float axis_length_m(const Aabb& shown) const noexcept;

  std::size_t bone_count() const noexcept { return bones_.size(); }

 private:
  struct Bone {
    std::uint32_t parent, joint;
  };
  bool alone_ = false;  ///< the scene has no meshes
  std::vector<Bone> bones_;
  std::vector<std::uint32_t> joints_;
  std::vector<LineVertex> lines_;  ///< empty until the first call of make(), then reused: frames do not allocate
};

/// Box of the positions of the joints, for scenes without meshes.
Aabb bounds_of_joints(std::span<const Affine> model) noexcept;

}  // namespace sinew::viewer
