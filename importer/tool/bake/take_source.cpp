// SPDX-License-Identifier: MIT
#include "importer/tool/bake/take_source.h"

#include <filesystem>
#include <utility>

#include <fmt/format.h>

#include "importer/tool/bake/bake_points.h"
#include "importer/tool/bake/bake_scene.h"
#include "importer/tool/clip_choice.h"
#include "importer/tool/files/output_check.h"
#include "importer/tool/load_file.h"
#include "importer/tool/messages.h"

namespace sinew::tool {
namespace {

using TakeOrExit = tl::expected<GeometryTake, ExitCode>;

bool is_obj(const std::string& file) {
  std::string extension = std::filesystem::path(file).extension().string();
  for (char& c : extension) c = static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
  return extension == ".obj";
}

tl::unexpected<ExitCode> wrong_usage(const std::string& text) {
  return tl::unexpected(fail_with(ExitCode::wrong_usage, text));
}

TakeOrExit told(ImportResult<BakedPoints> baked) {
  if (!baked) return tl::unexpected(fail_with(ExitCode::input_at_fault, baked.error().file, baked.error().issue));
  if (!baked->found.empty()) fmt::print("{}\n", baked->found);
  return std::move(baked->take);
}

TakeOrExit take_of_scene(const Scene& scene, const TakeSource& source) {
  const auto clips = choose_clips(scene, source.clip);
  if (!clips) return wrong_usage(clips.error());
  if (!source.clip && clips->size() > 2)  // the rest pose and several clips
    return wrong_usage(list_of_clips(scene) + "; choose one with --clip");
  auto baked = bake_scene(scene, clips->back(), source.fps, source.budgets);
  if (!baked)
    return tl::unexpected(fail_with(ExitCode::input_at_fault, fmt::format("{}: {}", source.file, baked.error())));
  for (const std::string& what : baked->left_out) say_error(fmt::format("{}: left out: {}", source.file, what));
  return std::move(baked->take);
}

}  // namespace

void add_source_options(CLI::App& command, TakeSource& source) {
  command.add_option("--clip", source.clip, "The clip to bake; none = the rest pose")->type_name("INDEX|NAME|none");
  auto* points =
      command.add_option("--points", source.points, "Positions of the vertices over time")->type_name("CACHE.mdd|.pc2");
  command
      .add_option("--up", source.up,
                  "Which axis of the point cache is up; without it, found by comparing its\n"
                  "first frame with the mesh at rest")
      ->type_name("y|z")
      ->check(CLI::IsMember({"y", "z"}))
      ->needs(points);
}

tl::expected<GeometryTake, ExitCode> read_take(const TakeSource& source) {
  const double budget_m = source.budgets.positions_m;
  if ((is_obj(source.file) || source.points) && (source.budgets.normals_rad || source.budgets.colors))
    return wrong_usage("--normals, --colors: point caches and .obj files hold positions over time, and nothing else");
  if (is_obj(source.file) && source.clip) return wrong_usage("--clip: an .obj file has no clips");
  if (is_obj(source.file) && !source.points) return told(bake_numbered_obj(source.file, source.fps, budget_m));
  std::optional<UpAxis> up;
  if (source.up) up = *source.up == "y" ? UpAxis::y : UpAxis::z;
  const PointsOptions points{source.points.value_or(""), up, source.fps, budget_m};
  if (is_obj(source.file)) return told(bake_points(std::filesystem::path(source.file), points));
  ImportOptions import;
  import.decode_images = import.make_tangents = false;
  const auto file = load_file(source.file, import);
  if (!file) return tl::unexpected(ExitCode::input_at_fault);
  if (!source.output.empty())
    if (const auto why = objection_to_output(source.output, file->facts.files)) return wrong_usage(*why);
  if (source.points) return told(bake_points(file->scene, points));
  return take_of_scene(file->scene, source);
}

}  // namespace sinew::tool
