// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <glm/glm.hpp>
#include <tl/expected.hpp>

#include "importer/import_error.h"
#include "runtime/base/index.h"

namespace sinew::formats {

/// A number of a frame: a position along an axis, or a rotation about it in degrees.
struct BvhChannel {
  bool rotates = false;
  std::uint8_t axis = 0;  ///< 0 = x, 1 = y, 2 = z

  friend bool operator==(const BvhChannel&, const BvhChannel&) = default;
};

struct BvhJoint {
  std::string name;              ///< As in the file, blanks inside included; an end site is "PARENT_end".
  std::uint32_t parent = kNone;  ///< Before its children; kNone for a root.
  bool is_end_site = false;
  glm::dvec3 offset{0.0};
  std::vector<BvhChannel> channels;  ///< In the order of the file.
  std::size_t first_channel = 0;     ///< Into the numbers of a frame.
};

/// A BVH file: a hierarchy of joints, and a number for each of their channels in each frame.
struct Bvh {
  std::vector<BvhJoint> joints;
  std::size_t channel_count = 0;
  std::size_t frame_count = 0;
  double frame_time_s = 0.0;
  std::vector<double> values;         ///< [frame_count * channel_count] frame after frame
  std::vector<ImportIssue> warnings;  ///< json_pointer holds the place, "line 12"
};

/// Reads the text of a BVH file. Keywords may be in any case. Any number of roots, any channels in any order on any
/// joint; a rotation axis may repeat, as in Z X Z. Names may have blanks.
/// out   frames, all of them finite numbers
/// err   one issue, with its line in json_pointer: "bvh-hierarchy", "bvh-channels", "bvh-motion", "bvh-number",
///       "bvh-frames", "bvh-frame-time"
/// cost  O(text); at most 8 bytes for every two of the text, and a joint of some 120 bytes for every 20
tl::expected<Bvh, ImportIssue> read_bvh(std::string_view text);

}  // namespace sinew::formats
