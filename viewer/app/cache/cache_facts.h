// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace sinew::viewer {

/// State and statistics of a playing geometry cache, for the panel and the live plan.
struct CacheFacts {
  std::string_view name;
  std::uint32_t frame_count = 0;
  double frame_s = 0.0;
  std::size_t vertex_count = 0;         ///< vertices of one frame
  double bytes_per_s = 0.0;             ///< current read rate from the file
  std::uint32_t frames_loaded = 0;      ///< loaded frames in the window
  std::uint32_t window_frames = 0;      ///< capacity of the window
  std::size_t window_bytes = 0;         ///< memory of the window
  std::optional<double> ns_per_vertex;  ///< stage time per vertex and decoded frame; unset = nothing decoded yet
  std::uint64_t late = 0;               ///< number of pictures that showed an older frame than requested
  std::string_view fault = {};          ///< why it cannot be shown; empty = it can
};

/// For example "18 kB a second read, window 40 of 40 frames in 241 kB".
std::string describe_window(const CacheFacts& facts);

/// For example "3.1 ns a decoded vertex, pictures late: 0".
std::string describe_cost(const CacheFacts& facts);

}  // namespace sinew::viewer
