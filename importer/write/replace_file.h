// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>

namespace sinew::write {

/// Writes a file whole or not at all: into a temporary file of the same folder, then renamed over what was there.
/// Through a symbolic link the file behind it is replaced. out  nothing, or why the file could not be written; an older
/// file of that name is then as it was
std::optional<std::string> replace_file(const std::filesystem::path& file, std::span<const std::byte> bytes);

}  // namespace sinew::write
