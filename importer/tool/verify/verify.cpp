// SPDX-License-Identifier: MIT
#include "importer/platform/files.h"
#include "importer/tool/commands.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "importer/tool/bake/verify_geometry.h"
#include "importer/tool/batch/run_batch.h"
#include "importer/tool/files/cache_folder.h"
#include "importer/tool/files/output.h"
#include "importer/tool/graph/golden_trace.h"
#include "importer/tool/load_file.h"
#include "importer/tool/messages.h"
#include "importer/tool/model_size.h"
#include "importer/tool/poses/compare_poses.h"
#include "importer/tool/poses/pose_input.h"
#include "importer/tool/poses/pose_sampler.h"
#include "importer/tool/poses/write_poses.h"
#include "importer/tool/progress_line.h"
#include "importer/tool/verify/pose_picture.h"
#include "importer/tool/verify/verify_report.h"
#include "importer/tool/verify/verify_tolerance.h"

namespace sinew::tool {
namespace {

struct VerifyOptions {
  BatchOptions files;
  std::string file, golden;
  TakeSource against;  // source that a geometry cache is compared with
  ToleranceOptions tolerance;
  std::string cache, junit, html, viewer;
  bool exact = false, update = false;
};

constexpr std::size_t kWorstShown = 10;

bool holds_centers(const PoseSummary& golden, bool exact) {
  return golden.holds(VertexKind::cors) || golden.holds(VertexKind::cor_normals) ||
         (exact && golden.bits.contains("centerOfRotation"));
}

PoseContent content_of(const PoseSummary& golden, bool exact) {
  PoseContent content{true, golden.holds(VertexKind::dqs) || golden.holds(VertexKind::dqs_normals),
                      holds_centers(golden, exact), kAllVertices, exact};
  if (exact) content.dual_quaternion |= golden.bits.contains("dualQuaternion");
  return content;
}

/// Reads the golden file again, pose by pose, samples the scene at its times and calls `visit(clip, golden, pose)`.
/// Clips that the file lacks are left out.
/// in    golden  facts about the file from its first reading
/// err   what is wrong, as a sentence for the user
template <class Visit>
tl::expected<void, std::string> sample_like(const Scene& scene, const VerifyOptions& options, const PoseSummary& golden,
                                            const Visit& visit) {
  PoseSampler sampler(scene, content_of(golden, options.exact));
  ErrorCode failed = ErrorCode::ok;
  const auto read = read_poses(options.golden, [&](std::size_t entry, const Pose& expected) {
    if (entry >= golden.clips.size()) return false;
    const std::uint32_t clip = golden.clips[entry];
    if (clip != kNone && clip >= scene.clips.size()) return true;
    const auto pose = sampler.sample(clip, expected.time_s);
    if (!pose) failed = pose.error();
    if (pose) visit(clip, expected, *pose);
    return pose.has_value();
  });
  if (failed != ErrorCode::ok) return tl::unexpected(fmt::format("{}: {}", options.file, describe(failed)));
  if (!read || *read != golden) return tl::unexpected(options.golden + ": has changed while it was read");
  return {};
}

tl::expected<void, std::string> compare_all(const Scene& scene, const VerifyOptions& options, const PoseSummary& golden,
                                            PoseComparison& comparison, std::vector<DifferenceOverTime>& over_time) {
  for (const std::uint32_t clip : golden.clips)
    if (clip != kNone && clip >= scene.clips.size())
      comparison.missing(fmt::format("clip {} (the file has {})", clip, scene.clips.size()));
  ProgressLine progress;
  std::size_t done = 0;
  std::map<std::uint32_t, std::size_t> row_of;  // of over_time, for each clip
  return sample_like(scene, options, golden, [&](std::uint32_t clip, const Pose& expected, const Pose& pose) {
    progress.show("comparing", static_cast<double>(done++) / static_cast<double>(golden.poses));
    const double ratio = comparison.compare(clip, expected, pose);
    if (options.html.empty()) return;  // memory does not grow with the number of poses
    const auto [row, is_new] = row_of.try_emplace(clip, over_time.size());
    if (is_new) over_time.push_back({.clip = comparison.clip_text(clip)});
    over_time[row->second].times_s.push_back(expected.time_s);
    over_time[row->second].ratios.push_back(ratio);
  });
}

std::string deviation_text(const Deviation& worst) {
  const std::string_view unit = worst.unit;
  std::string text = worst.where + ": ";
  if (unit == "numbers")
    return text +
           "have other numbers, or were merged: their golden places are those of other vertices. Only poses of "
           "this file, or of one with its order, can be compared";
  if (std::isinf(worst.amount))
    text += "missing";
  else if (unit == "bits")
    text += "not the same bits";
  else
    text +=
        fmt::format("off by {:.6g}{}{}, allowed {:.3g}", worst.amount, unit.empty() ? "" : " ", unit, worst.tolerance);
  if (worst.more > 0) text += fmt::format(" ({} more of this kind)", worst.more);
  return text;
}

void print_outcome(const VerifiedFile& report, bool many) {
  print_result("{}: {} values compared with {}, largest distance {:.3g} m, {} out of tolerance{}\n", report.file,
               report.compared, report.golden, report.largest_m, report.failed,
               many && !report.lines.empty() ? "; worst: " + report.lines.front() : "");
  if (many) return;
  for (const std::string& line : report.lines) print_result("  {}\n", line);
}

/// Names of clips and nodes in the form in which the program shows them.
PoseNames names_of(const Scene& scene) {
  const auto quoted = [](const std::string& name) { return name.empty() ? std::string() : in_quotes(name); };
  PoseNames names;
  for (const Clip& clip : scene.clips) names.clips.push_back(quoted(clip.name()));
  for (const std::uint32_t joint : scene.skeleton.joint_of_node)
    names.nodes.push_back(joint == kNone ? std::string() : quoted(scene.skeleton.names[joint]));
  return names;
}

/// Replaces the golden poses by the current ones, with the same clips and times, number of vertices and skinning.
ExitCode update_golden(const Scene& scene, const VerifyOptions& options, const PoseSummary& golden) {
  std::vector<SampledClip> clips;
  for (const std::uint32_t clip : golden.clips)
    if (clip == kNone || clip < scene.clips.size()) clips.push_back({clip, {}});
  if (clips.size() != golden.clips.size())
    return fail_with(ExitCode::input_at_fault,
                     options.golden + ": has clips that the file lacks, and stays as it is; sample the file again");
  std::size_t most_vertices = 0;
  const auto read = read_poses(options.golden, [&](std::size_t entry, const Pose& pose) {
    if (entry >= clips.size()) return false;
    clips[entry].times_s.push_back(pose.time_s);
    for (const PrimitivePose& primitive : pose.primitives)
      most_vertices = std::max(most_vertices, primitive.vertices.size());
    return true;
  });
  if (!read || *read != golden)
    return fail_with(ExitCode::cannot_read, options.golden + ": has changed while it was read");
  PoseContent content = content_of(golden, true);
  content.vertices_per_primitive = most_vertices;
  content.bits = !golden.bits.empty();
  const ExitCode code = write_poses(scene, clips, content, PoseFormat::json, options.file, options.golden);
  if (code == ExitCode::done) print_result("{}: updated\n", options.golden);
  return code;
}

ExitCode verify_cache(const VerifyOptions& options, const std::string& file, bool many) {
  const bool has_source = !options.against.file.empty();
  const auto outcome = verify_geometry(file, has_source ? std::optional(options.against) : std::nullopt, many);
  if (outcome) return *outcome;
  return fail_with(ExitCode::wrong_usage, has_source ? "--against: FILE is no geometry cache"
                                                     : "GOLDEN is required: the poses to compare with");
}

/// Plays the graph of a golden trace again, and compares frame by frame.
ExitCode verify_trace(const VerifyOptions& options, bool many, VerifiedFile& report) {
  ImportOptions plain;
  plain.decode_images = plain.make_tangents = plain.make_normals = false;
  const auto file = load_file(options.file, plain);
  if (!file) return ExitCode::cannot_read;
  const auto compared = compare_with_golden(options.golden, file->scene);
  if (!compared) return fail_with(ExitCode::cannot_read, compared.error());
  const std::vector<std::string>& differences = compared->differences;
  report.compared = compared->compared;
  report.failed = differences.size();
  report.lines.assign(differences.begin(),
                      differences.begin() + static_cast<std::ptrdiff_t>(std::min(differences.size(), kWorstShown)));
  print_result("{}: {} compared with {}, {} differ{}\n", options.file, counted(compared->compared, "frame"),
               options.golden, differences.size(),
               many && !differences.empty() ? "; first: " + differences.front() : "");
  if (!many)
    for (const std::string& line : report.lines) print_result("  {}\n", line);
  if (differences.empty()) return ExitCode::done;
  if (!options.update)
    return fail_with(ExitCode::input_at_fault,
                     fmt::format("{}: plays other frames than {}", options.file, options.golden));
  const std::string text = golden_trace_text(compared->today);
  const ExitCode code = write_output(options.golden, std::as_bytes(std::span(text)));
  if (code == ExitCode::done) print_result("{}: updated\n", options.golden);
  return code;
}

/// Compares one file. Fills `report`.
ExitCode verify_poses(const VerifyOptions& options, bool many, VerifiedFile& report) {
  if (const auto parsed = parse_tolerance(options.tolerance, 1.0); !parsed)
    return fail_with(ExitCode::wrong_usage, parsed.error());
  if (is_golden_trace(options.golden)) return verify_trace(options, many, report);
  const auto golden = read_poses(options.golden);
  if (!golden) return fail_with(ExitCode::cannot_read, options.golden, golden.error());
  if (options.exact && !golden->bits.contains("pose")) {
    return fail_with(ExitCode::cannot_read, options.golden,
                     {Severity::error, "pose-format", "/clips", "holds no bits: sample the file again"});
  }
  ImportOptions import;
  import.decode_images = false;
  if (holds_centers(*golden, options.exact)) request_centers(import, options.cache);
  import.animate_default_weights = false;  // pose files leave out channels of mesh.weights
  const auto file = load_file(options.file, import);
  if (!file) return ExitCode::cannot_read;

  // Earlier versions wrote an extent of nearly 0 for files without meshes.
  const bool has_extent = golden->extent && *golden->extent > kSizeWithoutVertices;
  PoseTolerance tolerance =
      *parse_tolerance(options.tolerance, has_extent ? *golden->extent : model_size_m(file->scene));
  tolerance.exact = options.exact;
  PoseComparison comparison(tolerance, names_of(file->scene));
  if (const auto done = compare_all(file->scene, options, *golden, comparison, report.over_time); !done)
    return fail_with(ExitCode::cannot_read, done.error());
  report.compared = comparison.compared();
  report.failed = comparison.failed();
  report.largest_m = comparison.largest_m();
  report.worst = comparison.worst();
  for (std::size_t i = 0; i < std::min(report.worst.size(), kWorstShown); ++i)
    report.lines.push_back(deviation_text(report.worst[i]));
  print_outcome(report, many);
  if (comparison.compared() == 0) {
    return fail_with(ExitCode::cannot_read, options.golden,
                     {Severity::error, "pose-format", "/clips", "holds no pose to compare with"});
  }
  if (comparison.failed() == 0) return ExitCode::done;
  if (!options.html.empty()) {
    const Skeleton& skeleton = file->scene.skeleton;
    report.history = PoseHistory::of(report.worst, skeleton, comparison.names());
    const auto sampled =
        sample_like(file->scene, options, *golden, [&](std::uint32_t clip, const Pose& expected, const Pose& pose) {
          report.history.add(clip, expected, pose, skeleton);
        });
    if (!sampled) return fail_with(ExitCode::cannot_read, sampled.error());
  }
  if (options.update) return update_golden(file->scene, options, *golden);
  return fail_with(ExitCode::input_at_fault, fmt::format("{}: poses differ from {}", options.file, options.golden));
}

/// The file of golden poses that belongs to a model of a folder, as `sinew sample` names it.
std::string golden_of(const std::string& folder, const Input& file) {
  const std::filesystem::path poses =
      (platform::path_of(folder) / platform::path_of(file.below)).replace_extension(".json");
  std::error_code error;
  return std::filesystem::exists(poses, error) ? platform::text_of(poses) : platform::text_of(poses) + ".gz";
}

ExitCode verify_input(VerifyOptions options, const Input& file, bool many, VerifyReport& report) {
  options.file = file.path;
  std::error_code error;
  if (many || std::filesystem::is_directory(options.golden, error)) options.golden = golden_of(options.golden, file);
  VerifiedFile found{.file = options.file, .golden = options.golden};
  const auto begin = std::chrono::steady_clock::now();
  found.code = verify_poses(options, many, found);
  found.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  const ExitCode code = found.code;
  report.add(std::move(found));
  return code;
}

ExitCode write_report(const std::string& file, const std::string& text) {
  return file.empty() ? ExitCode::done : write_output(file, std::as_bytes(std::span(text)));
}

/// Compares all files, and writes the reports that are asked for.
ExitCode verify_all(const VerifyOptions& options) {
  for (const std::string& output : {options.junit, options.html})
    if (!output.empty())
      if (const auto error = find_output_error(output, {})) return fail_with(ExitCode::wrong_usage, *error);
  VerifyReport report;
  const ExitCode code = run_batch(
      options.files, {.run = [&](const Input& file, bool many) { return verify_input(options, file, many, report); },
                      .bad_folder = ExitCode::cannot_read});
  std::vector<VerifiedFile> files = report.take();
  if (!options.viewer.empty()) add_pictures(files, options.viewer);
  for (const ExitCode written : {write_report(options.junit, options.junit.empty() ? "" : junit_report(files)),
                                 write_report(options.html, options.html.empty() ? "" : verify_page(files))})
    if (written != ExitCode::done) return written;
  return code;
}

ExitCode verify_files(const VerifyOptions& options) {
  if (!options.golden.empty()) return verify_all(options);
  const auto run = [&](const Input& file, bool many) { return verify_cache(options, file.path, many); };
  return run_batch(options.files, {.run = run, .kind = FileKind::geometry_caches, .bad_folder = ExitCode::cannot_read});
}

}  // namespace

Command verify_command() {
  auto options = std::make_shared<VerifyOptions>();
  Command command(
      "verify",
      "Sample a file again, and tell where it differs from poses that were written earlier\n"
      "The file is sampled at the times of a pose file that `sinew sample` wrote. Exit status 0 when every pose still "
      "matches; 1 when one has moved, and the worst differences are listed, the worst first; 4 when a file cannot be "
      "read, so that "
      "nothing was compared.\n"
      "\n"
      "A trace that `sinew graph trace -o` wrote is played again, and compared frame by frame: states, pose program "
      "and "
      "events.\n"
      "\n"
      "A geometry cache (.sgeo) is decoded frame by frame, which compares its checksums; with --against also measured "
      "anew. Exit status 0 when every frame is as it was written, and within what was asked.");
  add_batch_options(command, options->files,
                    ".gltf or .glb files, and folders of them; or geometry caches, and folders of them, without GOLDEN")
      .required();
  command
      .argument("GOLDEN", &options->golden,
                "Poses or a graph's trace to compare with, .json or .json.gz; of several files the folder that `sinew "
                "sample FILE... -o "
                "GOLDEN` filled")
      .takes_last = [](const std::string& word) { return !is_named_as(FileKind::geometry_caches, word); };
  command.option("--against", "SOURCE", &options->against.file, "What the geometry cache was baked from")
      .excludes("GOLDEN");
  const SourceOptions of_source = add_source_options(command, options->against);
  of_source.clip.needs("--against");
  of_source.points.needs("--against");
  command.flag("--exact", options->exact,
               "Also compare every bit of all joints, weights and vertices, listed or not. Bits agree for any thread "
               "count\nand between machines with fused multiply-add (AVX2 and later, ARM)");
  add_tolerance_options(command, options->tolerance);
  command.flag(
      "--update", options->update,
      "Where poses are out of tolerance, write GOLDEN again with the poses of FILE: the same clips, times and\n"
      "number of vertices. The differences are listed all the same; exit status 0");
  command.option("--junit", "FILE", &options->junit, "Also write a test report as JUnit XML, which build servers show")
      .needs("GOLDEN");
  command
      .option("--html", "FILE", &options->html,
              "Also write a page for people: what moved, when and how far, curves of golden and current poses")
      .needs("GOLDEN");
  command
      .option("--viewer", "PROGRAM", &options->viewer,
              "Put pictures of the worst poses on the page, drawn by this sinew-viewer")
      .needs("--html");
  add_cache_option(command, options->cache);
  command.run = [options] { return verify_files(*options); };
  return command;
}

}  // namespace sinew::tool
