// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <string>

#include "importer/tool/bake/take_source.h"

namespace sinew::tool {

/// Decodes every frame of a geometry cache, which compares their checksums. With a source it also measures each frame
/// against the source, at the rate of the cache.
/// in    brief  print one line instead of everything
/// out   empty if the file is no geometry cache; else the exit code, after the outcome was printed. It is
///       input_at_fault if a frame is damaged, if the source has another shape, or if an error is above its budget
std::optional<ExitCode> verify_geometry(const std::string& file, std::optional<TakeSource> source, bool brief);

}  // namespace sinew::tool
