// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <string>

#include "runtime/base/index.h"

namespace sinew {

/// A bone of a human body that a joint plays, by its name in VRM 1.0 ("hips", "leftThumbProximal").
struct NamedBone {
  std::string name;
  std::uint32_t joint = kNone;
};

}  // namespace sinew
