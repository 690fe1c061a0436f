// SPDX-License-Identifier: MIT
#include "samples/showcase/polygonise.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

namespace sinew::showcase {
namespace {

using Field = std::function<float(const glm::vec3&)>;

/// Samples of a field at the corners of cells.
class Samples {
 public:
  Samples(const Field& field, const Aabb& bounds, float cell) : lower_(bounds.lower), cell_(cell) {
    const glm::vec3 cells = glm::ceil((bounds.upper - bounds.lower) / cell);
    size_ = glm::ivec3(cells) + 1;
    values_.resize(static_cast<std::size_t>(size_.x) * static_cast<std::size_t>(size_.y) *
                   static_cast<std::size_t>(size_.z));
    int block = 1;
    while (block < std::max({size_.x, size_.y, size_.z})) block *= 2;
    sample_block(field, glm::ivec3(0), block);
  }

  glm::ivec3 size() const { return size_; }
  glm::vec3 place(const glm::vec3& corner) const { return lower_ + cell_ * corner; }
  std::size_t index(const glm::ivec3& c) const {
    return static_cast<std::size_t>((c.z * size_.y + c.y) * size_.x + c.x);
  }
  float at(const glm::ivec3& c) const { return values_[index(c)]; }

 private:
  /// Samples a block. If its middle is far from the surface, that value serves for the whole block; else each eighth is
  /// sampled.
  void sample_block(const Field& field, const glm::ivec3& first, int block) {
    if (glm::any(glm::greaterThanEqual(first, size_))) return;
    const float middle = field(place(glm::vec3(first) + 0.5f * static_cast<float>(block - 1)));
    const bool far = std::abs(middle) > 1.2f * cell_ * static_cast<float>(block);  // the corners are nearer than 0.87
    if (block > 1 && !far) {
      for (int eighth = 0; eighth < 8; ++eighth)
        sample_block(field, first + block / 2 * glm::ivec3(eighth & 1, eighth >> 1 & 1, eighth >> 2), block / 2);
      return;
    }
    const glm::ivec3 end = glm::min(first + block, size_);
    for (int z = first.z; z < end.z; ++z)
      for (int y = first.y; y < end.y; ++y)
        for (int x = first.x; x < end.x; ++x) values_[index({x, y, z})] = middle;
  }

  glm::vec3 lower_;
  float cell_;
  glm::ivec3 size_{};
  std::vector<float> values_;
};

/// Gradient from the values at the four corners of a tetrahedron around p.
glm::vec3 gradient(const Field& field, const glm::vec3& p, float step) {
  constexpr glm::vec3 kCorners[] = {
      {1.0f, 1.0f, 1.0f}, {1.0f, -1.0f, -1.0f}, {-1.0f, 1.0f, -1.0f}, {-1.0f, -1.0f, 1.0f}};
  glm::vec3 sum(0.0f);
  for (const glm::vec3& corner : kCorners) sum += field(p + step * corner) * corner;
  return sum / (4.0f * step);
}

/// Mean of the points where the surface crosses the edges of a cell, in corners; false if it crosses none.
bool crossing(const Samples& samples, const glm::ivec3& cell, glm::vec3& mean) {
  glm::vec3 sum(0.0f);
  int count = 0;
  for (int axis = 0; axis < 3; ++axis)
    for (int edge = 0; edge < 4; ++edge) {
      glm::ivec3 a = cell;
      a[(axis + 1) % 3] += edge & 1;
      a[(axis + 2) % 3] += edge >> 1;
      glm::ivec3 b = a;
      ++b[axis];
      const float at_a = samples.at(a), at_b = samples.at(b);
      if ((at_a < 0.0f) == (at_b < 0.0f)) continue;
      sum += glm::mix(glm::vec3(a), glm::vec3(b), at_a / (at_a - at_b));
      ++count;
    }
  if (count > 0) mean = sum / static_cast<float>(count);
  return count > 0;
}

}  // namespace

Primitive polygonise(const Field& field, const Aabb& bounds, float cell) {
  const Samples samples(field, bounds, cell);
  const glm::ivec3 size = samples.size();
  Primitive out;
  std::vector<std::uint32_t> vertex_of(
      static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) * static_cast<std::size_t>(size.z), kNone);
  const auto for_each = [&](int first, const auto& visit) {
    for (int z = first; z + 1 < size.z; ++z)
      for (int y = first; y + 1 < size.y; ++y)
        for (int x = first; x + 1 < size.x; ++x) visit(glm::ivec3(x, y, z));
  };
  for_each(0, [&](const glm::ivec3& c) {
    glm::vec3 mean;
    if (!crossing(samples, c, mean)) return;
    glm::vec3 p = samples.place(mean);
    const glm::vec3 slope = gradient(field, p, 0.1f * cell);
    const float square = std::max(glm::dot(slope, slope), 0.25f);
    out.normals.push_back(glm::normalize(slope));
    p -= glm::clamp(field(p) / square, -0.5f * cell, 0.5f * cell) * slope;
    vertex_of[samples.index(c)] = static_cast<std::uint32_t>(out.positions.size());
    out.positions.push_back(p);
    out.bounds.add(p);
  });
  // Four cells share an edge. Where the surface crosses the edge, the vertices of these cells make a face.
  for_each(1, [&](const glm::ivec3& c) {
    for (int axis = 0; axis < 3; ++axis) {
      glm::ivec3 next = c, u(0), v(0);
      ++next[axis];
      u[(axis + 1) % 3] = 1;
      v[(axis + 2) % 3] = 1;
      const bool inside = samples.at(c) < 0.0f;
      if (inside == (samples.at(next) < 0.0f)) continue;
      std::array<std::uint32_t, 4> face;
      int corner = 0;
      for (const glm::ivec3& other : {c - u - v, c - v, c, c - u}) face[corner++] = vertex_of[samples.index(other)];
      if (!inside) std::swap(face[1], face[3]);
      out.indices.insert(out.indices.end(), {face[0], face[1], face[2], face[0], face[2], face[3]});
    }
  });
  return out;
}

}  // namespace sinew::showcase
