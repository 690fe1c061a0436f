// SPDX-License-Identifier: MIT
#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "importer/ambient/ambient_attribute.h"
#include "importer/ambient/bake_key_poses.h"
#include "importer/file/json_pointer.h"
#include "importer/platform/files.h"
#include "importer/tool/clip_choice.h"
#include "importer/tool/commands.h"
#include "importer/tool/files/model_output.h"
#include "importer/tool/files/output.h"
#include "importer/tool/length_text.h"
#include "importer/tool/load_file.h"
#include "importer/tool/messages.h"
#include "importer/tool/model_size.h"
#include "importer/tool/progress_line.h"
#include "runtime/plan/run_plan.h"

namespace sinew::tool {
namespace {

struct BakeAoOptions {
  std::string file, out;
  std::uint32_t rays = VisibilityOptions{}.rays;
  std::uint64_t seed = VisibilityOptions{}.seed;
  std::optional<std::string> distance, pose, clip;
  std::uint32_t key_poses = 1;
  std::vector<std::string> drop;
};

/// Reads "CLIP@TIME", a single pose.
/// err   what is wrong, as a sentence for the user
tl::expected<VertexVisibility, std::string> one_pose(const std::string& text, const Scene& scene) {
  const std::size_t at = text.rfind('@');
  VertexVisibility visibility;
  const char* end = text.data() + text.size();
  double& time_s = visibility.times_s[0];
  const auto [stop, error] = std::from_chars(at == std::string::npos ? end : text.data() + at + 1, end, time_s);
  if (error != std::errc() || stop != end || !std::isfinite(time_s) || time_s < 0.0)
    return tl::unexpected(fmt::format("--pose: \"{}\" is not CLIP@SECONDS, such as Walk@0.5", text));
  const auto clips = choose_clips(scene, text.substr(0, at));
  if (!clips) return tl::unexpected(fmt::format("--pose {}: no such clip; {}", text, list_of_clips(scene)));
  visibility.clip = clips->front();
  return visibility;
}

/// The key poses of a clip: the chosen one, or else the first.
/// err   what is wrong, as a sentence for the user
tl::expected<VertexVisibility, std::string> key_poses(const BakeAoOptions& options, const Scene& scene) {
  const auto clips = choose_clips(scene, options.clip.value_or("0"));
  if (!clips || clips->front() == kNone)
    return tl::unexpected(
        fmt::format("--key-poses: there is no clip \"{}\"; {}", options.clip.value_or("0"), list_of_clips(scene)));
  VertexVisibility visibility;
  visibility.clip = clips->front();
  const Animation& clip = scene.animations[visibility.clip];
  visibility.times_s = key_pose_times(clip.duration_s, options.key_poses);
  if (visibility.times_s.size() == 1)
    return tl::unexpected(fmt::format(
        "--key-poses: clip \"{}\" lasts no time: --pose bakes its one pose, --clip names another", clip.name));
  return visibility;
}

/// The poses in which the model is baked; their values are not computed yet.
/// err   what is wrong, as a sentence for the user
tl::expected<VertexVisibility, std::string> poses_of(const BakeAoOptions& options, const Scene& scene) {
  if (options.key_poses > 1) return key_poses(options, scene);
  return options.pose ? one_pose(*options.pose, scene) : VertexVisibility();
}

/// Reads a length and returns metres; infinite for "none".
/// err   what is wrong, as a sentence for the user
tl::expected<double, std::string> distance_of(const std::string& text, const Scene& scene) {
  if (text == "none") return std::numeric_limits<double>::infinity();
  const auto length = parse_length(text);
  if (!length) return tl::unexpected("--distance: " + length.error());
  const double metres = metres_of(*length, scene);
  if (!(metres > 0.0)) return tl::unexpected(fmt::format("--distance: \"{}\" is not above 0", text));
  return metres;
}

/// Casts the rays of one pose after another. All poses have the same largest distance of occluders: the given one, or
/// one derived from the first pose.
/// err   what is wrong, as a sentence for the user
tl::expected<VertexVisibility, std::string> bake(const BakeAoOptions& options, const Scene& scene) {
  auto visibility = poses_of(options, scene);
  if (!visibility) return visibility;
  std::optional<double> distance_m;
  if (options.distance) {
    const auto distance = distance_of(*options.distance, scene);
    if (!distance) return tl::unexpected(distance.error());
    distance_m = *distance;
  }
  Needs needs;
  needs.out.positions = needs.out.normals = true;
  const Plan plan = compile_plan(lend(scene), needs);
  FrameBuffer frame(plan);
  ProgressLine progress;
  const auto show = [&](double done) { progress.show("casting rays", done); };
  KeyPoseBaker baker(scene, {.rays = options.rays, .seed = options.seed, .progress = show}, distance_m, *visibility);
  for (const double time_s : visibility->times_s) {
    const ClipLayer layer{visibility->clip, time_s};
    FrameInput input;
    if (visibility->clip != kNone) input.layers = {&layer, 1};
    if (run_plan(plan, input, frame) != ErrorCode::ok)
      return tl::unexpected(std::string("the pose cannot be evaluated"));
    baker.add(frame.result());
  }
  return visibility;
}

/// Warns about meshes that a file shows several times, because all copies share one value per vertex.
void warn_of_shared_meshes(const BakeAoOptions& options, const Scene& scene) {
  std::vector<std::size_t> places(scene.meshes.size());
  for (const MeshInstance& instance : scene.instances)
    places[instance.mesh] += std::max<std::size_t>(instance.copies.size(), 1);
  for (std::size_t m = 0; m < places.size(); ++m)
    if (places[m] > 1)
      print_error(fmt::format("{}: {}: warning: is at {}; its vertices get the mean of them", options.file,
                              pointer("meshes", m), counted(places[m], "place")));
}

std::string summary(const VertexVisibility& visibility, const std::vector<AddedAttribute>& attributes) {
  std::size_t values = 0;
  double sum = 0.0, darkest = 1.0;
  for (const AddedAttribute& attribute : attributes)
    for (const float value : attribute.values) {
      ++values;
      sum += static_cast<double>(value);
      darkest = std::min(darkest, static_cast<double>(value));
    }
  const std::size_t poses = visibility.times_s.size();
  return fmt::format("{} vertices of {}{}: mean visibility {:.3f}, darkest {:.3f}\n", values / poses,
                     counted(attributes.size() / poses, "primitive"),
                     poses > 1 ? fmt::format(" in {} key poses", poses) : "", sum / static_cast<double>(values),
                     darkest);
}

ExitCode bake_ao(const BakeAoOptions& options) {
  const ResultsToStderr redirected(is_standard_output(platform::path_of(options.out)));
  const auto output = model_output(options.out);
  if (!output) return fail_with(ExitCode::wrong_usage, output.error());
  ImportOptions import;
  import.decode_images = import.make_tangents = false;
  import.carry_document = true;
  const auto model = load_file(options.file, import);
  if (!model) return ExitCode::input_at_fault;
  if (const auto error = find_output_error(*output, model->facts.files))
    return fail_with(ExitCode::wrong_usage, *error);
  const auto visibility = bake(options, model->scene);
  if (!visibility) return fail_with(ExitCode::wrong_usage, visibility.error());
  const std::vector<AddedAttribute> attributes = ambient_attributes(model->scene, *visibility);
  if (attributes.empty())
    return fail_with(ExitCode::input_at_fault, options.file + ": no node shows triangles, so nothing is baked");
  warn_of_shared_meshes(options, model->scene);
  const std::vector<std::string> older = ambient_attribute_names(*model);
  RewriteOptions changes;
  changes.left_out_attributes = older;
  changes.added_attributes = attributes;
  const auto bytes = write_model(*model, options.file, std::move(changes), options.drop, *output);
  if (!bytes) return bytes.error();
  print_result("{}{}: {} bytes\n", summary(*visibility, attributes), options.out, *bytes);
  return ExitCode::done;
}

}  // namespace

Command bake_ao_command() {
  auto options = std::make_shared<BakeAoOptions>();
  Command command(
      "bake-ao",
      "Bake ambient visibility into the vertices of a file, by casting rays\n"
      "Ambient visibility is the fraction of the light from all around that arrives. Each vertex casts rays over the "
      "hemispheres of its faces; those that meet nothing within the distance count. Every primitive that a node shows "
      "gets the attribute _AMBIENT_ACCESS, a float from 0 to 1 a vertex. A mesh at several places gets the mean of "
      "them. With --key-poses there is one attribute for each pose, _AMBIENT_ACCESS_C_I for pose I of animation C. "
      "`sinew-viewer OUT --ao rays` shows it, blended between key poses while the clip plays.\n"
      "\n"
      "OUT is FILE with this attribute and everything else that the file says; what cannot be carried is listed, and "
      "nothing is written unless --drop names it. The same file and options give the same bytes on the same kind of "
      "machine, for any number of threads.");
  command.argument("FILE", &options->file, "A .gltf or .glb file").required();
  command.option("-o,--output", "OUT", &options->out, "The .glb or .gltf file to write").required();
  command
      .option("--rays", "N", &options->rays,
              fmt::format("Rays for each vertex, shared by its faces (default: {})", options->rays))
      .within(1, 1 << 20);
  command.option("--distance", "LENGTH", &options->distance,
                 fmt::format("What is farther blocks no light, {}; or none: nothing is too far (default: a quarter of "
                             "the longest side of the model)",
                             kLengthHelp));
  command.option("--seed", "N", &options->seed,
                 fmt::format("Another number gives other rays (default: {})", options->seed));
  command.option("--pose", "CLIP@SECONDS", &options->pose,
                 "The pose to bake, such as Walk@0.5 (default: the rest pose)");
  command
      .option("--key-poses", "N", &options->key_poses,
              "Bake this many poses, spread evenly over a clip, its ends included")
      .within(2, kMostKeyPoses)
      .excludes("--pose");
  command.option("--clip", "INDEX|NAME", &options->clip, "The clip of the key poses (default: the first)")
      .needs("--key-poses");
  add_drop_option(command, options->drop);
  command.run = [options] { return bake_ao(*options); };
  return command;
}

}  // namespace sinew::tool
