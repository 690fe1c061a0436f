// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <span>
#include <string>

#include "importer/tool/command.h"
#include "importer/tool/exit_code.h"
#include "runtime/model/scene.h"

namespace sinew::tool {

/// Adds `--annotations FILE.json`: events and curves of clips that lie beside the model.
Option& add_annotations_option(Command& command, std::optional<std::string>& file);

/// Gives clips what the file says. Prints what is wrong with it, by place and rule.
/// in   file  empty: nothing is done
ExitCode annotate_from(const std::optional<std::string>& file, std::span<Animation> animations);

}  // namespace sinew::tool
