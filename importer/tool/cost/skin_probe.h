// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <string>
#include <vector>

#include "importer/tool/cost/true_pose.h"

namespace sinew::cost {

/// Points on the surface of the model, where viewers see the difference of two poses. They are vertices, skinned
/// linearly in double precision or carried by their joint. A scene without vertices gets three points around every
/// joint, on perpendicular axes, a twentieth of the skeleton's size away.
class SkinProbe {
 public:
  SkinProbe(const Scene& scene, std::size_t most_points);

  /// Largest distance of a point between the two poses, in metres.
  double distance_m(std::span<const Affined> a, std::span<const Affined> b) const;

  std::size_t point_count() const noexcept { return first_pull_.size() - 1; }
  bool has_vertices() const noexcept { return has_vertices_; }
  /// "4000 of the 28338 vertices", "three points around each joint, ..."
  std::string description() const;

 private:
  /// One joint's share in a point: its weight, and the point in the joint's space.
  struct Pull {
    std::uint32_t joint = 0;
    double weight = 1.0;
    Vec3<double> place{0.0};
  };
  void add_instance(const Scene& scene, const MeshInstance& instance, std::size_t step);
  void add_skinned_vertices(const Primitive& primitive, const Skin& skin, std::size_t step);
  void add_joints(const Skeleton& skeleton);
  void add_point(Pull pull) {
    pulls_.push_back(pull);
    first_pull_.push_back(pulls_.size());
  }
  Vec3<double> point(std::size_t i, std::span<const Affined> model) const;

  std::vector<Pull> pulls_;
  std::vector<std::size_t> first_pull_{0};  // [points + 1]
  bool has_vertices_ = true;
  std::size_t vertices_of_scene_ = 0;
};

}  // namespace sinew::cost
