// SPDX-License-Identifier: MIT
#pragma once
#include <chrono>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "runtime/geometry_cache/geometry_player.h"
#include "runtime/plan/frame_result.h"
#include "viewer/app/cache/cache_facts.h"
#include "viewer/app/cache/cache_on_scene.h"
#include "viewer/app/cache/cache_reader.h"

namespace sinew::viewer {

/// Plays a cache for one character, through a window of loaded frames. While a frame is evaluated, only at() and
/// facts() may be called.
class CachePlayback {
 public:
  using Clock = std::chrono::steady_clock;

  /// in   cache, scene  must outlive this
  CachePlayback(const CacheOnScene& cache, const Scene& scene, CacheReader::Reads reads);
  ~CachePlayback() { reader_.stop(); }
  CachePlayback(const CachePlayback&) = delete;
  CachePlayback& operator=(const CachePlayback&) = delete;

  /// The value of FrameInput::geometry at a scene time. Valid until the next call.
  std::span<const GeometryInput> at(double time_s, float weight) noexcept;

  /// One sentence if the last frame cannot be shown; empty if it can, or if it is only late.
  std::string fault() const;

  /// Updates the statistics of facts() with an evaluated frame. Recording the same frame again has no effect.
  void watch(const FrameResult& frame, Clock::time_point now = Clock::now());

  std::uint64_t bytes_read() const noexcept { return reader_.bytes_read(); }

  /// Statistics for the panel. May be called while a frame is evaluated.
  CacheFacts facts() const;

 private:
  const CacheOnScene& cache_;
  CacheReader::Reads reads_;
  CacheReader reader_;
  FrameWindow window_;
  GeometryPlayer player_;
  std::vector<GeometryInput> inputs_;
  std::uint64_t recorded_frame_ = 0, late_ = 0;
  std::optional<double> ns_per_vertex_;
  Clock::time_point counted_at_ = Clock::now();
  std::uint64_t counted_bytes_ = 0;
  double bytes_per_s_ = 0.0;
};

/// True if some instance shows an older cache frame, or its pose, because the requested frame was not loaded yet.
bool is_late(const FrameResult& frame) noexcept;

}  // namespace sinew::viewer
