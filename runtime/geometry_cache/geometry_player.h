// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "runtime/base/api.h"
#include "runtime/geometry_cache/bind_geometry.h"
#include "runtime/geometry_cache/geometry_decoder.h"
#include "runtime/plan/frame_input.h"

namespace sinew {

/// Plays a geometry cache in the mesh instances of one character. A running frame decodes into the player, so do not
/// call it at the same time. Each character needs its own player.
///
///     const GeometryBindings bindings = bind_by_name(cache, scene);
///     GeometryPlayer player(cache, window, scene, bindings.bound);
///     needs.in.cached_instances = player.instances();
///     std::vector<GeometryInput> geometry(needs.in.cached_instances.size());
///     ...
///     std::fill(geometry.begin(), geometry.end(), player.at(time_s));
///     run_plan(plan, {.geometry = geometry}, frame);
class SINEW_API GeometryPlayer {
 public:
  /// The cache and the object behind `frames` must outlive this and must not move; the scene need not live on.
  /// in   bindings  must have passed check(cache, scene, bindings)
  ///      space     space of the cache's vertices: VertexSpace::scene for a baked scene (`sinew bake`),
  ///      VertexSpace::mesh for point caches of a single mesh
  /// cost allocates all memory that playing needs
  GeometryPlayer(const GeometryCache& cache, FrameSource frames, const Scene& scene,
                 std::span<const GeometryBinding> bindings, VertexSpace space = VertexSpace::scene);
  GeometryPlayer(const GeometryPlayer&) = delete;
  GeometryPlayer& operator=(const GeometryPlayer&) = delete;

  /// Mesh instances that the player moves, rising: for Needs::in.cached_instances.
  std::vector<std::uint32_t> instances() const;

  /// The FrameInput::geometry entry for each of these instances.
  /// in   time_s  on the cache's clock (GeometryCache::start_s), clamped to its ends. To loop, wrap the time first
  ///      (playback_clock.h); a window prefetches from the last frame on to the first
  GeometryInput at(double time_s, float weight = 1.0f) noexcept { return {source(), time_s, weight}; }
  VertexSource source() noexcept;  ///< valid as long as this

  /// A box that contains the vertices of an instance at a time, in the space of the cache. Nothing is decoded, so
  /// instances can be culled before they play.
  /// in   instance  one of instances()
  Aabb bounds(std::uint32_t instance, double time_s) const noexcept;

  const GeometryCache& cache() const noexcept { return cache_; }
  const GeometryDecoder& decoder() const noexcept { return decoder_; }
  GeometryStatus status() const noexcept { return status_; }  ///< status of the last decoded frame

 private:
  /// A primitive that the player moves.
  struct Played {
    std::uint32_t primitive = 0;
    std::uint32_t mesh = 0;
    std::size_t positions = 0, normals = 0;             // streams; kNoStream = none
    std::vector<std::uint32_t> position_of, normal_of;  // [V] point of each vertex
  };
  struct Instance {
    std::uint32_t instance = 0;
    std::vector<Played> primitives;  // in the order of the mesh
  };
  static constexpr std::size_t kNoStream = static_cast<std::size_t>(-1);

  void add(const GeometryBinding& binding, const Primitive& primitive);
  const Instance* find(std::uint32_t instance) const noexcept;
  Aabb bounds_of_frame(const Instance& instance, std::uint32_t frame) const noexcept;
  Aabb bounds_between(const Instance& instance, std::uint32_t frame, float part) const noexcept;
  ShownVertices show(std::uint32_t instance, double time_s) noexcept;
  bool write(std::uint32_t instance, std::uint32_t primitive, std::span<glm::vec3> positions,
             std::span<glm::vec3> normals) noexcept;

  const GeometryCache& cache_;
  FrameSource frames_;
  GeometryDecoder decoder_;
  VertexSpace space_;
  std::vector<Instance> instances_;  // rising
  std::vector<glm::vec3> points_;    // scratch for one stream
  std::uint64_t content_ = 0;
  GeometryStatus status_ = GeometryStatus::ok;
};

}  // namespace sinew
