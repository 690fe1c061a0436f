// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include <tl/expected.hpp>

#include "runtime/retarget/skeleton_map.h"

namespace sinew::tool {

/// Names of TranslationRule's values, in their order
inline constexpr const char* kTranslationRules[] = {"hips-by-height", "by-length", "keep"};

/// Reads the JSON file with which a user changes a skeleton map:
///     {"joints": {"JOINT OF TARGET": "JOINT OF SOURCE", ...}, "translations": {"JOINT OF TARGET": "keep", ...}}
/// Either member may be absent. `translations` are rules for a joint and all below it.
/// out   options  pairs, chains
/// err   a sentence for the user, if the file cannot be read, names a joint that does not exist, or has another form
tl::expected<void, std::string> read_map_file(const std::string& file, const Skeleton& source, const Skeleton& target,
                                              SkeletonMapOptions& options);

/// The rule of a name of kTranslationRules.
std::optional<TranslationRule> translation_rule(const std::string& name);

}  // namespace sinew::tool
