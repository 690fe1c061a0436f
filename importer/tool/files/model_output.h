// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "importer/rewrite_gltf.h"
#include "importer/tool/command.h"

namespace sinew::tool {

/// The files that a model is written to: OUT.glb, or OUT.gltf with OUT.bin beside it. A stream gets a .glb.
struct ModelOutput {
  std::filesystem::path file;
  std::filesystem::path buffer;  ///< Empty for a .glb.
};

/// The files that OUT stands for.
/// err   a sentence for the user, if OUT is no stream and ends neither in .glb nor in .gltf
tl::expected<ModelOutput, std::string> model_output(const std::string& out);

/// As find_output_error(), for both files.
std::optional<std::string> find_output_error(const ModelOutput& output, std::span<const std::filesystem::path> inputs);

/// Adds --drop, which names the losses that the user permits.
void add_drop_option(Command& command, std::vector<std::string>& drop, const char* about = "What may be lost");

/// Rewrites a model with some changes and writes all its files, or none of them. Prints everything that the new files
/// cannot represent, and errors.
/// in    in       name of the model in messages
///       changes  `drop` and `buffer_uri` are set here
/// out   bytes written
/// err   the exit code
tl::expected<std::size_t, ExitCode> write_model(const ImportedFile& model, const std::string& in,
                                                RewriteOptions changes, const std::vector<std::string>& drop,
                                                const ModelOutput& output);

/// Writes the files of a model that was rewritten for this output, or none of them, and prints what was dropped.
/// out   bytes written
/// err   the exit code
tl::expected<std::size_t, ExitCode> write_rewritten(const RewrittenFile& model, const std::string& in,
                                                    const ModelOutput& output);

/// Prints the errors of a rewrite or of reading its result, and how to go on.
ExitCode print_rewrite_error(const std::string& in, const ImportError& error);

}  // namespace sinew::tool
