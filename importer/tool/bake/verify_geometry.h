// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <string>

#include "importer/tool/bake/take_source.h"

namespace sinew::tool {

/// Decodes every frame of a geometry cache, which compares their checksums. With a source also measures each frame
/// against it anew, at the rate of the cache.
/// in    brief  print one line instead of everything
/// out   nothing when the file is no geometry cache; else the exit code, after the outcome was printed:
///       input_at_fault where a frame is damaged, the source is of another shape, or an error is above what was asked
std::optional<ExitCode> verify_geometry(const std::string& file, std::optional<TakeSource> source, bool brief);

}  // namespace sinew::tool
