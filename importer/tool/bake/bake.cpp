// SPDX-License-Identifier: MIT
#include <charconv>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/core.h>

#include "importer/geometry_cache/encode_geometry_cache.h"
#include "importer/platform/files.h"
#include "importer/tool/bake/geometry_table.h"
#include "importer/tool/bake/take_source.h"
#include "importer/tool/commands.h"
#include "importer/tool/files/output.h"
#include "importer/tool/length_text.h"
#include "importer/tool/messages.h"

namespace sinew::tool {
namespace {

struct BakeOptions {
  TakeSource source;
  std::string out, budget = "0.1mm";
  std::optional<std::string> normals, colors;
  std::uint32_t segment = 32;
  bool without_triangles = false;
};

/// Reads "0.5deg" or "0.5" as degrees, or a plain number. Empty if the text is neither, or if the number is not above
/// 0.
std::optional<double> parse_budget(std::string_view text, std::string_view unit) {
  if (!unit.empty() && text.ends_with(unit)) text.remove_suffix(unit.size());
  double number = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(number) || number <= 0.0)
    return std::nullopt;
  return number;
}

/// The budgets of normals and colours; a sentence for the user if one is invalid.
tl::expected<TakeBudgets, std::string> budgets_of(const BakeOptions& options) {
  TakeBudgets out;
  if (options.normals) {
    const auto degrees = parse_budget(*options.normals, "deg");
    if (!degrees || *degrees > 45.0)
      return tl::unexpected(fmt::format("--normals: \"{}\" is no angle up to 45deg, such as 0.5deg", *options.normals));
    out.normals_rad = *degrees * std::numbers::pi / 180.0;
  }
  if (options.colors) {
    out.colors = parse_budget(*options.colors, "");
    if (!out.colors)
      return tl::unexpected(fmt::format("--colors: \"{}\" is no difference above 0, such as 0.004", *options.colors));
  }
  return out;
}

ExitCode bake_file(BakeOptions& options) {
  const ResultsToStderr redirected(is_standard_output(platform::path_of(options.out)));
  const auto budget = parse_length(options.budget);
  if (!budget) return fail_with(ExitCode::wrong_usage, "--budget: " + budget.error());
  options.source.budget = *budget;
  const auto budgets = budgets_of(options);
  if (!budgets) return fail_with(ExitCode::wrong_usage, budgets.error());
  options.source.budgets = *budgets;
  options.source.output = options.out;
  const auto take = read_take(options.source);
  if (!take) return take.error();
  const auto bytes =
      encode_geometry_cache(*take, {.segment_frames = options.segment, .keep_triangles = !options.without_triangles});
  if (!bytes) return fail_with(ExitCode::input_at_fault, options.source.file, bytes.error().issue);
  if (const ExitCode code = write_output(platform::path_of(options.out), *bytes); code != ExitCode::done) return code;
  const auto cache = GeometryCache::open(*bytes);
  print_result("{}{}\n", geometry_table(*cache), options.out);
  return ExitCode::done;
}

}  // namespace

Command bake_command() {
  auto options = std::make_shared<BakeOptions>();
  Command command(
      "bake",
      "Bake the vertices of every frame into a geometry cache (.sgeo), within an error budget\n"
      "Of the scene of a glTF file while a clip plays, of a mesh (glTF or OBJ) that a point cache moves, or "
      "of OBJ files whose names count up. Prints what was measured at every vertex of every frame, and half "
      "way between frames where the source is known there; OUT stores that as well. sinew::geometry_cache "
      "(runtime/geometry_cache/) plays it.");
  command.argument("FILE", &options->source.file, "A .gltf, .glb or .obj file; the first of numbered .obj files")
      .required();
  command.option("-o,--output", "OUT.sgeo", &options->out, "The file to write").required();
  add_source_options(command, options->source);
  command
      .option("--fps", "N", &options->source.fps,
              fmt::format("Frames per second; .mdd files have their own (default: {})", options->source.fps))
      .within(1e-3, 1e6);
  command.option("--budget", "LENGTH", &options->budget,
                 fmt::format("Largest error, {} (default: {})", kLengthHelp, options->budget));
  command
      .option("--normals", "[1deg]", &options->normals,
              "Bake normals too, within this angle; without, they follow from the triangles")
      .bare("1deg");
  command
      .option("--colors", "[0.004]", &options->colors, "Bake colours too, within this difference of a linear component")
      .bare("0.004");
  command
      .option("--segment", "N", &options->segment,
              fmt::format("Frames from one key frame to the next: most that a seek decodes (default: {})",
                          options->segment))
      .within(1, 10000);
  command.flag("--without-triangles", options->without_triangles, "Leave out the faces, for a mesh kept elsewhere");
  command.run = [options] { return bake_file(*options); };
  return command;
}

}  // namespace sinew::tool
