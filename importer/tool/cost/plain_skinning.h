// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <vector>

#include "runtime/deform/skin_linear.h"
#include "runtime/deform/vertex_streams.h"
#include "runtime/math/normal_transform.h"
#include "runtime/model/skin.h"

namespace sinew::cost {

/// Deformed vertices in the precision of T.
template <class T>
struct PlainVertices {
  std::vector<Vec3<T>> positions, normals;

  explicit PlainVertices(std::size_t count = 0) : positions(count), normals(count) {}
};

/// Linear-blend skinning, one vertex after the other, in plain arithmetic: the truth (T = double), and what it costs to
/// have it. eq   M = sum(w_i * palette[joint_i]) / sum(w_i),  p' = M p   (Real-Time Rendering, eq. 4.59);  n' by `rule`
/// in   in.normals may be empty;   out  as many vertices as `in`
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

}  // namespace sinew::cost
