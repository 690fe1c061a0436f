// SPDX-License-Identifier: MIT
#include "tests/c/engine_pages.h"

#include "runtime/c_assets/sinew_assets.h"

typedef struct player {
  sinew_scene* scene;
  sinew_page_tables* tables;
  sinew_plan* plan;
  sinew_frame* frame;
  sinew_paged_clip* paged;
  sinew_page* page;
} player;

static sinew_error start(player* p, const unsigned char* file, size_t file_bytes, uint32_t clip) {
  sinew_error error = sinew_assets_read_first_keys(file, file_bytes, &p->scene, &p->tables, NULL);
  if (error == SINEW_OK) error = sinew_plan_create(p->scene, NULL, &p->plan);
  if (error == SINEW_OK) error = sinew_frame_create(p->plan, NULL, &p->frame);
  if (error == SINEW_OK) error = sinew_page_create(&p->page);
  if (error != SINEW_OK) return error;
  double page_s = 0.0;
  const size_t count = sinew_page_tables_count(p->tables, clip, &page_s);
  return sinew_paged_clip_create(p->scene, clip, page_s, count, NULL, &p->paged);
}

static sinew_error load_pages(player* p, const unsigned char* file, uint32_t clip) {
  size_t number = 0;
  while (sinew_paged_clip_next_page(p->paged, &number)) {
    uint64_t offset = 0;
    const size_t size = sinew_page_tables_place(p->tables, clip, number, &offset);
    int taken = 0;
    const sinew_error error = sinew_assets_load_page(p->paged, number, file + offset, size, &taken, NULL);
    if (error != SINEW_OK || !taken) return error == SINEW_OK ? SINEW_BUSY : error;
  }
  return SINEW_OK;
}

static sinew_error show(player* p, uint32_t clip, double time_s, size_t* missing, engine_numbers* out) {
  const sinew_error error = sinew_paged_clip_at(p->paged, time_s, 0, p->page);
  if (error != SINEW_OK) return error;
  *missing += (size_t)sinew_page_is_missing(p->page);
  const sinew_layer layer = {sinew_page_time_s(p->page), clip, SINEW_NONE, 1.0f, SINEW_LAYER_BLEND};
  const sinew_page* const pages[] = {p->page};
  sinew_frame_input input = sinew_default_input();
  input.layers = &layer;
  input.layer_count = 1;
  input.pages = pages;
  const sinew_error ran = sinew_run(p->frame, &input);
  return ran == SINEW_OK ? engine_read(sinew_frame_result(p->frame), 0, out) : ran;
}

sinew_error engine_play_pages(const unsigned char* file, size_t file_bytes, uint32_t clip, double dt_s, int frames,
                              int load, size_t* missing, size_t* most_pages, engine_numbers* out) {
  player p = {NULL, NULL, NULL, NULL, NULL, NULL};
  sinew_error error = start(&p, file, file_bytes, clip);
  *missing = *most_pages = 0;
  for (int i = 0; i < frames && error == SINEW_OK; ++i) {
    error = sinew_paged_clip_at(p.paged, i * dt_s, 0, p.page);
    if (load && error == SINEW_OK) error = load_pages(&p, file, clip);
    const size_t pages = sinew_paged_clip_loaded_pages(p.paged);
    if (pages > *most_pages) *most_pages = pages;
    if (error == SINEW_OK) error = show(&p, clip, i * dt_s, missing, out);
  }
  sinew_paged_clip_destroy(p.paged);
  sinew_page_destroy(p.page);
  sinew_frame_destroy(p.frame);
  sinew_plan_destroy(p.plan);
  sinew_page_tables_destroy(p.tables);
  sinew_scene_destroy(p.scene);
  return error;
}
