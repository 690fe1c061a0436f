// SPDX-License-Identifier: MIT
#include "runtime/c/clips.h"

#include <algorithm>
#include <utility>

#include "runtime/c/glue/call.h"
#include "runtime/c/glue/convert.h"
#include "runtime/c/glue/write_messages.h"
#include "runtime/c/handles.h"
#include "runtime/c/needs.h"
#include "runtime/clip/clip_file.h"
#include "runtime/lod/clip_bounds.h"
#include "runtime/plan/check_needs.h"

using namespace sinew;

struct sinew_clip_block {
  std::vector<std::byte> bytes;
};

namespace {

bool has_clips(const Scene& scene, std::size_t first, std::size_t count) noexcept {
  return first <= scene.clips.size() && count <= scene.clips.size() - first;
}

}  // namespace

sinew_error sinew_clips_save(const sinew_scene* scene, std::uint32_t first_clip, std::size_t clip_count,
                             sinew_clip_block** out) {
  return c::call(c::given(scene, out), [&] {
    if (!has_clips(scene->scene, first_clip, clip_count)) return SINEW_INDEX_OUT_OF_RANGE;
    std::vector<const Clip*> clips;
    for (std::size_t i = 0; i < clip_count; ++i) clips.push_back(&scene->scene.clips[first_clip + i]);
    *out = new sinew_clip_block{save_clips(clips)};
    return SINEW_OK;
  });
}

sinew_flags sinew_clip_block_bytes(const sinew_clip_block* block) {
  if (block == nullptr) return {nullptr, 0};
  return {reinterpret_cast<const unsigned char*>(block->bytes.data()), block->bytes.size()};
}

void sinew_clip_block_destroy(sinew_clip_block* block) { delete block; }

int sinew_looks_like_clips(const void* bytes, std::size_t byte_count) {
  return bytes != nullptr && looks_like_clips({static_cast<const std::byte*>(bytes), byte_count});
}

sinew_error sinew_clips_load(sinew_scene* scene, std::uint32_t first_clip, const void* bytes, std::size_t byte_count,
                             sinew_messages** messages) {
  return c::call(c::given(scene, bytes), [&] {
    if (scene->plan_count != 0) return SINEW_BUSY;
    auto clips = load_clips({static_cast<const std::byte*>(bytes), byte_count});
    if (!clips) {
      const ClipFileError& why = clips.error();
      return c::bad_file(why.rule + " at byte " + std::to_string(why.offset) + ": " + why.detail, messages);
    }
    Scene& own = scene->scene;
    if (!has_clips(own, first_clip, clips->size())) return SINEW_INDEX_OUT_OF_RANGE;
    if (!std::all_of(clips->begin(), clips->end(), [&](const Clip& clip) { return fits(clip, own); }))
      return SINEW_SIZE_MISMATCH;
    std::move(clips->begin(), clips->end(), own.clips.begin() + first_clip);
    return SINEW_OK;
  });
}

sinew_error sinew_clip_bounds(const sinew_scene* scene, const sinew_needs* needs, std::uint32_t clip, sinew_box* boxes,
                              std::size_t capacity, std::size_t* count) {
  return c::call(c::given(scene, count, c::Array{boxes, capacity}), [&] {
    const Scene& own = scene->scene;
    if (clip != SINEW_NONE && clip >= own.clips.size()) return SINEW_INDEX_OUT_OF_RANGE;
    if (capacity < own.instances.size()) return SINEW_SIZE_MISMATCH;
    Needs wanted;
    if (const sinew_error error = c::read_needs(needs, own, wanted)) return error;
    const bool has_boxes = clip < scene->clip_boxes.size();
    const std::vector<Aabb> found = clip_bounds(
        own, wanted, clip, has_boxes ? std::span<const Aabb>(scene->clip_boxes[clip]) : std::span<const Aabb>());
    for (std::size_t i = 0; i < found.size(); ++i) boxes[i] = c::to_c(found[i]);
    *count = found.size();
    return SINEW_OK;
  });
}
