// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <span>
#include <vector>

#include "runtime/math/affine.h"
#include "runtime/model/scene.h"
#include "viewer/passes/frame_renderer.h"

namespace sinew::viewer {

/// Marks the joints that are drawn and framed: those of skins and between them; without skins those with a parent or a
/// child, else all. So a value of a clip on a node of its own (as in .vrma files) is no part of a skeleton.
/// out  [J]
std::vector<bool> joints_of_skeleton(const Scene& scene);

/// Draws the skeleton as lines: the joints of all skins and every joint between two of them. If the scene has no skin,
/// all joints.
class SkeletonLines {
 public:
  explicit SkeletonLines(const Scene& scene);

  static constexpr std::size_t kVerticesPerBone = 24;

  /// Makes an elongated octahedron for each bone, thick at the parent, and x, y and z axes in red, green and blue for
  /// each joint. A bone of length zero has no outline.
  /// in   model[J]  world matrices;   axis_m  length of an axis, from axis_length_m()
  /// out  valid until the next call
  std::span<const LineVertex> make(std::span<const Affine> model, float axis_m);

  /// x, y and z axes of a joint in red, green and blue. An axis that the joint scales to zero is a point.
  static std::array<LineVertex, 6> axes_of(const Affine& joint, float axis_m) noexcept;

  /// Axis length relative to the size of the shown scene: short, so that axes do not hide bones. Without meshes axes
  /// are longer, and the more so the fewer joints there are.
  float axis_length_m(const Aabb& shown) const noexcept;

  std::size_t bone_count() const noexcept { return bones_.size(); }

 private:
  struct Bone {
    std::uint32_t parent, joint;
  };
  bool alone_ = false;  ///< the scene has no meshes
  std::vector<Bone> bones_;
  std::vector<std::uint32_t> joints_;
  std::vector<LineVertex> lines_;  ///< reused, so that frames do not allocate
};

/// Positions of the marked joints.
/// in   joints[J], model[J]
std::vector<glm::vec3> places_of(const std::vector<bool>& joints, std::span<const Affine> model);

}  // namespace sinew::viewer
