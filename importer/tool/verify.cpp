// SPDX-License-Identifier: MIT
#include "importer/tool/commands.h"

#include <cmath>
#include <memory>
#include <optional>
#include <string_view>

#include <fmt/format.h>

#include "importer/tool/bake/verify_geometry.h"
#include "importer/tool/compare_poses.h"
#include "importer/tool/load_file.h"
#include "importer/tool/messages.h"
#include "importer/tool/model_size.h"
#include "importer/tool/pose_input.h"
#include "importer/tool/pose_sampler.h"
#include "importer/tool/progress_line.h"

namespace sinew::tool {
namespace {

struct VerifyOptions {
  std::string file, golden;
  TakeSource against;  // of a geometry cache
  std::optional<double> tolerance_m;
  bool exact = false;
};

constexpr std::size_t kWorstShown = 10;

bool holds_bits(const PoseFile& golden, const std::string& name) {
  for (const ClipPoses& clip : golden.clips)
    for (const Pose& pose : clip.samples)
      if (pose.bits.contains(name)) return true;
  return false;
}

bool holds(const PoseFile& golden, std::initializer_list<VertexKind> kinds) {
  for (const ClipPoses& clip : golden.clips)
    for (const Pose& pose : clip.samples)
      for (const PrimitivePose& primitive : pose.primitives)
        for (const VertexKind kind : kinds)
          if (!primitive.of(kind).empty()) return true;
  return false;
}

bool holds_centers(const PoseFile& golden, bool exact) {
  return holds(golden, {VertexKind::cors, VertexKind::cor_normals}) ||
         (exact && holds_bits(golden, "centerOfRotation"));
}

/// Samples the scene at the times of the golden file and compares the poses.
Result<void> compare_all(const Scene& scene, const PoseFile& golden, bool exact, PoseComparison& comparison) {
  PoseContent content{true, holds(golden, {VertexKind::dqs, VertexKind::dqs_normals}), holds_centers(golden, exact),
                      kAllVertices, exact};
  if (exact) content.dual_quaternion |= holds_bits(golden, "dualQuaternion");
  PoseSampler sampler(scene, content);
  ProgressLine progress;
  for (std::size_t i = 0; i < golden.clips.size(); ++i) {
    const auto& [clip, samples] = golden.clips[i];
    progress.show("comparing", static_cast<double>(i) / static_cast<double>(golden.clips.size()));
    if (clip != kNone && clip >= scene.clips.size()) {
      comparison.missing(fmt::format("clip {} (the file has {})", clip, scene.clips.size()));
      continue;
    }
    for (const Pose& expected : samples) {
      const auto pose = sampler.sample(clip, expected.time_s);
      if (!pose) return tl::unexpected(pose.error());
      comparison.compare(clip, expected, *pose);
    }
  }
  return {};
}

void print_outcome(const PoseComparison& comparison, const VerifyOptions& options) {
  fmt::print("{}: {} values compared with {}, largest distance {:.3g} m, {} out of tolerance\n", options.file,
             comparison.compared(), options.golden, comparison.largest_m(), comparison.failed());
  for (const Deviation& worst : comparison.worst()) {
    if (std::isinf(worst.amount))
      fmt::print("  {}: missing\n", worst.where);
    else if (std::string_view(worst.unit) == "bits")
      fmt::print("  {}: not the same bits\n", worst.where);
    else
      fmt::print("  {}: off by {:.6g}{}{}, allowed {:.3g}\n", worst.where, worst.amount, *worst.unit ? " " : "",
                 worst.unit, worst.tolerance);
  }
}

ExitCode verify_cache(const VerifyOptions& options) {
  const bool has_source = !options.against.file.empty();
  const auto outcome = verify_geometry(options.file, has_source ? std::optional(options.against) : std::nullopt);
  if (outcome) return *outcome;
  return fail_with(ExitCode::wrong_usage, has_source ? "--against: FILE is no geometry cache"
                                                     : "GOLDEN is required: the poses to compare with");
}

ExitCode verify_poses(const VerifyOptions& options) {
  const auto golden = read_poses(options.golden);
  if (!golden) return fail_with(ExitCode::input_at_fault, options.golden, golden.error());
  if (options.exact && !holds_bits(*golden, "pose")) {
    return fail_with(ExitCode::input_at_fault, options.golden,
                     {Severity::error, "pose-format", "/clips", "holds no bits: sample the file again"});
  }
  ImportOptions import;
  import.decode_images = false;
  import.make_centers_of_rotation = holds_centers(*golden, options.exact);
  import.animate_default_weights = false;  // a pose file holds only what channels of nodes animate
  const auto file = load_file(options.file, import);
  if (!file) return ExitCode::input_at_fault;

  PoseTolerance tolerance;
  tolerance.distance_m = options.tolerance_m;
  tolerance.exact = options.exact;
  tolerance.model_size_m = golden->extent ? *golden->extent : model_size_m(file->scene);
  PoseComparison comparison(tolerance, kWorstShown);
  if (const auto done = compare_all(file->scene, *golden, options.exact, comparison); !done)
    return fail_with(ExitCode::input_at_fault, fmt::format("{}: {}", options.file, describe(done.error())));
  print_outcome(comparison, options);
  if (comparison.compared() == 0) {
    return fail_with(ExitCode::input_at_fault, options.golden,
                     {Severity::error, "pose-format", "/clips", "holds no pose to compare with"});
  }
  if (comparison.failed() == 0) return ExitCode::done;
  return fail_with(ExitCode::input_at_fault, fmt::format("{}: poses differ from {}", options.file, options.golden));
}

}  // namespace

void add_verify(CLI::App& program, ExitCode& outcome) {
  auto options = std::make_shared<VerifyOptions>();
  CLI::App* command = program.add_subcommand(
      "verify",
      "Sample a file again at the times of a pose file that `sinew sample` wrote earlier, and compare.\n"
      "Exit status 0 when every pose still matches; else 1, and the worst differences are listed.\n"
      "A geometry cache (.sgeo) is decoded frame by frame, which compares its checksums; with --against also measured\n"
      "anew. Exit status 0 when every frame is as it was written, and within what was asked.");
  command->add_option("FILE", options->file, "A .gltf or .glb file, or a geometry cache")->required();
  auto* golden = command->add_option("GOLDEN", options->golden, "Poses to compare with, .json or .json.gz");
  auto* against = command->add_option("--against", options->against.file, "What the geometry cache was baked from")
                      ->type_name("SOURCE")
                      ->excludes(golden);
  add_source_options(*command, options->against);
  for (const char* name : {"--clip", "--points"}) command->get_option(name)->needs(against);
  command->add_flag(
      "--exact", options->exact,
      "Also compare every bit of all joints, weights and vertices, listed or not. Bits agree for any thread count\n"
      "and between machines with fused multiply-add (AVX2 and later, ARM)");
  command
      ->add_option("--tolerance", options->tolerance_m,
                   "Largest distance that counts as equal (default: 0.0001 of the larger of model and value)")
      ->type_name("METRES")
      ->check(CLI::NonNegativeNumber);
  command->callback(
      [options, &outcome] { outcome = options->golden.empty() ? verify_cache(*options) : verify_poses(*options); });
}

}  // namespace sinew::tool
