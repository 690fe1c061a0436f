// SPDX-License-Identifier: MIT
#include "runtime/c_geometry/sinew_geometry.h"

#include <cmath>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "runtime/c/glue/call.h"
#include "runtime/c/glue/convert.h"
#include "runtime/c/glue/enum_pairs.h"
#include "runtime/c/glue/struct_versions.h"
#include "runtime/c/glue/write_messages.h"
#include "runtime/c/handles.h"
#include "runtime/c/vertex_source.h"
#include "runtime/geometry_cache/frame_window.h"
#include "runtime/geometry_cache/geometry_player.h"
#include "runtime/geometry_cache/scene_of_cache.h"

using namespace sinew;

struct sinew_geometry_cache {
  GeometryCache cache;
  std::span<const std::byte> file;

  bool is_whole() const noexcept { return file.size() == cache.file_bytes(); }
};

namespace sinew::c {

template <>
inline constexpr auto kEnum<ReadOutcome> =
    enum_values<ReadOutcome, sinew_read_outcome>({{ReadOutcome::done, SINEW_READ_DONE},
                                                  {ReadOutcome::pending, SINEW_READ_PENDING},
                                                  {ReadOutcome::failed, SINEW_READ_FAILED}});
template <>
inline constexpr bool kSameBytes<sinew_geometry_binding, GeometryBinding> = true;

}  // namespace sinew::c

namespace {

/// Converts the engine's reader to one that a window can call. `given` must not move.
FrameReader reader_from(sinew_frame_reader& given) noexcept {
  const auto read = [](void* context, std::uint64_t offset, std::span<std::byte> into, FrameRead& pending) noexcept {
    const auto& engine = *static_cast<const sinew_frame_reader*>(context);
    auto* const handle = reinterpret_cast<sinew_frame_read*>(&pending);
    return static_cast<ReadOutcome>(engine.read(engine.context, offset, into.data(), into.size(), handle));
  };
  return {read, &given};
}

/// The frames of a file in memory, or of a window over a file that is not.
class Frames {
 public:
  Frames(const sinew_geometry_cache& cache, const sinew_frame_reader& reader, std::uint32_t window_frames)
      : mapped_{cache.cache, cache.file}, reader_(reader) {
    if (reader.read != nullptr) window_.emplace(cache.cache, reader_from(reader_), window_frames);
  }
  Frames(const Frames&) = delete;
  Frames& operator=(const Frames&) = delete;

  operator FrameSource() noexcept { return window_ ? FrameSource(*window_) : FrameSource(mapped_); }
  const std::optional<FrameWindow>& window() const noexcept { return window_; }

 private:
  MappedFrames mapped_;
  sinew_frame_reader reader_;
  std::optional<FrameWindow> window_;
};

}  // namespace

struct sinew_geometry_player {
  sinew_geometry_player(const sinew_geometry_cache& cache, const sinew_scene& scene,
                        const sinew_geometry_player_options& options, std::span<const GeometryBinding> bindings)
      : frames(cache, options.reader, options.window_frames),
        player(cache.cache, frames, scene.scene, bindings,
               options.in_mesh_space != 0 ? VertexSpace::mesh : VertexSpace::scene),
        instances(player.instances()) {}

  Frames frames;
  GeometryPlayer player;
  std::vector<std::uint32_t> instances;
};

std::uint64_t sinew_geometry_head_bytes(const void* start, std::size_t byte_count) {
  return start != nullptr ? GeometryCache::head_bytes({static_cast<const std::byte*>(start), byte_count}) : 0;
}

sinew_error sinew_geometry_open(const void* bytes, std::size_t byte_count, std::uint64_t file_bytes,
                                sinew_geometry_cache** out, sinew_messages** messages) {
  return c::call(c::given(bytes, out), [&] {
    const std::span file(static_cast<const std::byte*>(bytes), byte_count);
    auto cache = GeometryCache::open(file, file_bytes);
    if (!cache) {
      const GeometryCacheError& why = cache.error();
      return c::bad_file(why.rule + ": byte " + std::to_string(why.offset) + ": " + why.detail, messages);
    }
    auto opened = std::make_unique<sinew_geometry_cache>(sinew_geometry_cache{std::move(*cache), file});
    c::write_messages({}, messages);
    *out = opened.release();
    return SINEW_OK;
  });
}

void sinew_geometry_close(sinew_geometry_cache* cache) { delete cache; }

sinew_error sinew_geometry_get_info(const sinew_geometry_cache* cache, sinew_geometry_info* out) {
  return c::call(c::given(cache), [&] {
    const GeometryCache& own = cache->cache;
    return c::write_struct({.struct_size = 0,
                            .mesh_count = c::to_c(own.meshes().size()),
                            .frame_count = own.frame_count(),
                            .segment_frames = own.segment_frames(),
                            .start_s = own.start_s(),
                            .duration_s = own.duration_s(),
                            .frame_s = own.frame_s(),
                            .largest_frame_bytes = own.largest_frame()},
                           out);
  });
}

sinew_error sinew_geometry_get_mesh(const sinew_geometry_cache* cache, std::uint32_t mesh, sinew_geometry_mesh* out) {
  return c::call(c::given(cache), [&] {
    if (mesh >= cache->cache.meshes().size()) return SINEW_INDEX_OUT_OF_RANGE;
    const GeometryMesh& own = cache->cache.meshes()[mesh];
    return c::write_struct({.struct_size = 0,
                            .name = c::to_c(own.name),
                            .vertex_count = own.vertex_count,
                            .triangle_count = c::to_c(own.triangles.size() / 3),
                            .bounds = c::to_c(own.bounds),
                            .asked_m = own.streams[0].asked,
                            .measured_m = own.streams[0].measured},
                           out);
  });
}

void sinew_frame_read_finish(sinew_frame_read* read, int ok) {
  if (read != nullptr) reinterpret_cast<FrameRead*>(read)->finish(ok != 0);
}

sinew_error sinew_geometry_scene(const sinew_geometry_cache* cache, const sinew_frame_reader* reader,
                                 sinew_scene** out) {
  return c::call(c::given(cache, out) && (reader == nullptr || c::given(reader->read)), [&] {
    Frames frames(*cache, reader != nullptr ? *reader : sinew_frame_reader{nullptr, nullptr}, 1);
    auto made = scene_of(cache->cache, frames);
    if (!made) return SINEW_BAD_FILE;
    *out = new sinew_scene{std::move(made->scene)};
    return SINEW_OK;
  });
}

sinew_geometry_player_options sinew_default_geometry_player_options(void) {
  return {.struct_size = sizeof(sinew_geometry_player_options),
          .bindings = nullptr,
          .binding_count = 0,
          .in_mesh_space = 0,
          .window_frames = 16,
          .reader = {nullptr, nullptr}};
}

sinew_error sinew_geometry_player_create(const sinew_geometry_cache* cache, const sinew_scene* scene,
                                         const sinew_geometry_player_options* options, sinew_geometry_player** out,
                                         sinew_messages** unbound) {
  return c::call(c::given(cache, scene, out), [&] {
    sinew_geometry_player_options own = sinew_default_geometry_player_options();
    if (const sinew_error error = c::read_struct(options, own)) return error;
    if (!c::given(c::Array{own.bindings, own.binding_count})) return SINEW_NULL_ARGUMENT;
    if (own.reader.read != nullptr ? own.window_frames == 0 : !cache->is_whole()) return SINEW_UNSUPPORTED;
    GeometryBindings bindings;
    if (own.bindings == nullptr) bindings = bind_by_name(cache->cache, scene->scene);
    const auto* first = reinterpret_cast<const GeometryBinding*>(own.bindings);
    bindings.bound.insert(bindings.bound.end(), first, first + own.binding_count);
    c::write_messages(std::move(bindings.unbound), unbound);
    if (bindings.bound.empty()) return SINEW_UNSUPPORTED;
    const ErrorCode code = check(cache->cache, scene->scene, bindings.bound);
    if (code != ErrorCode::ok) return c::error_from(code);
    *out = new sinew_geometry_player(*cache, *scene, own, bindings.bound);
    return SINEW_OK;
  });
}

void sinew_geometry_player_destroy(sinew_geometry_player* player) { delete player; }

sinew_indices sinew_geometry_player_instances(const sinew_geometry_player* player) {
  if (player == nullptr) return {nullptr, 0};
  return c::to_c(player->instances);
}

sinew_vertex_source sinew_geometry_player_source(sinew_geometry_player* player) {
  if (player == nullptr) return {};
  return c::to_c(player->player.source());
}

sinew_error sinew_geometry_player_bounds(const sinew_geometry_player* player, std::uint32_t instance, double time_s,
                                         sinew_box* out) {
  return c::call(c::given(player, out), [&] {
    if (!std::isfinite(time_s)) return SINEW_NOT_FINITE;
    const Aabb box = player->player.bounds(instance, time_s);
    if (box.empty()) return SINEW_INDEX_OUT_OF_RANGE;
    *out = c::to_c(box);
    return SINEW_OK;
  });
}

sinew_error sinew_geometry_player_work(const sinew_geometry_player* player, sinew_geometry_work* out) {
  return c::call(c::given(player), [&] {
    const std::optional<FrameWindow>& window = player->frames.window();
    const GeometryDecoder& decoder = player->player.decoder();
    return c::write_struct({.struct_size = 0,
                            .frames_decoded = decoder.frames_decoded(),
                            .bytes_asked = window ? window->bytes_requested() : 0,
                            .memory_bytes = decoder.memory_bytes() + (window ? window->memory_bytes() : 0),
                            .pending_reads = window ? window->pending_reads() : 0},
                           out);
  });
}
