// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "importer/formats/bvh.h"
#include "importer/formats/model_draft.h"

namespace sinew::formats {

/// Meaning of the numbers of a BVH file that the format leaves open.
struct BvhMeaning {
  double metres_per_unit = 0.01;
  bool z_up = false;
  bool keep_end_sites = true;
  /// Position channels are added to OFFSET; otherwise they take its place, component by component.
  bool positions_add_to_offset = false;
};

/// Makes a node of each joint and, of frames, one animation with a key for each frame of each joint with channels.
/// eq    local = T(offset or positions) * R(first rotation channel) * ... * R(last); frame i is at i * frame_time_s.
///       At rest all channels are at OFFSET and 0 degrees. A file with z up gets a root that turns z to y.
/// cost  O(values)
void add_bvh(const Bvh& bvh, const BvhMeaning& meaning, const std::string& clip_name, ModelDraft& draft);

}  // namespace sinew::formats
