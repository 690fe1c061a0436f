// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <string>

#include "runtime/clip/clip.h"

namespace sinew::tool {

/// A table of the certificates of clips, one row per clip: budget, measured error and its place, keys, bytes. Nothing
/// in it depends on the machine, so texts of two runs can be compared. Clips without a certificate are left out. An
/// infinite budget is shown as none.
/// in    joint_names   of the skeleton; may be empty, then joints are shown as numbers
std::string certificate_table(std::span<const Clip> clips, std::span<const std::string> joint_names);

}  // namespace sinew::tool
