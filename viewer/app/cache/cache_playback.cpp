// SPDX-License-Identifier: MIT
#include "viewer/app/cache/cache_playback.h"

#include <algorithm>
#include <thread>

#include "runtime/plan/plan_stages.h"

namespace sinew::viewer {
namespace {

constexpr double kCount_s = 0.5;    // period over which the read rate is measured
constexpr double kSmoothing = 0.1;  // weight of the newest frame in the moving average
constexpr std::uint32_t kReadAhead =
    8;  // window frames beyond a whole segment; backward playback decodes the segment repeatedly

std::uint32_t window_of(const GeometryCache& cache) { return cache.segment_frames() + kReadAhead; }

}  // namespace

CachePlayback::CachePlayback(const CacheOnScene& cache, const Scene& scene, CacheReader::Reads reads)
    : cache_(cache),
      reads_(reads),
      reader_(cache.file, reads, window_of(cache.file.cache)),
      window_(cache.file.cache, reader_.reader(), window_of(cache.file.cache)),
      player_(cache.file.cache, window_, scene, cache.bindings),
      inputs_(cache.instances().size()) {
  if (reads == CacheReader::Reads::blocking) return;
  window_.prefetch(0);  // so that the first picture shows the right frame
  while (window_.pending_reads() > 0) std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

std::span<const GeometryInput> CachePlayback::at(double time_s, float weight) noexcept {
  std::fill(inputs_.begin(), inputs_.end(), player_.at(cache_.start_s + time_s, weight));
  return inputs_;
}

std::string CachePlayback::fault() const {
  const GeometryStatus status = player_.status();
  const bool unread = status == GeometryStatus::not_loaded && reads_ == CacheReader::Reads::blocking;
  return status == GeometryStatus::damaged || unread ? describe_fault(cache_.file, status) : std::string();
}

void CachePlayback::watch(const FrameResult& frame, Clock::time_point now) {
  if (frame.frame == recorded_frame_) return;
  recorded_frame_ = frame.frame;
  late_ += is_late(frame);
  const auto stage = static_cast<std::size_t>(Stage::geometry_cache);
  if (frame.work.cache_frames_decoded * frame.work.vertices_from_cache > 0 && stage < frame.stage_ns.size()) {
    const double decoded = static_cast<double>(frame.work.vertices_from_cache * frame.work.cache_frames_decoded);
    const double newest = static_cast<double>(frame.stage_ns[stage]) / decoded;
    ns_per_vertex_ = ns_per_vertex_ ? *ns_per_vertex_ + kSmoothing * (newest - *ns_per_vertex_) : newest;
  }
  const double passed_s = std::chrono::duration<double>(now - counted_at_).count();
  if (passed_s < kCount_s) return;
  const std::uint64_t bytes = reader_.bytes_read();
  bytes_per_s_ = static_cast<double>(bytes - counted_bytes_) / passed_s;
  counted_bytes_ = bytes;
  counted_at_ = now;
}

CacheFacts CachePlayback::facts() const {
  const GeometryCache& cache = cache_.file.cache;
  CacheFacts facts;
  facts.name = cache_.file.name;
  facts.frame_count = cache.frame_count();
  facts.frame_s = cache.frame_s();
  for (const GeometryMesh& mesh : cache.meshes()) facts.vertex_count += mesh.vertex_count;
  facts.bytes_per_s = bytes_per_s_;
  facts.frames_loaded = window_.frames_loaded();
  facts.window_frames = std::min(window_of(cache), cache.frame_count());
  facts.window_bytes = window_.memory_bytes();
  facts.ns_per_vertex = ns_per_vertex_;
  facts.late = late_;
  return facts;
}

bool is_late(const FrameResult& frame) noexcept {
  return std::any_of(frame.instances.begin(), frame.instances.end(), [](const InstanceResult& i) { return i.late; });
}

}  // namespace sinew::viewer
