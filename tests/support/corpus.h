// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace sinew::test {

/// The corpus folder: $SINEW_CORPUS, else `../shared` beside the checkout; nothing when neither exists.
std::optional<std::filesystem::path> corpus();

/// All files below a folder with one of the extensions (".gltf", ".glb", ...), sorted; none where there is no folder.
std::vector<std::filesystem::path> files_below(const std::filesystem::path& folder,
                                               const std::vector<std::string>& extensions);

/// All files below `folder` of the corpus.
std::vector<std::filesystem::path> corpus_files(const std::string& folder, const std::vector<std::string>& extensions);

/// The same of the project's own models, poses and broken files (tests/generated), and of the corpus where there is
/// one. Tests enumerate them and never name one.
std::vector<std::filesystem::path> files_for_tests(const std::string& folder,
                                                   const std::vector<std::string>& extensions);

}  // namespace sinew::test
