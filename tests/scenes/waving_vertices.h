// SPDX-License-Identifier: MIT
#pragma once
#include <cmath>
#include <cstdint>
#include <set>
#include <vector>

#include "runtime/model/scene.h"
#include "runtime/plan/vertex_source.h"

namespace sinew::test {

/// A vertex source without a file: the rest mesh, rotated, stretched and waved as a function of time. It counts its
/// calls. It can be late: times after `there_until` show the vertices of `there_until`.
class WavingVertices {
 public:
  explicit WavingVertices(const Scene& scene, std::uint64_t content = 1) : scene_(scene), content_(content) {}

  VertexSpace space = VertexSpace::scene;
  bool has_normals = false;
  double there_until = 1e9;
  std::set<std::uint32_t> without;  ///< instances that this source does not play
  std::uint64_t shows = 0, writes = 0;

  VertexSource source() noexcept {
    VertexSource out;
    out.has = [](const void* waving, std::uint32_t instance) noexcept {
      return static_cast<const WavingVertices*>(waving)->without.count(instance) == 0;
    };
    out.show = [](void* waving, std::uint32_t instance, double time_s) noexcept {
      return static_cast<WavingVertices*>(waving)->show(instance, time_s);
    };
    out.write = [](void* waving, std::uint32_t instance, std::uint32_t primitive, std::span<glm::vec3> positions,
                   std::span<glm::vec3> normals) noexcept {
      return static_cast<WavingVertices*>(waving)->write(instance, primitive, positions, normals);
    };
    out.context = this;
    out.content = content_;
    out.space = space;
    return out;
  }

  /// Position of a vertex at a time.
  glm::vec3 position(std::uint32_t instance, std::uint32_t primitive, std::size_t v, double time_s) const {
    const glm::vec3 x = of(instance, primitive).positions[v];
    const auto t = static_cast<float>(time_s);
    const float c = std::cos(0.7f * t), s = std::sin(0.7f * t), own = 0.1f * static_cast<float>(content_ % 7);
    return {c * x.x - s * x.z + own, 1.25f * x.y + 0.2f * std::sin(3.0f * x.x + t), s * x.x + c * x.z + 0.1f * t};
  }
  glm::vec3 normal(std::size_t v, double time_s) const {
    const float angle = static_cast<float>(v) + static_cast<float>(time_s);
    return {std::cos(angle), 0.0f, std::sin(angle)};
  }
  Aabb bounds(std::uint32_t instance, double time_s) const {
    Aabb box;
    for (std::uint32_t p = 0; p < scene_.meshes[scene_.instances[instance].mesh].primitives.size(); ++p)
      for (std::size_t v = 0; v < of(instance, p).vertex_count(); ++v) box.add(position(instance, p, v, time_s));
    return box;
  }

 private:
  const Primitive& of(std::uint32_t instance, std::uint32_t primitive) const {
    return scene_.meshes[scene_.instances[instance].mesh].primitives[primitive];
  }

  ShownVertices show(std::uint32_t instance, double time_s) {
    ++shows;
    ShownVertices shown;
    shown.is_late = time_s > there_until;
    const double before = time_s_;
    time_s_ = (shown.is_late ? there_until : time_s) + 0.0;  // + 0.0 turns -0.0 into +0.0
    shown.is_there = there_until > -1e9;
    shown.moment = static_cast<std::uint64_t>(std::llround(time_s_ * 1024.0));
    shown.bounds = bounds(instance, time_s_);
    shown.frames_decoded = before != time_s_;
    return shown;
  }
  bool write(std::uint32_t instance, std::uint32_t primitive, std::span<glm::vec3> positions,
             std::span<glm::vec3> normals) {
    ++writes;
    for (std::size_t v = 0; v < positions.size(); ++v) positions[v] = position(instance, primitive, v, time_s_);
    for (std::size_t v = 0; v < normals.size() && has_normals; ++v) normals[v] = normal(v, time_s_);
    return has_normals && !normals.empty();
  }

  const Scene& scene_;
  std::uint64_t content_;
  double time_s_ = -1e300;
};

}  // namespace sinew::test
