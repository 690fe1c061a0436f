// SPDX-License-Identifier: MIT
#include "importer/tool/bake/take_source.h"

#include <algorithm>
#include <filesystem>
#include <glm/common.hpp>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "importer/platform/files.h"
#include "importer/tool/bake/bake_points.h"
#include "importer/tool/bake/bake_scene.h"
#include "importer/tool/clip_choice.h"
#include "importer/tool/files/output.h"
#include "importer/tool/load_file.h"
#include "importer/tool/messages.h"
#include "importer/tool/model_size.h"

namespace sinew::tool {
namespace {

using TakeOrExit = tl::expected<GeometryTake, ExitCode>;

bool is_obj(const std::string& file) {
  std::string extension = platform::text_of(platform::path_of(file).extension());
  for (char& c : extension) c = static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
  return extension == ".obj";
}

tl::unexpected<ExitCode> wrong_usage(const std::string& text) {
  return tl::unexpected(fail_with(ExitCode::wrong_usage, text));
}

/// The longest side of the box around a mesh in its first frame.
double size_of(const TakeMesh& mesh) {
  glm::vec3 lower(std::numeric_limits<float>::infinity()), upper = -lower;
  for (const glm::vec3& position : mesh.streams[0].frames[0]) {
    lower = glm::min(lower, position);
    upper = glm::max(upper, position);
  }
  const glm::dvec3 sides = glm::dvec3(upper) - glm::dvec3(lower);
  return std::max({sides.x, sides.y, sides.z, 0.0});
}

TakeOrExit finished_take(ImportResult<BakedPoints> baked, const Length& budget) {
  if (!baked) return tl::unexpected(fail_with(ExitCode::input_at_fault, baked.error().file, baked.error().issue));
  if (!baked->found.empty()) print_result("{}\n", baked->found);
  for (TakeMesh& mesh : baked->take.meshes)
    mesh.streams[0].budget = budget.of_model > 0.0 ? budget.of_model * size_of(mesh) : budget.metres;
  return std::move(baked->take);
}

std::optional<std::string> output_error(const TakeSource& source, std::span<const std::filesystem::path> inputs) {
  return source.output.empty() ? std::nullopt : find_output_error(platform::path_of(source.output), inputs);
}

PointsOptions points_options(const TakeSource& source) {
  std::optional<UpAxis> up;
  if (source.up) up = *source.up == "y" ? UpAxis::y : UpAxis::z;
  return {source.points.value_or(""), up, source.fps};
}

TakeOrExit take_of_obj(const TakeSource& source) {
  if (source.clip) return wrong_usage("--clip: an .obj file has no clips");
  if (source.points) {
    const std::filesystem::path inputs[] = {platform::path_of(source.file), platform::path_of(*source.points)};
    if (const auto error = output_error(source, inputs)) return wrong_usage(*error);
    return finished_take(bake_points(inputs[0], points_options(source)), source.budget);
  }
  const auto files = numbered_obj_files(source.file);
  if (!files) return finished_take(tl::unexpected(files.error()), source.budget);
  if (const auto error = output_error(source, *files)) return wrong_usage(*error);
  return finished_take(bake_numbered_obj(*files, source.fps), source.budget);
}

TakeOrExit take_of_scene(const Scene& scene, const TakeSource& source) {
  const auto clips = choose_clips(scene, source.clip);
  if (!clips) return wrong_usage(clips.error());
  if (!source.clip && clips->size() > 2)  // the rest pose and several clips
    return wrong_usage(list_of_clips(scene) + "; choose one with --clip");
  TakeBudgets budgets = source.budgets;
  budgets.positions_m = metres_of(source.budget, scene);
  auto baked = bake_scene(scene, clips->back(), source.fps, budgets);
  if (!baked)
    return tl::unexpected(fail_with(ExitCode::input_at_fault, fmt::format("{}: {}", source.file, baked.error())));
  for (const std::string& what : baked->left_out) print_error(fmt::format("{}: left out: {}", source.file, what));
  return std::move(baked->take);
}

}  // namespace

SourceOptions add_source_options(Command& command, TakeSource& source) {
  Option& clip =
      command.option("--clip", "INDEX|NAME|none", &source.clip, "The clip of a glTF file; none = the rest pose");
  Option& points = command.option("--points", "CACHE.mdd|.pc2", &source.points, "Positions of the vertices over time");
  command
      .option("--up", "y|z", &source.up,
              "Which axis of the point cache is up; without it, found by comparing its\n"
              "first frame with the mesh at rest")
      .one_of({"y", "z"})
      .needs("--points");
  return {clip, points};
}

tl::expected<GeometryTake, ExitCode> read_take(const TakeSource& source) {
  if ((is_obj(source.file) || source.points) && (source.budgets.normals_rad || source.budgets.colors))
    return wrong_usage("--normals, --colors: point caches and .obj files hold positions over time, and nothing else");
  if (is_obj(source.file)) return take_of_obj(source);
  ImportOptions import;
  import.decode_images = import.make_tangents = false;
  const auto file = load_file(source.file, import);
  if (!file) return tl::unexpected(ExitCode::input_at_fault);
  std::vector<std::filesystem::path> inputs = file->facts.files;
  if (source.points) inputs.emplace_back(*source.points);
  if (const auto error = output_error(source, inputs)) return wrong_usage(*error);
  if (source.points) return finished_take(bake_points(file->scene, points_options(source)), source.budget);
  return take_of_scene(file->scene, source);
}

}  // namespace sinew::tool
