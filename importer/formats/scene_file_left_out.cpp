// SPDX-License-Identifier: MIT
// For builds without assimp.
#include "importer/formats/scene_file.h"

namespace sinew::formats {

std::optional<ImportIssue> add_scene_file(std::span<const std::byte>, bool is_fbx, const std::filesystem::path&,
                                          const FormatOptions&, ModelDraft&, ImportedFormat&) {
  return ImportIssue{
      Severity::error, "no-assimp", "",
      std::string(is_fbx ? "FBX" : "COLLADA") +
          " is read by assimp, and this build of sinew was made without it; build with libassimp-dev, or "
          "convert the file in Blender"};
}

}  // namespace sinew::formats
