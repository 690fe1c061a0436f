// SPDX-License-Identifier: MIT
#include "runtime/c/pages.h"

#include <cmath>

#include "runtime/c/glue/call.h"
#include "runtime/c/glue/fields.h"
#include "runtime/c/glue/write_messages.h"
#include "runtime/c/handles.h"
#include "runtime/c/page_handle.h"

using namespace sinew;

struct sinew_paged_clip {
  PagedClip clip;
};

namespace {

constexpr auto kWindow = c::fields(c::field<&sinew_page_window::pages, &PagedClip::Options::window>(),
                                   c::field<&sinew_page_window::loops, &PagedClip::Options::loops>());

}  // namespace

sinew_page_window sinew_default_page_window(void) {
  return c::written<sinew_page_window>(kWindow, PagedClip::Options{});
}

sinew_error sinew_paged_clip_create(const sinew_scene* scene, std::uint32_t clip, double page_s, std::size_t page_count,
                                    const sinew_page_window* window, sinew_paged_clip** out) {
  return c::call(c::given(scene, out), [&] {
    sinew_page_window known = sinew_default_page_window();
    PagedClip::Options options;
    if (const sinew_error error = c::read_struct(window, known)) return error;
    if (const sinew_error error = kWindow.read(known, options).error) return error;
    if (clip >= scene->scene.clips.size()) return SINEW_INDEX_OUT_OF_RANGE;
    if (const ErrorCode error = PagedClip::check(page_s, page_count, options); error != ErrorCode::ok)
      return c::error_from(error);
    if (known.plan != nullptr && known.plan->scene != scene) return SINEW_SIZE_MISMATCH;
    if (known.plan != nullptr) options.kept_joints = kept_joints(known.plan->plan);
    *out = new sinew_paged_clip{{scene->scene.clips[clip], page_s, page_count, options}};
    return SINEW_OK;
  });
}

void sinew_paged_clip_destroy(sinew_paged_clip* paged) { delete paged; }

sinew_error sinew_page_create(sinew_page** out) {
  return c::call(c::given(out), [&] { *out = new sinew_page; });
}

void sinew_page_destroy(sinew_page* page) { delete page; }

double sinew_page_time_s(const sinew_page* page) { return page != nullptr ? page->sample.time_s : 0.0; }

int sinew_page_is_missing(const sinew_page* page) { return page == nullptr || page->sample.is_missing ? 1 : 0; }

sinew_error sinew_paged_clip_at(sinew_paged_clip* paged, double time_s, std::uint32_t backwards, sinew_page* page) {
  return c::call(c::given(paged, page), [&] {
    if (!std::isfinite(time_s)) return SINEW_NOT_FINITE;
    page->sample = paged->clip.at(time_s, backwards != 0);
    return SINEW_OK;
  });
}

int sinew_paged_clip_next_page(const sinew_paged_clip* paged, std::size_t* page) {
  if (paged == nullptr || page == nullptr) return 0;
  const auto next = paged->clip.next_page();
  if (next) *page = *next;
  return next ? 1 : 0;
}

sinew_error sinew_paged_clip_load_page(sinew_paged_clip* paged, std::size_t page, const void* bytes,
                                       std::size_t byte_count, int* taken, sinew_messages** messages) {
  return c::call(c::given(paged, bytes), [&] {
    if (page >= paged->clip.page_count()) return SINEW_INDEX_OUT_OF_RANGE;
    const auto loaded = paged->clip.load_page(page, {static_cast<const std::byte*>(bytes), byte_count});
    if (!loaded) return c::bad_file(loaded.error().rule + ": " + loaded.error().detail, messages);
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
