// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace sinew::test {

/// The corpus folder: $SINEW_CORPUS, else `../shared` beside the checkout; std::nullopt if neither exists.
std::optional<std::filesystem::path> corpus();

/// All files below a folder with one of the extensions (".gltf", ".glb", ...), sorted; empty if the folder does not
/// exist.
std::vector<std::filesystem::path> files_below(const std::filesystem::path& folder,
                                               const std::vector<std::string>& extensions);

/// All files below `folder` of the corpus.
std::vector<std::filesystem::path> corpus_files(const std::string& folder, const std::vector<std::string>& extensions);

/// Same, for the project's own models, poses and broken files (tests/generated) plus the corpus if there is one. Tests
/// iterate over them and never name a file.
std::vector<std::filesystem::path> files_for_tests(const std::string& folder,
                                                   const std::vector<std::string>& extensions);

}  // namespace sinew::test
