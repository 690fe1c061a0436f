// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <string>

#include "runtime/clip/clip.h"

namespace sinew::tool {

/// What the clips' certificates say, a row each: asked, measured, where, keys kept, bytes, bytes per joint per second,
/// and the time of a sample, as it is and with its keys unpacked, measured now. Clips without certificate are left out.
/// in   joint_names  of the skeleton; may be empty, then joints are numbers
std::string certificate_table(std::span<const Clip> clips, std::span<const std::string> joint_names);

}  // namespace sinew::tool
