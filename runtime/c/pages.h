// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/base/api.h"
#include "runtime/c/frame.h"
#include "runtime/c/messages.h"
#include "runtime/c/scene.h"

#ifdef __cplusplus
extern "C" {
#endif

/// A long clip in pages. Only a bounded number of pages around the playing time is in memory:
///
///     sinew_paged_clip_at(paged, time_s, 0, page);                     // each frame, before it runs
///     layer.time_s = sinew_page_time_s(page);
///     input.pages = &page;
///     ...
///     while (sinew_paged_clip_next_page(paged, &number))               // the engine's loader, on any thread
///       sinew_paged_clip_load_page(paged, number, bytes, byte_count, NULL, NULL);
///
/// sinew_assets_read_first_keys (sinew_assets.h) tells where the pages lie in a file, and sinew_assets_load_page takes
/// their bytes from there, packed or not. One thread plays. Any number of threads may load, and pages may come late.
typedef struct sinew_paged_clip sinew_paged_clip;

/// The page that a paged clip plays at a time, with its keys. Created once and reused every frame.
struct sinew_page;

typedef struct sinew_page_window {
  size_t struct_size;
  size_t pages;            ///< most pages in memory, at least 2
  uint32_t loops;          ///< 1 = the page after the last one is the first
  const sinew_plan* plan;  ///< the plan that plays the pages: they have only the joints that its skeleton LOD keeps. It
                           ///< is only read during the call. Null = all joints
} sinew_page_window;
SINEW_API sinew_page_window sinew_default_page_window(void);  ///< 4 pages, looping, all joints

/// Creates a paged clip, at first without loaded pages.
/// in   scene       may be destroyed afterwards; its clip has the first keys
///      page_s, page_count  of sinew_page_table
///      window      null = sinew_default_page_window
/// err  SINEW_NULL_ARGUMENT, SINEW_WRONG_STRUCT_SIZE, SINEW_INDEX_OUT_OF_RANGE (clip), SINEW_UNSUPPORTED (no pages, a
///      page length that is not above 0, a window of fewer than 2), SINEW_SIZE_MISMATCH (a plan of another scene),
///      SINEW_OUT_OF_MEMORY
SINEW_API sinew_error sinew_paged_clip_create(const sinew_scene* scene, uint32_t clip, double page_s, size_t page_count,
                                              const sinew_page_window* window, sinew_paged_clip** out);
SINEW_API void sinew_paged_clip_destroy(sinew_paged_clip* paged);

/// Creates a page, which sinew_paged_clip_at fills.
/// err  SINEW_NULL_ARGUMENT, SINEW_OUT_OF_MEMORY
SINEW_API sinew_error sinew_page_create(sinew_page** out);
SINEW_API void sinew_page_destroy(sinew_page* page);
SINEW_API double sinew_page_time_s(
    const sinew_page* page);  ///< time for the layer: the requested time, or the nearest that is loaded
SINEW_API int sinew_page_is_missing(const sinew_page* page);  ///< 1 = the page of that time is not loaded yet

/// Finds the loaded page that is nearest to a time, and moves the window of pages there.
/// in   backwards  1 = the pages before this one are needed next
/// err  SINEW_NULL_ARGUMENT, SINEW_NOT_FINITE;  cost O(window), takes a lock that loaders also hold for O(window);
///      allocates nothing
SINEW_API sinew_error sinew_paged_clip_at(sinew_paged_clip* paged, double time_s, uint32_t backwards, sinew_page* page);

/// Finds the page that should be loaded next. Returns 0 if every page of the window is loaded, else 1.
/// out  page  the most urgent page that is not loaded
SINEW_API int sinew_paged_clip_next_page(const sinew_paged_clip* paged, size_t* page);

/// Stores the bytes of a page, if the page is still in the window.
/// out  taken     1 = the page was stored; may be null
///      messages  owned by the caller, why the bytes were refused; may be null. Given for SINEW_BAD_FILE only
/// err  SINEW_NULL_ARGUMENT, SINEW_INDEX_OUT_OF_RANGE (page), SINEW_BAD_FILE (damaged, another page, another clip),
///      SINEW_OUT_OF_MEMORY;  cost O(bytes), allocates the page
SINEW_API sinew_error sinew_paged_clip_load_page(sinew_paged_clip* paged, size_t page, const void* bytes,
                                                 size_t byte_count, int* taken, sinew_messages** messages);
SINEW_API size_t sinew_paged_clip_loaded_pages(const sinew_paged_clip* paged);
SINEW_API size_t sinew_paged_clip_loaded_bytes(const sinew_paged_clip* paged);

#ifdef __cplusplus
}
#endif
