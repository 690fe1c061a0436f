// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <span>

#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>

#include "runtime/deform/vertex_streams.h"
#include "runtime/model/mesh.h"

/// The vertex jobs in plain GLM code.
namespace sinew::bench::glm_skin {

/// Adds all targets of non-zero weight to positions and normals.
inline void morph(const MorphSet& morphs, std::span<const float> weights, const VertexInput& in,
                  const VertexOutput& out) {
  std::copy(in.positions.begin(), in.positions.end(), out.positions.begin());
  std::copy(in.normals.begin(), in.normals.end(), out.normals.begin());
  for (std::size_t t = 0; t < weights.size(); ++t) {
    if (weights[t] == 0) continue;
    const MorphTarget& target = morphs.targets[t];
    for (std::size_t i = 0; i < target.positions.vertices.size(); ++i)
      out.positions[target.positions.vertices[i]] += target.positions.deltas[i] * weights[t];
    for (std::size_t i = 0; i < target.normals.vertices.size(); ++i)
      out.normals[target.normals.vertices[i]] += target.normals.deltas[i] * weights[t];
  }
  for (glm::vec3& n : out.normals) n = glm::normalize(n);
}

/// The attributes to write besides positions.
struct Attributes {
  bool normals = false, tangents = false;
};

inline void skin_linear(const VertexInfluences& influences, std::span<const glm::mat4> palette, const VertexInput& in,
                        const VertexOutput& out, Attributes wanted) {
  for (const InfluenceGroup& group : influences.groups)
    for (std::uint32_t i = 0; i < group.vertex_count; ++i) {
      const std::size_t v = group.first_vertex + i,
                        first = group.first_influence + std::size_t{i} * group.influence_count;
      glm::mat4 m = palette[influences.joints[first]] * influences.weights[first];
      for (std::size_t k = first + 1; k < first + group.influence_count; ++k)
        m += palette[influences.joints[k]] * influences.weights[k];
      out.positions[v] = glm::vec3(m * glm::vec4(in.positions[v], 1));
      if (wanted.normals) out.normals[v] = glm::normalize(glm::mat3(m) * in.normals[v]);
      if (wanted.tangents)
        out.tangents[v] = glm::vec4(glm::normalize(glm::mat3(m) * glm::vec3(in.tangents[v])), in.tangents[v].w);
    }
}

struct Rigid {
  glm::quat real, dual;
};

inline void skin_dual_quaternion(const VertexInfluences& influences, std::span<const Rigid> palette,
                                 const VertexInput& in, const VertexOutput& out, Attributes wanted) {
  for (const InfluenceGroup& group : influences.groups)
    for (std::uint32_t i = 0; i < group.vertex_count; ++i) {
      const std::size_t v = group.first_vertex + i,
                        first = group.first_influence + std::size_t{i} * group.influence_count;
      const Rigid& pivot = palette[influences.joints[first]];
      glm::quat real = pivot.real * influences.weights[first], dual = pivot.dual * influences.weights[first];
      for (std::size_t k = first + 1; k < first + group.influence_count; ++k) {
        const Rigid& next = palette[influences.joints[k]];
        const float w = glm::dot(pivot.real, next.real) < 0 ? -influences.weights[k] : influences.weights[k];
        real += next.real * w;
        dual += next.dual * w;
      }
      const float length = glm::length(real);
      real /= length;
      dual /= length;
      const glm::quat t = (dual * 2.0f) * glm::conjugate(real);
      out.positions[v] = real * in.positions[v] + glm::vec3(t.x, t.y, t.z);
      if (wanted.normals) out.normals[v] = real * in.normals[v];
      if (wanted.tangents) out.tangents[v] = glm::vec4(real * glm::vec3(in.tangents[v]), in.tangents[v].w);
    }
}

/// Rotates each vertex about its center, which is itself linearly blended.
inline void skin_center_of_rotation(const VertexInfluences& influences, std::span<const glm::mat4> matrices,
                                    std::span<const Rigid> palette, std::span<const glm::vec3> centers,
                                    const VertexInput& in, const VertexOutput& out) {
  for (const InfluenceGroup& group : influences.groups)
    for (std::uint32_t i = 0; i < group.vertex_count; ++i) {
      const std::size_t v = group.first_vertex + i,
                        first = group.first_influence + std::size_t{i} * group.influence_count;
      glm::mat4 m = matrices[influences.joints[first]] * influences.weights[first];
      const Rigid& pivot = palette[influences.joints[first]];
      glm::quat real = pivot.real * influences.weights[first];
      for (std::size_t k = first + 1; k < first + group.influence_count; ++k) {
        m += matrices[influences.joints[k]] * influences.weights[k];
        const glm::quat next = palette[influences.joints[k]].real;
        real += next * (glm::dot(pivot.real, next) < 0 ? -influences.weights[k] : influences.weights[k]);
      }
      real = glm::normalize(real);
      out.positions[v] = real * (in.positions[v] - centers[v]) + glm::vec3(m * glm::vec4(centers[v], 1));
      if (!in.normals.empty()) out.normals[v] = real * in.normals[v];
    }
}

}  // namespace sinew::bench::glm_skin
