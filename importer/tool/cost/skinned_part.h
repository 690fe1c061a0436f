// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "importer/tool/cost/plain_skinning.h"
#include "importer/tool/cost/subject.h"
#include "runtime/pose/joint_palette.h"

namespace sinew::cost {

/// The matrices of a skin in one pose: as the jobs read them, and the same numbers in double for the truth.
struct PosedSkin {
  std::vector<JointMatrix> palette;
  std::vector<Affined> exact;

  PosedSkin() = default;
  PosedSkin(const Skin& skin, std::span<const Affined> model);
};

/// The primitive with the most skinned vertices, in some poses.
struct SkinnedPart {
  const Primitive* primitive = nullptr;
  const Skin* skin = nullptr;
  const Skeleton* skeleton = nullptr;
  std::vector<PosedSkin> poses;
  std::string description;  ///< "3273 vertices with up to 4 influences, in 8 poses of the clip "Walk""

  std::size_t vertex_count() const { return primitive->vertex_count(); }
  VertexInput in() const { return {primitive->positions, primitive->normals, {}}; }
};

/// The part of a scene; nothing where it has no skinned vertices.
std::optional<SkinnedPart> skinned_part(const Subject& subject);

/// Memory for deformed vertices.
struct DeformedVertices {
  std::vector<glm::vec3> positions, normals;

  explicit DeformedVertices(std::size_t count = 0) : positions(count), normals(count) {}
  VertexOutput out() { return {positions, normals, {}}; }
};

/// Largest distance between two lists of points, in their unit.
template <class A, class B>
double largest_distance(std::span<const A> a, std::span<const B> b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
    largest = std::max(largest, safe_length(Vec3<double>(a[i]) - Vec3<double>(b[i])));
  return largest;
}

/// Angle between a direction and a unit vector, in degrees.
double angle_deg(const glm::vec3& direction, const Vec3<double>& unit);

}  // namespace sinew::cost
