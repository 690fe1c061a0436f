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

/// Plays a cache for one character, through a window of frames over its file. Only `at` and what it says otherwise may
/// be called while a frame runs.
class CachePlayback {
 public:
  using Clock = std::chrono::steady_clock;

  /// in   cache, scene  must outlive this
  CachePlayback(const CacheOnScene& cache, const Scene& scene, CacheReader::Reads reads);
  ~CachePlayback() { reader_.stop(); }
  CachePlayback(const CachePlayback&) = delete;
  CachePlayback& operator=(const CachePlayback&) = delete;

  /// The value of FrameInput::geometry at a time of the scene's clock. Valid until the next call.
  std::span<const GeometryInput> at(double time_s, float weight) noexcept;

  /// Why the last frame could not be shown, in one sentence; empty when it could, or when it only is late.
  std::string fault() const;

  /// Records a frame, for facts(). A frame that was recorded last is left out.
  void watch(const FrameResult& frame, Clock::time_point now = Clock::now());

  std::uint64_t bytes_read() const noexcept { return reader_.bytes_read(); }

  /// For the panel. May be called while a frame runs.
  CacheFacts facts() const;

 private:
  const CacheOnScene& cache_;
  CacheReader::Reads reads_;
  CacheReader reader_;
  FrameWindow window_;
  GeometryPlayer player_;
  std::vector<GeometryInput> inputs_;
  std::uint64_t watched_frame_ = 0, late_ = 0;
  std::optional<double> ns_per_vertex_;
  Clock::time_point counted_at_ = Clock::now();
  std::uint64_t counted_bytes_ = 0;
  double bytes_per_s_ = 0.0;
};

/// The cache had not all that was asked for: an instance shows an older frame, or its pose.
bool is_late(const FrameResult& frame) noexcept;

}  // namespace sinew::viewer
