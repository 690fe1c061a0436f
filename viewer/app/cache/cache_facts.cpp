// SPDX-License-Identifier: MIT
#include "viewer/app/cache/cache_facts.h"

#include <cstdio>

namespace sinew::viewer {
namespace {

std::string size_text(double bytes) {
  char text[32];
  std::snprintf(text, sizeof(text), bytes < 1e6 ? "%.0f kB" : "%.1f MB", bytes < 1e6 ? 1e-3 * bytes : 1e-6 * bytes);
  return text;
}

}  // namespace

std::string describe_window(const CacheFacts& facts) {
  return size_text(facts.bytes_per_s) + " a second read, window " + std::to_string(facts.frames_loaded) + " of " +
         std::to_string(facts.window_frames) + " frames in " + size_text(static_cast<double>(facts.window_bytes));
}

std::string describe_cost(const CacheFacts& facts) {
  char cost[32] = "not decoded yet";
  if (facts.ns_per_vertex) std::snprintf(cost, sizeof(cost), "%.1f ns a decoded vertex", *facts.ns_per_vertex);
  return std::string(cost) + ", pictures late: " + std::to_string(facts.late);
}

}  // namespace sinew::viewer
