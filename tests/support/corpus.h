// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace sinew::test {

/// The corpus folder: $SINEW_CORPUS, else `../shared` beside the checkout; nothing when neither exists. Corpus tests
/// enumerate the files below it and never name one; without it they skip with kNoCorpus.
std::optional<std::filesystem::path> corpus();

inline constexpr const char* kNoCorpus =
    "no corpus: set SINEW_CORPUS to a folder with models/ poses/ numeric/ malformed/";

/// All files below `folder` of the corpus with one of the extensions (".gltf", ".glb", ...), sorted.
std::vector<std::filesystem::path> corpus_files(const std::string& folder, const std::vector<std::string>& extensions);

}  // namespace sinew::test
