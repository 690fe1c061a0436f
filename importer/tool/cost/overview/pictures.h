// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <string>

#include <tl/expected.hpp>

#include "importer/tool/cost/overview/overview.h"

namespace sinew::cost {

/// The file, clip and time that the viewer draws.
struct DrawnMoment {
  std::string file;
  std::uint32_t clip = 0;
  double time_s = 0.0;
};

/// Has the program sinew-viewer beside this one draw the moment, and returns its live plan (drawing_parts).
/// err  a sentence: there is no such program, or it failed, for example without a Vulkan device
tl::expected<std::string, std::string> plan_of_picture(const DrawnMoment& moment);

/// Has the viewer draw the error of a choice on the model, into Choice::picture. Only kinds of skinning and budgets
/// have pictures; other choices do not change.
/// err  as above
tl::expected<void, std::string> add_picture(const DrawnMoment& moment, double size_m, Choice& choice);

}  // namespace sinew::cost
