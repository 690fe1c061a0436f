// SPDX-License-Identifier: MIT
#include "importer/tool/commands.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "importer/geometry_cache/encode_geometry_cache.h"
#include "importer/tool/bake/bake_points.h"
#include "importer/tool/bake/bake_scene.h"
#include "importer/tool/bake/geometry_table.h"
#include "importer/tool/clip_choice.h"
#include "importer/tool/length_text.h"
#include "importer/tool/load_file.h"
#include "importer/tool/messages.h"
#include "importer/tool/progress_line.h"
#include "importer/write/replace_file.h"

namespace sinew::tool {
namespace {

struct BakeOptions {
  std::string in, out, budget = "0.1mm";
  std::optional<std::string> clip, points, up;
  double fps = 30.0;
  std::uint32_t segment = 32;
  bool without_triangles = false;
};

bool is_obj(const std::string& file) {
  std::string extension = std::filesystem::path(file).extension().string();
  for (char& c : extension) c = static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
  return extension == ".obj";
}

/// The take, or the exit code after its message was printed.
using TakeOrExit = tl::expected<GeometryTake, ExitCode>;

TakeOrExit told(ImportResult<BakedPoints> baked) {
  if (!baked) return tl::unexpected(fail_with(ExitCode::input_at_fault, baked.error().file, baked.error().issue));
  if (!baked->found.empty()) fmt::print("{}\n", baked->found);
  return std::move(baked->take);
}

TakeOrExit take_of_scene(const Scene& scene, const BakeOptions& options, double budget_m) {
  const auto clips = choose_clips(scene, options.clip);
  if (!clips) return tl::unexpected(fail_with(ExitCode::wrong_usage, clips.error()));
  if (!options.clip && clips->size() > 2)  // the rest pose and several clips
    return tl::unexpected(fail_with(ExitCode::wrong_usage, list_of_clips(scene) + "; choose one with --clip"));
  auto baked = bake_scene(scene, clips->back(), options.fps, budget_m);
  if (!baked)
    return tl::unexpected(fail_with(ExitCode::input_at_fault, fmt::format("{}: {}", options.in, baked.error())));
  for (const std::string& what : baked->left_out) say_error(fmt::format("{}: left out: {}", options.in, what));
  return std::move(baked->take);
}

TakeOrExit take_of(const BakeOptions& options, double budget_m) {
  if (is_obj(options.in) && !options.points) return told(bake_numbered_obj(options.in, options.fps, budget_m));
  std::optional<UpAxis> up;
  if (options.up) up = *options.up == "y" ? UpAxis::y : UpAxis::z;
  const PointsOptions points{options.points.value_or(""), up, options.fps, budget_m};
  if (is_obj(options.in)) return told(bake_points(std::filesystem::path(options.in), points));
  ImportOptions import;
  import.decode_images = import.make_tangents = false;
  const auto file = load_file(options.in, import);
  if (!file) return tl::unexpected(ExitCode::input_at_fault);
  if (options.points) return told(bake_points(file->scene, points));
  return take_of_scene(file->scene, options, budget_m);
}

ExitCode bake_file(const BakeOptions& options) {
  const auto budget_m = parse_length(options.budget);
  if (!budget_m) return fail_with(ExitCode::wrong_usage, "--budget: " + budget_m.error());
  std::error_code error;
  for (const std::string& read : {options.in, options.points.value_or(options.in)})
    if (std::filesystem::equivalent(read, options.out, error))
      return fail_with(ExitCode::wrong_usage,
                       fmt::format("{}: OUT is a file that is read; it is left as it is", options.out));
  const auto take = take_of(options, *budget_m);
  if (!take) return take.error();
  const auto bytes =
      encode_geometry_cache(*take, {.segment_frames = options.segment, .keep_triangles = !options.without_triangles});
  if (!bytes) return fail_with(ExitCode::input_at_fault, options.in, bytes.error().issue);
  if (const auto fault = write::replace_file(options.out, *bytes))
    return fail_with(ExitCode::machine_lacks, options.out, {Severity::error, "write-file", "", *fault});
  const auto cache = GeometryCache::open(*bytes);
  fmt::print("{}{}\n", geometry_table(*cache), options.out);
  return ExitCode::done;
}

}  // namespace

void add_bake(CLI::App& program, ExitCode& outcome) {
  auto options = std::make_shared<BakeOptions>();
  CLI::App* command = program.add_subcommand("bake",
                                             "Bake the vertices of every frame into a geometry cache (.sgeo), within a "
                                             "budget: the scene of a glTF file while\n"
                                             "a clip plays, a mesh (glTF or OBJ) that a point cache moves, or OBJ "
                                             "files whose names count up. Prints what was\n"
                                             "measured at every vertex of every frame, and half way between frames "
                                             "where the source is known there; OUT stores\n"
                                             "that as well. sinew::geometry_cache (runtime/geometry_cache/) plays it.");
  command->add_option("FILE", options->in, "A .gltf, .glb or .obj file; the first of numbered .obj files")->required();
  command->add_option("-o,--output", options->out, "The file to write")->required()->type_name("OUT.sgeo");
  command->add_option("--clip", options->clip, "The clip to bake; none = the rest pose")->type_name("INDEX|NAME|none");
  auto* points = command->add_option("--points", options->points, "Positions of the vertices of FILE over time")
                     ->type_name("CACHE.mdd|.pc2");
  command
      ->add_option("--up", options->up,
                   "Which axis of the point cache is up; without it, found by comparing its\n"
                   "first frame with the mesh at rest")
      ->type_name("y|z")
      ->check(CLI::IsMember({"y", "z"}))
      ->needs(points);
  command->add_option("--fps", options->fps, "Frames per second; .mdd files have their own")
      ->type_name("N")
      ->check(CLI::Range(1e-3, 1e6))
      ->capture_default_str();
  command->add_option("--budget", options->budget, "Largest error: 0.1mm, 1e-4")->capture_default_str();
  command->add_option("--segment", options->segment, "Frames from one key frame to the next: most that a seek decodes")
      ->type_name("N")
      ->check(CLI::Range(1, 10000))
      ->capture_default_str();
  command->add_flag("--without-triangles", options->without_triangles,
                    "Leave out the faces, for a mesh kept elsewhere");
  command->callback([options, &outcome] { outcome = bake_file(*options); });
}

}  // namespace sinew::tool
