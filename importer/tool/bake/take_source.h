// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <string>

#include <tl/expected.hpp>

#include "importer/geometry_cache/geometry_take.h"
#include "importer/tool/command.h"
#include "importer/tool/length_text.h"

namespace sinew::tool {

/// The streams that are baked from a scene, each with its largest allowed error.
struct TakeBudgets {
  double positions_m = 1e-4;
  std::optional<double> normals_rad;  ///< empty = no normals
  std::optional<double> colors;       ///< error of a linear colour component; empty = no colours
};

/// The source of a geometry cache, from the options of `bake` or `verify`.
struct TakeSource {
  std::string file;  ///< .gltf, .glb or .obj
  std::optional<std::string> clip, points, up;
  std::string output;  ///< refused if it is one of the files that are read; empty = nothing is written
  double fps = 30.0;
  Length budget = {1e-4};  ///< budget of positions; becomes budgets.positions_m once the model's size is known
  TakeBudgets budgets;
};

struct SourceOptions {
  Option& clip;
  Option& points;
};

/// Adds --clip, --points and --up to a command. The source must live as long as the command.
SourceOptions add_source_options(Command& command, TakeSource& source);

/// Reads or samples every frame. Prints how the source was read, and what is left out.
/// err   the exit code, after its message was printed
tl::expected<GeometryTake, ExitCode> read_take(const TakeSource& source);

}  // namespace sinew::tool
