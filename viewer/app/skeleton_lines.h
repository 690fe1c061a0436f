// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <vector>

#include "runtime/math/affine.h"
#include "runtime/model/scene.h"
#include "viewer/passes/frame_renderer.h"

namespace sinew::viewer {

/// The joints that a person means by "the skeleton": those of the skins and every joint between two of them, or all
/// joints with a parent when the scene has no skin.
class SkeletonLines {
 public:
  explicit SkeletonLines(const Scene& scene);

  static constexpr std::size_t kVerticesPerBone = 24;

  /// For each joint the outline of a long octahedron from its parent, thick end at the parent, and the joint's own x, y
  /// and z axis in red, green and blue. A bone without length has no outline. in   model[J]  world matrices;   axis_m
  /// length of an axis: axis_length_m() out  stays valid until the next call
  std::span<const LineVertex> make(std::span<const Affine> model, float axis_m);

  /// Small beside what is shown, so that axes do not hide bones; longer where there is nothing but joints.
  float axis_length_m(const Aabb& shown) const noexcept;

  std::size_t bone_count() const noexcept { return bones_.size(); }

 private:
  struct Bone {
    std::uint32_t parent, joint;
  };
  bool alone_ = false;  ///< the scene has no meshes
  std::vector<Bone> bones_;
  std::vector<std::uint32_t> joints_;
  std::vector<LineVertex> lines_;  ///< kept, so that frames do not allocate
};

/// Box of the joints' positions, for scenes that draw nothing else.
Aabb bounds_of_joints(std::span<const Affine> model) noexcept;

}  // namespace sinew::viewer
