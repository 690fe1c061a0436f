// SPDX-License-Identifier: MIT
#include "runtime/c/pages.h"

#include <cmath>
#include <memory>

#include "runtime/c/boundary.h"
#include "runtime/c/handles.h"
#include "runtime/c/page_handle.h"

using namespace sinew;

struct sinew_paged_clip {
  PagedClip clip;
};

sinew_page_window sinew_default_page_window(void) {
  const PagedClip::Options defaults;
  return {.struct_size = sizeof(sinew_page_window), .pages = defaults.window, .loops = defaults.loops, .plan = nullptr};
}

sinew_error sinew_paged_clip_create(const sinew_scene* scene, std::uint32_t clip, double page_s, std::size_t page_count,
                                    const sinew_page_window* window, sinew_paged_clip** out) {
  if (scene == nullptr || out == nullptr) return SINEW_NULL_ARGUMENT;
  sinew_page_window own = sinew_default_page_window();
  if (const sinew_error error = c::read_struct(window, own); error != SINEW_OK) return error;
  if (clip >= scene->scene.clips.size()) return SINEW_INDEX_OUT_OF_RANGE;
  if (!std::isfinite(page_s) || page_s <= 0.0 || page_count == 0 || own.pages < 2) return SINEW_UNSUPPORTED;
  if (own.plan != nullptr && own.plan->scene != scene) return SINEW_SIZE_MISMATCH;
  return c::guarded([&] {
    PagedClip::Options options{own.pages, own.loops != 0};
    if (own.plan != nullptr) options.kept_joints = kept_joints(own.plan->plan);
    *out = new sinew_paged_clip{{scene->scene.clips[clip], page_s, page_count, options}};
    return SINEW_OK;
  });
}

void sinew_paged_clip_destroy(sinew_paged_clip* paged) { delete paged; }

sinew_error sinew_page_create(sinew_page** out) {
  if (out == nullptr) return SINEW_NULL_ARGUMENT;
  return c::guarded([&] {
    *out = new sinew_page;
    return SINEW_OK;
  });
}

void sinew_page_destroy(sinew_page* page) { delete page; }

double sinew_page_time_s(const sinew_page* page) { return page != nullptr ? page->sample.time_s : 0.0; }

int sinew_page_is_missing(const sinew_page* page) { return page == nullptr || page->sample.is_missing ? 1 : 0; }

sinew_error sinew_paged_clip_at(sinew_paged_clip* paged, double time_s, std::uint32_t backwards, sinew_page* page) {
  if (paged == nullptr || page == nullptr) return SINEW_NULL_ARGUMENT;
  if (!std::isfinite(time_s)) return SINEW_NOT_FINITE;
  page->sample = paged->clip.at(time_s, backwards != 0);
  return SINEW_OK;
}

int sinew_paged_clip_next_page(const sinew_paged_clip* paged, std::size_t* page) {
  if (paged == nullptr || page == nullptr) return 0;
  const auto next = paged->clip.next_page();
  if (next) *page = *next;
  return next ? 1 : 0;
}

sinew_error sinew_paged_clip_load_page(sinew_paged_clip* paged, std::size_t page, const void* bytes,
                                       std::size_t byte_count, int* taken, sinew_messages** messages) {
  if (paged == nullptr || bytes == nullptr) return SINEW_NULL_ARGUMENT;
  if (page >= paged->clip.page_count()) return SINEW_INDEX_OUT_OF_RANGE;
  return c::guarded([&] {
    const auto loaded = paged->clip.load_page(page, {static_cast<const std::byte*>(bytes), byte_count});
    if (!loaded) {
      if (messages != nullptr) {
        auto made = std::make_unique<sinew_messages>();
        made->lines.push_back(loaded.error().rule + ": " + loaded.error().detail);
        *messages = made.release();
      }
      return SINEW_BAD_FILE;
    }
    if (taken != nullptr) *taken = *loaded ? 1 : 0;
    return SINEW_OK;
  });
}

std::size_t sinew_paged_clip_loaded_pages(const sinew_paged_clip* paged) {
  return paged != nullptr ? paged->clip.loaded_pages() : 0;
}
std::size_t sinew_paged_clip_loaded_bytes(const sinew_paged_clip* paged) {
  return paged != nullptr ? paged->clip.loaded_bytes() : 0;
}
