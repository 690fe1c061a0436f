// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace sinew::viewer {

/// A geometry cache as it plays.
struct CacheFacts {
  std::string_view name;
  std::uint32_t frame_count = 0;
  double frame_s = 0.0;
  std::size_t vertex_count = 0;         ///< of one frame
  double bytes_per_s = 0.0;             ///< read from the file
  std::uint32_t frames_loaded = 0;      ///< in the window over the file
  std::uint32_t window_frames = 0;      ///< most that there can be
  std::size_t window_bytes = 0;         ///< memory of the window
  std::optional<double> ns_per_vertex;  ///< of the stage, for each vertex of each decoded frame; none = not yet
  std::uint64_t late = 0;               ///< pictures that showed an older frame than was asked for
  std::string_view fault = {};          ///< why it cannot be shown
};

/// "18 kB a second read, window 40 of 40 frames in 241 kB"
std::string describe_window(const CacheFacts& facts);

/// "3.1 ns a decoded vertex, pictures late: 0"
std::string describe_cost(const CacheFacts& facts);

}  // namespace sinew::viewer
