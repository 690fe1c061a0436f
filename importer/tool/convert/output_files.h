// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "importer/rewrite_gltf.h"

namespace sinew::tool {

/// The files that a converted model is written to: OUT.glb, or OUT.gltf with OUT.bin beside it.
struct OutputFiles {
  std::filesystem::path file;
  std::filesystem::path buffer;  ///< empty for a .glb

  std::vector<std::filesystem::path> all() const;
};

/// The files that OUT stands for.
/// out   nothing when its name ends neither in .glb nor in .gltf
std::optional<OutputFiles> output_files(const std::string& out);

/// Writes all files completely or none of them.
/// out   nothing, or why not
std::optional<std::string> write_files(const OutputFiles& outputs, const RewrittenFile& model);

}  // namespace sinew::tool
