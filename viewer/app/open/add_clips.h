// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <string>

#include "viewer/app/loaded_scene.h"

namespace sinew::viewer {

/// Adds the clips of another file behind those of a character. A file of the same skeleton and rest pose is taken as it
/// is. Any other one is retargeted: joints by names or humanoid bones, morph targets and properties by names.
/// in   clips  not `character`
///      log_line  receives one line for all joints, morph targets and properties that a clip moves and that the
///                character lacks
/// io   character  unchanged, with one log line, if no joint and no morph target of the clips has a counterpart in it
/// cost O(keys), allocates; all clips are compiled again
void add_clips(const LoadedScene& clips, LoadedScene& character,
               const std::function<void(const std::string&)>& log_line);

/// True if a scene has clips and nothing to draw, so that its clips are meant for a character.
bool is_clip_file(const Scene& scene) noexcept;

}  // namespace sinew::viewer
