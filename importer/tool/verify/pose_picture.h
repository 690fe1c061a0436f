// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <string>

#include "importer/tool/verify/verify_report.h"

namespace sinew::tool {

/// Has a viewer draw the worst pose of each file that moved, into VerifiedFile::picture. A picture that cannot be drawn
/// is left out, with a warning.
/// in      viewer  the program sinew-viewer
/// limits  the first 12 files that moved; a picture takes the viewer about a second
void add_pictures(std::span<VerifiedFile> files, const std::string& viewer);

}  // namespace sinew::tool
