// SPDX-License-Identifier: MIT
#pragma once
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "viewer/app/options.h"

namespace sinew::viewer {

/// One evaluation of a moment, for a picture beside others.
struct CompareView {
  enum class Kind : std::uint8_t {
    skinning,  ///< the clips of the file, skinned by `skinning`
    compiled,  ///< the clips compiled within `budget_m`
    file,      ///< another file of the command line
  };
  Kind kind = Kind::skinning;
  Skinning skinning = Skinning::linear;
  double budget_m = 0.0;
  std::size_t file = 0;  ///< index of the loaded scene
  std::string label;
};

inline constexpr std::size_t kFewestViews = 2, kMostViews = 4;

/// Reads "linear,dual-quaternion,center-of-rotation", "linear,compiled=0.1" (millimetres), or "files". Two to four
/// views; the first is what the others are compared with.
/// in   file_count  characters of the command line, for "files"
/// err  one sentence that quotes the faulty part
tl::expected<std::vector<CompareView>, std::string> parse_views(std::string_view text, std::size_t file_count);

}  // namespace sinew::viewer
