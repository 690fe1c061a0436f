// SPDX-License-Identifier: MIT
#include "importer/platform/files.h"
#include "importer/tool/commands.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <fmt/core.h>

#include "importer/tool/bake/decoded_take.h"
#include "importer/tool/clip_choice.h"
#include "importer/tool/cost/make_report.h"
#include "importer/tool/cost/occlusion_group.h"
#include "importer/tool/cost/overview/make_overview.h"
#include "importer/tool/cost/shading_groups.h"
#include "importer/tool/cost/subject.h"
#include "importer/tool/cost/write_report.h"
#include "importer/tool/load_file.h"
#include "importer/tool/messages.h"
#include "importer/tool/model_size.h"
#include "importer/tool/progress_line.h"
#include "samples/showcase/showcase.h"

namespace sinew::tool {
namespace {

struct CostOptions {
  std::string file, folder;
  std::optional<std::string> clip;
  bool quick = false;
};

std::string command_of(const CostOptions& options) {
  return fmt::format("sinew cost{}{}{}{} -o {}", options.file.empty() ? "" : " ", options.file,
                     options.clip ? " --clip " + *options.clip : "", options.quick ? " --quick" : "", options.folder);
}

std::string description_of(const std::string& file, const Scene& scene) {
  return fmt::format("{}: {}, {}, {}, {:.3g} m large", platform::text_of(platform::path_of(file).filename()),
                     counted(scene.skeleton.joint_count(), "joint"), counted(scene.clips.size(), "clip"),
                     counted(scene.skins.size(), "skin"), model_size_m(scene));
}

constexpr double kDoneBefore = 0.7;  // fraction of the progress line that ends before the study of ambient occlusion
constexpr double kDoneBeforeFilters = 0.85, kDoneBeforePictures = 0.95;

ExitCode finish(cost::Report report, const std::string& subject, const CostOptions& options) {
  report.subject = subject;
  report.command = command_of(options);
  if (const auto failed = cost::write_report(report, platform::path_of(options.folder))) {
    return fail_with(ExitCode::machine_lacks, fmt::format("{}: {}", options.folder, *failed));
  }
  for (const cost::Group& group : report.groups)
    print_result("{}: {}\n", group.title, group.left_out.empty() ? group.findings.front() : group.left_out);
  print_result("{}\n", platform::text_of(platform::path_of(options.folder) / "report.html"));
  return ExitCode::done;
}

ExitCode report_on(const cost::Scenes& scenes, std::optional<std::uint32_t> clip, const std::string& subject,
                   const CostOptions& options) {
  ProgressLine progress;
  const auto show = [&](const char* work, double done) { progress.show(work, done); };
  const auto show_part = [&](const char* work, double done) { show(work, kDoneBefore * done); };
  cost::Report report =
      cost::make_report(scenes, clip, options.quick ? cost::Effort::quick() : cost::Effort{}, show_part);
  show("ambient occlusion", kDoneBefore);
  const std::uint32_t looked_at = clip ? *clip : cost::busiest_clip(*scenes.moving);
  report.groups.push_back(cost::look_at_occlusion(cost::occlusion_arguments(options.file, looked_at, options.quick)));
  show("filters and normals", kDoneBeforeFilters);
  const bool reads_textures = options.file.empty() || !scenes.moving->textures.empty();
  const cost::NormalAngles angles = cost::normal_angles(*scenes.moving);
  const std::string measured = reads_textures || angles.samples > 0 ? cost::measure_shading(options.quick) : "";
  report.groups.push_back(reads_textures ? cost::filter_group(measured) : cost::no_filters());
  report.groups.push_back(cost::normal_interpolation_group(angles, measured));
  show("pictures", kDoneBeforePictures);
  const auto effort = options.quick ? cost::Effort::quick() : cost::Effort{};
  report.overview = cost::make_overview(report.groups, cost::Subject(*scenes.skinned, looked_at, effort), options.file);
  progress.wipe();
  return finish(std::move(report), subject, options);
}

/// Reports on the positions that a geometry cache decodes, and the costs of other ways to store them.
ExitCode report_on_cache(const CacheFile& file, const CostOptions& options) {
  if (options.clip) return fail_with(ExitCode::wrong_usage, "--clip: names a clip of a glTF file, and FILE is none");
  const auto effort = options.quick ? cost::Effort::quick() : cost::Effort{};
  auto take = decoded_take(file, effort.key_intervals);
  if (!take) return fail_with(ExitCode::input_at_fault, fmt::format("{}: cache-frame: {}", options.file, take.error()));
  ProgressLine progress;
  const auto show = [&](const char* work, double done) { progress.show(work, done); };
  const double asked_m = file.cache.meshes().empty() ? 1e-4 : file.cache.meshes()[0].certificate.asked_m;
  cost::Report report = cost::make_geometry_report(std::move(*take), asked_m, effort, show);
  progress.wipe();
  const std::string subject =
      fmt::format("{}: {} of {}", platform::text_of(platform::path_of(options.file).filename()),
                  counted(file.cache.frame_count(), "frame"), counted(file.cache.meshes().size(), "primitive"));
  return finish(std::move(report), subject, options);
}

ExitCode report_on_showcase(const CostOptions& options) {
  if (options.clip) return fail_with(ExitCode::wrong_usage, "--clip: names a clip of FILE, and there is no FILE");
  const auto arms = showcase::twisted_arms(), face = showcase::morphed_face();
  return report_on({&arms.scene, &arms.scene, &face.scene}, std::nullopt,
                   "the built-in showcase: twisted arms and a morphed face", options);
}

/// Refuses a folder that cannot become the report, with a message.
std::optional<ExitCode> refuse_folder(const CostOptions& options, std::span<const std::filesystem::path> inputs) {
  const std::string why = cost::find_folder_error(platform::path_of(options.folder), inputs);
  if (why.empty()) return std::nullopt;
  return fail_with(ExitCode::wrong_usage, fmt::format("{}: {}", options.folder, why));
}

ExitCode report_cost(const CostOptions& options) {
  const std::filesystem::path named[] = {platform::path_of(options.file)};
  if (const auto refused = refuse_folder(options, named)) return *refused;
  if (options.file.empty()) return report_on_showcase(options);
  if (const auto cache = read_cache(options.file, true))
    return *cache ? report_on_cache(**cache, options) : cache->error();
  ImportOptions import;
  import.decode_images = false;
  const auto file = load_file(options.file, import);
  if (!file) return ExitCode::input_at_fault;
  if (const auto refused = refuse_folder(options, file->facts.files)) return *refused;
  std::optional<std::uint32_t> clip;
  if (options.clip) {
    const auto chosen = choose_clips(file->scene, options.clip);
    if (!chosen) return fail_with(ExitCode::wrong_usage, chosen.error());
    clip = chosen->front();
  }
  return report_on({&file->scene, &file->scene, &file->scene}, clip, description_of(options.file, file->scene),
                   options);
}

}  // namespace

Command cost_command() {
  auto options = std::make_shared<CostOptions>();
  Command command(
      "cost",
      "Measure what accuracy costs in time, on a file of yours, as a page with charts\n"
      "Ways to interpolate, to store keys, to skin, to morph, to calculate, to retarget, to keep every "
      "vertex of every frame, to reach targets, to step springs, and to compute ambient occlusion. Each has its error "
      "against double precision "
      "(or rays) and its time on this machine. DIR gets report.html (open it in a browser), report.json and "
      "report.csv, and appears complete or not at all.");
  command.argument("FILE", &options->file,
                   "A .gltf or .glb file, or a geometry cache; without it the built-in showcase");
  command.option("-o,--output", "DIR", &options->folder, "The folder to write").required();
  command.option("--clip", "INDEX|NAME|none", &options->clip,
                 "The clip to look at (default: the clip that moves most joints)");
  command.flag("--quick", options->quick, "A first impression within seconds, with more noise");
  command.run = [options] { return report_cost(*options); };
  return command;
}

}  // namespace sinew::tool
