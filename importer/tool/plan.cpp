// SPDX-License-Identifier: MIT
#include "importer/tool/commands.h"

#include <algorithm>
#include <map>
#include <memory>
#include <optional>

#include <fmt/core.h>

#include "importer/tool/batch/run_batch.h"
#include "importer/tool/clip_choice.h"
#include "importer/tool/files/cache_folder.h"
#include "importer/tool/graph/program_rows.h"
#include "importer/tool/json.h"
#include "importer/tool/left_out_joints.h"
#include "importer/tool/length_text.h"
#include "importer/tool/load_file.h"
#include "importer/tool/messages.h"
#include "importer/tool/model_size.h"
#include "importer/tool/skinning_choice.h"
#include "importer/visible_text.h"
#include "runtime/model/mirror_scene.h"
#include "runtime/plan/run_plan.h"

namespace sinew::tool {
namespace {

struct PlanOptions {
  BatchOptions files;
  std::optional<std::string> clip;
  std::vector<std::string> needs;
  std::uint32_t layers = Needs{}.in.max_layers;
  std::vector<std::string> skinning = {"linear"};
  std::string normals = "linear";
  std::optional<std::string> joint_tolerance;
  std::string cache;
  std::optional<std::string> program;
  bool times = false;
};

template <bool Outputs::*flag>
bool& out(Needs& needs) {
  return needs.out.*flag;
}

template <bool Inputs::*flag>
bool& in(Needs& needs) {
  return needs.in.*flag;
}

/// The needs that --needs can name, besides kMasks.
const std::map<std::string, bool& (*)(Needs&)> kNeeds = {
    {"joints", out<&Outputs::joints>},           {"weights", out<&Outputs::weights>},
    {"positions", out<&Outputs::positions>},     {"normals", out<&Outputs::normals>},
    {"tangents", out<&Outputs::tangents>},       {"palettes", out<&Outputs::palettes>},
    {"bounds", out<&Outputs::bounds>},           {"properties", out<&Outputs::properties>},
    {"additive", in<&Inputs::additive>},         {"hidden-meshes", out<&Outputs::hidden_meshes>},
    {"stage-times", out<&Outputs::stage_times>}, {"between-updates", in<&Inputs::between_updates>},
    {"local-pose", out<&Outputs::local_pose>}};
constexpr const char* kMasks = "masks";

const std::map<std::string, NormalRule> kNormalRules = {{"linear", NormalRule::linear},
                                                        {"cofactor", NormalRule::cofactor}};

std::vector<std::string> need_names() {
  std::vector<std::string> names = {kMasks};
  for (const auto& [name, flag] : kNeeds) names.push_back(name);
  return names;
}

Result<Needs> needs_from(const PlanOptions& options, const Scene& scene) {
  Needs needs;
  if (options.skinning.size() != 1 && options.skinning.size() != scene.instances.size())
    return tl::unexpected(ErrorCode::size_mismatch);
  needs.skin.kind = kSkinningNames.at(options.skinning.front());
  if (options.skinning.size() > 1)
    for (const std::string& method : options.skinning) needs.skin.per_instance.push_back(kSkinningNames.at(method));
  needs.skin.normal_rule = kNormalRules.at(options.normals);
  needs.in.max_layers = options.layers;
  if (options.needs.empty()) return needs;
  for (const auto& [name, flag] : kNeeds) flag(needs) = false;
  for (const std::string& name : options.needs)
    if (name == kMasks)
      needs.in.masks = {std::vector<float>(scene.skeleton.joint_count(), 1.0f)};
    else
      kNeeds.at(name)(needs) = true;
  return needs;
}

Json work_json(const WorkCounters& work) {
  return {{"tracks_sampled", work.tracks_sampled},
          {"properties_sampled", work.properties_sampled},
          {"poses_mirrored", work.poses_mirrored},
          {"poses_blended", work.poses_blended},
          {"poses_added", work.poses_added},
          {"poses_interpolated", work.poses_interpolated},
          {"poses_compared", work.poses_compared},
          {"joints_composed", work.joints_composed},
          {"palette_entries", work.palette_entries},
          {"palette_entries_split", work.palette_entries_split},
          {"combinations_blended", work.combinations_blended},
          {"windings_tested", work.windings_tested},
          {"normals_by_cofactors", work.normals_by_cofactors},
          {"morph_deltas", work.morph_deltas},
          {"vertices_morphed", work.vertices_morphed},
          {"vertices_skinned_linear", work.vertices_skinned_linear},
          {"vertices_skinned_in_tiles", work.vertices_skinned_in_tiles},
          {"vertices_skinned_dual_quaternion", work.vertices_skinned_dual_quaternion},
          {"vertices_skinned_center_of_rotation", work.vertices_skinned_center_of_rotation},
          {"cache_frames_decoded", work.cache_frames_decoded},
          {"vertices_from_cache", work.vertices_from_cache},
          {"vertices_blended", work.vertices_blended},
          {"smooth_triangles", work.smooth_triangles},
          {"flat_triangles", work.flat_triangles},
          {"bounds_vertices", work.bounds_vertices}};
}

/// Runs the plan once, in the middle of the clip, and returns the work that the frame counted.
Result<WorkCounters> work_of_one_frame(const Plan& plan, std::uint32_t clip) {
  FrameBuffer frame(plan);
  ClipLayer layer{clip, 0.0};
  if (clip != kNone) layer.time_s = 0.5 * plan.scene().animations[clip].duration_s;
  const FrameInput input{clip == kNone ? std::span<const ClipLayer>{} : std::span<const ClipLayer>(&layer, 1), {}, {}};
  if (const ErrorCode code = run_plan(plan, input, frame); code != ErrorCode::ok) return tl::unexpected(code);
  return frame.result().work;
}

/// The joints that --joint-tolerance leaves out, over the chosen clip or over all clips.
/// err  a sentence that says what is wrong with the length
tl::expected<std::optional<CompiledSkeletonLod>, std::string> leave_out_joints(const PlanOptions& options,
                                                                               const Scene& scene,
                                                                               const std::vector<std::uint32_t>& clips,
                                                                               const Needs& needs) {
  if (!options.joint_tolerance) return std::nullopt;
  const auto asked = parse_length(*options.joint_tolerance);
  if (!asked) return tl::unexpected("--joint-tolerance: " + asked.error());
  return compile_skeleton_lod(scene, metres_of(*asked, scene), options.clip ? clips : std::vector<std::uint32_t>{},
                              needs);
}

/// The compiled plan of one file, with its level of detail, the counted work and the program, if requested.
struct Outcome {
  const Plan& plan;
  const std::optional<CompiledSkeletonLod>& left_out;
  const std::optional<WorkCounters>& work;
  std::vector<ProgramRow> operations = {};
  bool times = false;
};

/// in   file   empty = not named
Json plan_json(const Outcome& outcome, const std::string& file) {
  Json stages = Json::array();
  for (const PlanStage& stage : outcome.plan.stages())
    stages.push_back({{"stage", stage.stage},
                      {"runs", stage.runs},
                      {"reason", stage.reason},
                      {"count", stage.count},
                      {"bytes", stage.bytes}});
  Json report;
  if (!file.empty()) report["file"] = file;
  report["stages"] = stages;
  report["frame_bytes"] = outcome.plan.frame_bytes();
  if (const auto& left_out = outcome.left_out)
    report["left_out_joints"] = left_out_json(outcome.plan.scene(), *left_out);
  if (outcome.work) report["work"] = work_json(*outcome.work);
  if (!outcome.operations.empty()) report["operations"] = program_json(outcome.operations, outcome.times);
  return report;
}

void print_text(const Outcome& outcome) {
  const auto& [plan, left_out, work, operations, times] = outcome;
  std::size_t widest = 5;
  for (const PlanStage& stage : plan.stages()) widest = std::max(widest, stage.stage.size());
  print_result("{:<{}}  {:<8} {:>10} {:>12}  {}\n", "stage", widest, "", "count", "bytes", "reason");
  for (const PlanStage& stage : plan.stages())
    print_result("{:<{}}  {:<8} {:>10} {:>12}  {}\n", stage.stage, widest, stage.runs ? "runs" : "left out",
                 stage.count, stage.bytes, stage.reason);
  print_result("one frame buffer of a character takes {} bytes\n", plan.frame_bytes());
  if (left_out) print_result("{}", left_out_text(plan.scene(), *left_out));
  if (!operations.empty()) print_result("{}", program_text(operations, times));
  if (!work) return;
  print_result("work done by one frame:\n");
  const Json counts = work_json(*work);
  for (const auto& [name, count] : counts.items()) print_result("  {:<34} {:>10}\n", name, count.get<std::uint64_t>());
}

/// One line: how many stages run, how large a character's frame is.
std::string plan_line(const Outcome& outcome, const std::string& file) {
  const auto& stages = outcome.plan.stages();
  const auto running = std::count_if(stages.begin(), stages.end(), [](const PlanStage& stage) { return stage.runs; });
  return fmt::format("{}: {} of {} stages run, a frame buffer takes {} bytes\n", visible_text(file), running,
                     stages.size(), outcome.plan.frame_bytes());
}

ExitCode plan_file(const PlanOptions& options, const std::string& path, bool many) {
  ImportOptions import;
  import.decode_images = false;
  for (const std::string& method : options.skinning)
    if (kSkinningNames.at(method) == Skinning::center_of_rotation) request_centers(import, options.cache);
  const auto file = load_file(path, import);
  if (!file) return ExitCode::input_at_fault;
  const auto chosen = choose_clips(file->scene, options.clip);
  if (!chosen) return fail_with(ExitCode::wrong_usage, chosen.error());

  auto needs = needs_from(options, file->scene);
  if (!needs) {
    return fail_with(ExitCode::wrong_usage, fmt::format("--skinning: {} methods for {} mesh instances",
                                                        options.skinning.size(), file->scene.instances.size()));
  }
  std::optional<ProgramOfModel> program;
  if (options.program) {
    auto loaded = load_program(*options.program, file->scene);
    if (!loaded) return fail_with(ExitCode::input_at_fault, loaded.error());
    program = std::move(*loaded);
    add_program(*program, file->scene, *needs);
  }
  const auto left_out = leave_out_joints(options, file->scene, *chosen, *needs);
  if (!left_out) return fail_with(ExitCode::wrong_usage, left_out.error());
  if (*left_out) needs->out.skeleton_lod = (*left_out)->detail;
  const Plan plan = compile_plan(lend(file->scene), *needs);
  std::optional<WorkCounters> work;
  if (options.clip) {
    const auto counted = work_of_one_frame(plan, chosen->front());
    if (!counted) return fail_with(ExitCode::input_at_fault, fmt::format("{}: {}", path, describe(counted.error())));
    work = *counted;
  }
  Outcome outcome{plan, *left_out, work};
  outcome.times = options.times;
  if (program) outcome.operations = program_rows(plan, *program, options.times);
  if (options.files.json)
    print_json(plan_json(outcome, many ? path : ""), many);
  else if (many)
    print_result_text(plan_line(outcome, path));
  else
    print_text(outcome);
  return ExitCode::done;
}

}  // namespace

Command plan_command() {
  auto options = std::make_shared<PlanOptions>();
  Command command("plan",
                  "Show the stages that a frame of a file runs or leaves out, each with the reason\n"
                  "Several files have one line each.");
  add_batch_options(command, options->files, ".gltf or .glb files, and folders of them; - is the standard input")
      .required();
  command.option("--clip", "INDEX|NAME|none", &options->clip,
                 "Also run one frame in the middle of this clip (none: the rest pose) and count its work");
  command
      .option("--needs", "LIST", &options->needs,
              "What the consumer of frames asks for (default: joints,weights,positions,normals,tangents,properties)")
      .list()
      .one_of(need_names());
  command.option("--layers", "N", &options->layers, "Most clips that blend in one frame (default: 4)").within(1, 64);
  command
      .option("--skinning", "METHOD", &options->skinning,
              "Skinning to plan for: one method, or one for each mesh instance (default: linear)")
      .list()
      .one_of(skinning_names());
  command
      .option("--normals", "RULE", &options->normals,
              "How linear skinning turns normals: linear or cofactor (default: linear)")
      .one_of({"linear", "cofactor"});
  command.option("--joint-tolerance", "LENGTH", &options->joint_tolerance,
                 fmt::format("Leave out joints that move no vertex farther than this over the clip, or over all clips, "
                             "{} (default: none)",
                             kLengthHelp));
  command.option("--program", "PROGRAM.json", &options->program,
                 "Also list the operations of a pose program, each with what takes its pose, or why it is not needed");
  command.flag("--times", options->times, "With --program: also measure the microseconds of each operation");
  add_cache_option(command, options->cache);
  command.flag("--json", options->files.json,
               "Print JSON: {stages: [{stage, runs, reason, count, bytes}], ...}, of several files one document a "
               "line, with the file");
  command.run = [options] {
    return run_batch(options->files,
                     {[&](const Input& file, bool many) { return plan_file(*options, file.path, many); }});
  };
  return command;
}

}  // namespace sinew::tool
