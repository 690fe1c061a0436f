// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "runtime/geometry_cache/bind_geometry.h"
#include "runtime/geometry_cache/geometry_decoder.h"
#include "runtime/plan/frame_input.h"

namespace sinew {

/// Plays a geometry cache in the mesh instances of a character. One for each character: a frame that runs decodes into
/// it, so nothing else may be called meanwhile.
///
///     const GeometryBindings bindings = bind_by_name(cache, scene);
///     GeometryPlayer player(cache, window, scene, bindings.bound);
///     needs.cached_instances = player.instances();
///     std::vector<GeometryInput> geometry(needs.cached_instances.size());
///     ...
///     std::fill(geometry.begin(), geometry.end(), player.at(time_s));
///     run_plan(plan, {.geometry = geometry}, frame);
class GeometryPlayer {
 public:
  /// The cache and what is behind `frames` must outlive this, at their addresses; the scene need not.
  /// in   bindings  must have passed check(cache, scene, bindings)
  ///      space     where the vertices of the cache are: those of a whole scene (`sinew bake` of a clip) in the scene,
  ///                those of one mesh (point caches) in the mesh
  /// cost allocates all memory that playing takes
  GeometryPlayer(const GeometryCache& cache, FrameSource frames, const Scene& scene,
                 std::span<const GeometryBinding> bindings, VertexSpace space = VertexSpace::scene);
  GeometryPlayer(const GeometryPlayer&) = delete;
  GeometryPlayer& operator=(const GeometryPlayer&) = delete;

  /// Mesh instances that it plays, rising: for Needs::cached_instances.
  std::vector<std::uint32_t> instances() const;

  /// What to put into FrameInput::geometry for each of them.
  /// in   time_s  on the clock of the cache (GeometryCache::start_s), clamped to its ends; for a loop wrap it
  ///              (playback_clock.h): a window reads on from the last frame to the first
  GeometryInput at(double time_s, float weight = 1.0f) noexcept { return {source(), time_s, weight}; }
  VertexSource source() noexcept;  ///< valid as long as this

  /// Holds the vertices of an instance at a time, in the space of the cache. Nothing is decoded: an instance that is
  /// culled by it stays out of view.
  /// in   instance  one of instances()
  Aabb bounds(std::uint32_t instance, double time_s) const noexcept;

  const GeometryCache& cache() const noexcept { return cache_; }
  const GeometryDecoder& decoder() const noexcept { return decoder_; }
  GeometryStatus status() const noexcept { return status_; }  ///< of the last frame that was decoded

 private:
  /// A primitive that plays.
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
  std::vector<glm::vec3> points_;    // of one stream
  std::uint64_t content_ = 0;
  GeometryStatus status_ = GeometryStatus::ok;
};

}  // namespace sinew
