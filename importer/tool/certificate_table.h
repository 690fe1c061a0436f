// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <string>

#include "runtime/clip/clip.h"

namespace sinew::tool {

/// A table of what the certificates of clips say, one row per clip: budget asked for, error measured and where, keys
/// kept, bytes, bytes per joint and second. Nothing in it depends on the machine, so that texts of two runs can be
/// compared; `sinew cost` measures times. Clips without a certificate are left out; an infinite budget stands for none.
/// in    joint_names   of the skeleton; may be empty, then joints are shown as numbers
std::string certificate_table(std::span<const Clip> clips, std::span<const std::string> joint_names);

}  // namespace sinew::tool
