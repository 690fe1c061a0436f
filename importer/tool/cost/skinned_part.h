// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "importer/tool/cost/subject.h"
#include "runtime/deform/skin_linear.h"
#include "runtime/deform/vertex_streams.h"
#include "runtime/math/normal_transform.h"
#include "runtime/model/skin.h"
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

/// The part of a scene; empty if the scene has no skinned vertices.
std::optional<SkinnedPart> skinned_part(const Subject& subject);

/// Memory for deformed vertices.
struct DeformedVertices {
  std::vector<glm::vec3> positions, normals;

  explicit DeformedVertices(std::size_t count = 0) : positions(count), normals(count) {}
  VertexOutput out() { return {positions, normals, {}}; }
};

/// Deformed vertices in the precision of T.
template <class T>
struct PlainVertices {
  std::vector<Vec3<T>> positions, normals;

  explicit PlainVertices(std::size_t count = 0) : positions(count), normals(count) {}
};

/// Linear-blend skinning in plain arithmetic, one vertex after the other: the truth (T = double), and the way to time
/// what the truth costs.
/// eq   M = sum(w_i * palette[joint_i]) / sum(w_i),  p' = M p   (Real-Time Rendering, eq. 4.59);  n' by `rule`
/// in   in   normals may be empty
/// out  out  with as many vertices as `in`
template <class T>
void skin_plainly(const VertexInfluences& influences, std::span<const AffineT<T>> palette, const VertexInput& in,
                  NormalRule rule, PlainVertices<T>& out) {
  for (const InfluenceGroup& group : influences.groups)
    for (std::size_t v = 0; v < group.vertex_count; ++v) {
      AffineT<T> m{{Vec4<T>(T(0)), Vec4<T>(T(0)), Vec4<T>(T(0))}};
      T total = T(0);
      for (std::size_t i = 0; i < group.influence_count; ++i) {
        const std::size_t at = group.first_influence + v * group.influence_count + i;
        const T weight = static_cast<T>(influences.weights[at]);
        for (int r = 0; r < 3; ++r) m.row[r] += palette[influences.joints[at]].row[r] * weight;
        total += weight;
      }
      for (auto& row : m.row) row /= total;
      const std::size_t vertex = group.first_vertex + v;
      out.positions[vertex] = transform_point(m, Vec3<T>(in.positions[vertex]));
      if (in.normals.empty()) continue;
      const Vec3<T> n(in.normals[vertex]);
      out.normals[vertex] = rule == NormalRule::cofactor ? transform_normal_outward(linear_part(m), n)
                                                         : normalised_or(transform_vector(m, n), n);
    }
}

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
