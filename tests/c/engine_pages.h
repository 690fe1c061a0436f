// SPDX-License-Identifier: MIT
#pragma once
#include "tests/c/engine.h"

#ifdef __cplusplus
extern "C" {
#endif

/// Plays a clip of an asset file in pages and reads the result of each frame. Pages are loaded from the bytes when they
/// are needed.
/// in   load     1 = pages are loaded before each frame, 0 = never
/// out  missing  frames whose page was not loaded;   most_pages  most pages in memory at once
sinew_error engine_play_pages(const unsigned char* file, size_t file_bytes, uint32_t clip, double dt_s, int frames,
                              int load, size_t* missing, size_t* most_pages, engine_numbers* out);

#ifdef __cplusplus
}
#endif
