// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <string>

#include "runtime/base/index.h"

namespace sinew {

/// Assigns a joint to a bone of the human body, by the bone's name in VRM 1.0 ("hips", "leftThumbProximal").
struct NamedBone {
  std::string name;
  std::uint32_t joint = kNone;
};

}  // namespace sinew
