// SPDX-License-Identifier: MIT
#include <cstdio>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "importer/platform/files.h"
#include "importer/rewrite_gltf.h"
#include "importer/tool/annotations_option.h"
#include "importer/tool/batch/run_batch.h"
#include "importer/tool/commands.h"
#include "importer/tool/convert/mirror_clips.h"
#include "importer/tool/convert/resample_clips.h"
#include "importer/tool/convert/written_clips.h"
#include "importer/tool/files/model_output.h"
#include "importer/tool/files/output.h"
#include "importer/tool/length_text.h"
#include "importer/tool/load_file.h"
#include "importer/tool/messages.h"
#include "importer/tool/model_size.h"
#include "importer/tool/reference_choice.h"

namespace sinew::tool {
namespace {

struct ConvertOptions {
  BatchOptions files;
  std::string in, out;
  std::optional<std::string> format;  // "glb" or "gltf"; empty = as the name of OUT says
  std::optional<std::string> budget, reference, annotations;
  std::optional<double> fps;
  bool mirror = false, quantize = false, merge_vertices = false, meshopt = false, decode_images = false;
  std::vector<std::string> drop;
};

std::string size_line(const std::string& out, std::size_t bytes, std::uint64_t before) {
  return fmt::format("{}: {} bytes, {} before ({:.1f} %)", out, bytes, before,
                     100.0 * static_cast<double>(bytes) / static_cast<double>(before));
}

/// err   what is wrong, as a sentence for the user
tl::expected<ModelOutput, std::string> output_of(const ConvertOptions& options) {
  auto output = model_output(options.out);
  if (!output) return output;
  if (is_stream(platform::path_of(options.out))) {
    if (options.format == "gltf") return tl::unexpected(options.out + ": a .gltf needs a place for its .bin");
    if (options.budget || options.fps)
      return tl::unexpected(options.out + ": cannot be read again and measured, as --budget and --fps do");
  } else if (options.format && output->file.extension() != "." + *options.format) {
    return tl::unexpected(
        fmt::format("{}: --format {} writes a file that ends in .{}", options.out, *options.format, *options.format));
  }
  return output;
}

/// The clips that written clips are measured against: those of the file, or their mirror images.
struct Truths {
  std::vector<Animation> changed;          // mirrored or annotated; empty without these options
  std::vector<std::uint32_t> channels_to;  // RewriteOptions::channels_to

  std::span<const Animation> of(const Scene& scene) const { return changed.empty() ? scene.animations : changed; }
};

/// err   what is wrong, as a sentence for the user
tl::expected<Truths, std::string> truths_of(const ConvertOptions& options, const Scene& scene) {
  if (!options.mirror) return Truths{};
  auto found = mirror_clips(scene, options.reference);
  if (!found) return tl::unexpected(found.error());
  if (const auto warning = bind_pose_warning(scene)) print_error(options.in + ": " + *warning);
  print_error(options.in + ": " + found->summary);
  return Truths{std::move(found->animations), std::move(found->channels_to)};
}

/// Writes clips with other keys, and prints their measured errors.
ExitCode convert_clips(const ConvertOptions& options, const ImportedFile& model, std::span<const Animation> truths,
                       RewriteOptions changes, std::optional<double> budget_m, const ModelOutput& output, bool many) {
  auto written = budget_m ? write_within(model, truths, std::move(changes), *budget_m)
                          : write_keys(model, truths, std::move(changes),
                                       resample_clips({truths.begin(), truths.end()}, *options.fps));
  if (!written) return print_rewrite_error(options.in, written.error());
  const auto bytes = output.buffer.empty() ? write_rewritten(written->file, options.in, output)
                                           : write_model(model, options.in, written->changes, options.drop, output);
  if (!bytes) return bytes.error();
  if (!many) print_result_text(certified_clips_table(written->clips, model.scene.skeleton.names));
  print_result("{}; {}\n", size_line(options.out, *bytes, model.facts.file_bytes), summary_of(*written));
  const std::size_t not_met = clips_not_met(*written);
  if (not_met == 0) return ExitCode::done;
  return fail_with(ExitCode::input_at_fault,
                   fmt::format("{}: {} of {} cannot be written within {}; {} all keys of the input", options.out,
                               not_met, counted(written->clips.size(), "clip"), length_text(*budget_m),
                               not_met == 1 ? "it has" : "they have"));
}

ExitCode convert_file(const ConvertOptions& options, bool many) {
  const ResultsToStderr redirected(is_standard_output(platform::path_of(options.out)));
  const auto output = output_of(options);
  if (!output) return fail_with(ExitCode::wrong_usage, output.error());
  const auto budget = parse_length(options.budget.value_or("0"));
  if (!budget) return fail_with(ExitCode::wrong_usage, "--budget: " + budget.error());
  ImportOptions import;
  import.decode_images = import.make_tangents = false;
  import.carry_document = true;
  const auto model = load_file(options.in, import);
  if (!model) return ExitCode::input_at_fault;
  if (const auto error = find_output_error(*output, model->facts.files))
    return fail_with(ExitCode::wrong_usage, *error);

  auto truths = truths_of(options, model->scene);
  if (!truths) return fail_with(ExitCode::wrong_usage, options.in + ": " + truths.error());
  if (options.annotations) {
    truths->changed = model->scene.animations;
    if (const ExitCode code = annotate_from(options.annotations, truths->changed); code != ExitCode::done) return code;
  }
  RewriteOptions changes;
  changes.animations = truths->changed;
  changes.channels_to = truths->channels_to;
  changes.quantize = options.quantize;
  changes.merge_vertices = options.merge_vertices;
  changes.meshopt = options.meshopt;
  changes.decode_images = options.decode_images;
  changes.drop.insert(options.drop.begin(), options.drop.end());
  if ((options.budget || options.fps) && !model->scene.animations.empty()) {
    const auto budget_m = options.budget ? std::optional(metres_of(*budget, model->scene)) : std::nullopt;
    return convert_clips(options, *model, truths->of(model->scene), std::move(changes), budget_m, *output, many);
  }
  const auto bytes = write_model(*model, options.in, std::move(changes), options.drop, *output);
  if (!bytes) return bytes.error();
  print_result("{}\n", size_line(options.out, *bytes, model->facts.file_bytes));
  return ExitCode::done;
}

ExitCode convert_files(const ConvertOptions& options) {
  const auto run = [&](const Input& file, bool many) {
    ConvertOptions own = options;
    own.in = file.path;
    if (many) own.out = file.output;
    return convert_file(own, many);
  };
  return run_batch(options.files, {run, {}, BatchOutput{options.out, "." + options.format.value_or("glb")}});
}

}  // namespace

Command convert_command() {
  auto options = std::make_shared<ConvertOptions>();
  Command command(
      "convert",
      "Write a file again, as one .glb or as a .gltf with a .bin beside it\n"
      "Everything that the file says is carried: extras, extensions, attributes and names that sinew does not know, "
      "cameras and lights that nothing uses, images of any kind. Compressed data are decoded; bytes that nothing names "
      "are left out. Reading OUT gives the same scene, bit for bit, and converting OUT again the same file.\n"
      "\n"
      "What cannot be carried is listed, one line each, and nothing is written unless --drop names it. OUT appears "
      "complete or not at all, and never replaces a file that is read.\n"
      "\n"
      "With a budget, keys are left out of clips as long as no vertex of the model ever moves farther than the budget "
      "from where it was, and no camera or light turns by more than 0.05 degrees. A channel that leaves its node where "
      "the file puts it without animation is left out. --fps resamples clips. Either way the "
      "written file is read again and measured, and each line says how many keys are left. A clip for which no smaller "
      "form is within the budget keeps all of its keys. Where even these are not, since what is written cannot say the "
      "same, the exit status is 1.\n"
      "\n"
      "--quantize and --meshopt make the file smaller. The first rounds numbers, the second compresses them.");
  add_batch_options(command, options->files, ".gltf or .glb files, and folders of them; - is the standard input", "IN")
      .required();
  command
      .argument("OUT", &options->out,
                "The .glb or .gltf file to write; of several files the folder for them; - writes a .glb to the "
                "standard output")
      .required()
      .takes_last = [](const std::string&) { return true; };
  command
      .option("--format", "FORMAT", &options->format,
              "glb: one file; gltf: a .gltf with a .bin beside it (default: what OUT's name ends in; of several files "
              "glb)")
      .one_of({"glb", "gltf"});
  command.option("--budget", "LENGTH", &options->budget,
                 fmt::format("Largest distance by which leaving out keys may move anything, {}", kLengthHelp));
  command
      .option("--fps", "N", &options->fps,
              "Linear keys that many times a second, in place of the keys of tracks that are not STEP")
      .within(1e-3, 1e6)
      .excludes("--budget");
  command.flag("--mirror", options->mirror,
               "Exchange left and right in every clip, key by key: joints are paired by their names, or by their\n"
               "places where names do not tell; joints without a partner are listed. With --budget or --fps the\n"
               "mirrored clips get fewer keys");
  command
      .option("--reference", "POSE", &options->reference,
              std::string(kReferenceHelp) +
                  "The symmetric pose that --mirror keeps as it is.\n"
                  "Default: rest, but bind if the rest pose is asymmetric and the bind pose by less than half as much")
      .needs("--mirror");
  add_annotations_option(command, options->annotations).excludes("--mirror");
  command.flag("--quantize", options->quantize,
               "Store normals and tangents in 8 bits, texture coordinates in 12, colours and weights in 8,\n"
               "rotation keys in 16 (with --meshopt in 12, positions in 15 and other keys in 16). Weights get\n"
               "16 bits where 8 would move a vertex by more than 0.1 % of the model, rotations above a camera\n"
               "or a light always. With --budget, keys get as many bits as the budget needs. Vertices keep\n"
               "their order and number");
  command.flag("--merge-vertices", options->merge_vertices,
               "Merge equal vertices and leave out unused ones, which gives vertices other numbers");
  command.flag("--meshopt", options->meshopt,
               "Compress with EXT_meshopt_compression; merges equal vertices and gives them another order, so that\n"
               "poses and geometry caches of the input no longer fit");
  command.flag("--decode-images", options->decode_images,
               "Write WebP, AVIF and KTX2 images as PNG, which every program reads");
  add_drop_option(command, options->drop);
  command.run = [options] { return convert_files(*options); };
  return command;
}

}  // namespace sinew::tool
