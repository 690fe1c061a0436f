// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "runtime/animation/skeleton.h"

namespace sinew::tool {

/// Joints {source, target} that a person's file pairs: {"joints": {"TARGET NAME": "SOURCE NAME", ...}}.
/// err   a sentence: the file cannot be read, or names a joint that is not there
tl::expected<std::vector<std::array<std::uint32_t, 2>>, std::string> read_joint_pairs(const std::string& file,
                                                                                      const Skeleton& source,
                                                                                      const Skeleton& target);

}  // namespace sinew::tool
