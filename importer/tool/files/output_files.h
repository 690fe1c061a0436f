// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "importer/rewrite_gltf.h"
#include "importer/tool/exit_code.h"

namespace sinew::tool {

/// The files that a model is written to again: OUT.glb, or OUT.gltf with OUT.bin beside it.
struct OutputFiles {
  std::filesystem::path file;
  std::filesystem::path buffer;  ///< empty for a .glb

  std::vector<std::filesystem::path> all() const;
};

/// The files that OUT stands for.
/// out   nothing when its name ends neither in .glb nor in .gltf
std::optional<OutputFiles> output_files(const std::string& out);

/// Writes all files completely or none of them, and says why where it cannot.
ExitCode write_files(const OutputFiles& outputs, const RewrittenFile& model);

/// Names what the output cannot hold, one line each, and how to go on without it.
ExitCode refuse_rewrite(const std::string& in, const ImportError& error);

}  // namespace sinew::tool
