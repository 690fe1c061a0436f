// SPDX-License-Identifier: MIT
#pragma once
#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include <tl/expected.hpp>

#include "importer/geometry_cache/geometry_take.h"
#include "importer/tool/exit_code.h"
#include "importer/tool/length_text.h"

namespace sinew::tool {

/// What of a scene is baked, and how far off it may be.
struct TakeBudgets {
  double positions_m = 1e-4;
  std::optional<double> normals_rad;  ///< nothing: no normals
  std::optional<double> colors;       ///< of a linear component
};

/// What the command line says about the source of a geometry cache.
struct TakeSource {
  std::string file;  ///< .gltf, .glb or .obj
  std::optional<std::string> clip, points, up;
  std::string output;  ///< refused where it is a file that is read; empty = nothing is written
  double fps = 30.0;
  Length budget = {1e-4};  ///< of positions; becomes budgets.positions_m when the model is known
  TakeBudgets budgets;
};

/// Adds --clip, --points and --up to a command. The source must outlive its parsing.
void add_source_options(CLI::App& command, TakeSource& source);

/// Reads or samples every frame. Prints what was found out about it, and what is left out.
/// err   the exit code, after its message was printed
tl::expected<GeometryTake, ExitCode> read_take(const TakeSource& source);

}  // namespace sinew::tool
