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

/// Why `out` cannot be written, as far as is known before any work is done.
/// out   `why` is empty when it can
OutputFiles output_files(const std::string& in, const std::string& out, std::string& why);

/// The output that would overwrite a file from which the import read; empty = none.
std::string overwritten_input(const std::string& in, const ImportedFile& model, const OutputFiles& outputs);

/// Writes all files completely or none of them.
/// out   nothing, or why not
std::optional<std::string> write_files(const OutputFiles& outputs, const RewrittenFile& model);

}  // namespace sinew::tool
