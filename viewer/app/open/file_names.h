// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

namespace sinew::viewer {

/// The last part of a name from its last dot on, in lower case: ".glb". Empty if it has none.
std::string ending_of(const std::string& file);

/// True if the name ends in .hdr or .exr: a panorama, which is light and not a scene.
bool names_panorama(const std::string& file);

/// Replaces each folder by its files with the endings of models, clips, caches and panoramas, sorted by name. Folders
/// in it are left out. Other paths stay as they are.
std::vector<std::string> expand_folders(const std::vector<std::string>& paths);

}  // namespace sinew::viewer
