// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace sinew::fuzz {

struct Seed {
  std::string target;  ///< Target::name
  std::vector<std::byte> bytes;
};

/// Small valid inputs for every target, made in code.
std::vector<Seed> own_seeds();

/// The seeds from a glTF file: the file as .glb and as text with data URIs, and each compressed stream. Empty if it
/// cannot be parsed or is too large to be worth mutating.
std::vector<Seed> seeds_of_file(const std::filesystem::path& file);

}  // namespace sinew::fuzz
