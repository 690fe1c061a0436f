// SPDX-License-Identifier: MIT
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <fmt/core.h>

#include "importer/formats/import_format.h"
#include "importer/tool/batch/run_batch.h"
#include "importer/tool/commands.h"
#include "importer/tool/files/output.h"
#include "importer/tool/length_text.h"
#include "importer/tool/load_file.h"
#include "importer/tool/messages.h"

namespace sinew::tool {
namespace {

struct ImportChoices {
  BatchOptions files;
  std::string in, out;
  std::optional<std::string> unit, up;
  std::string positions = "replace", end_sites = "keep";
};

/// Metres in a unit: its name, a length such as 2.54cm, or a number of metres.
/// err   what is wrong, as a sentence for the user
tl::expected<double, std::string> metres_per_unit(const std::string& text) {
  constexpr struct {
    const char* name;
    double metres;
  } kUnits[] = {{"m", 1.0}, {"dm", 0.1}, {"cm", 0.01}, {"mm", 0.001}, {"in", 0.0254}, {"ft", 0.3048}};
  for (const auto& unit : kUnits)
    if (text == unit.name) return unit.metres;
  const auto length = parse_length(text);
  if (length && length->metres > 0.0) return length->metres;
  return tl::unexpected(in_quotes(text) +
                        " is no unit: m, dm, cm, mm, in, ft, or the length of a unit such as 2.54cm or 0.0254");
}

std::string summary_of(const formats::ImportedFormat& model, const std::string& out) {
  std::string text = fmt::format("{}: {}, {}", out, model.format, counted(model.joints, "node"));
  if (model.vertices != 0)
    text += ", " + std::to_string(model.vertices) + (model.vertices == 1 ? " vertex" : " vertices");
  if (model.clips != 0)
    text += fmt::format(", {} of up to {} and {:.4g} s", counted(model.clips, "clip"), counted(model.keys, "key"),
                        model.duration_s);
  return text + fmt::format(", {} bytes", model.glb.size());
}

ExitCode import_file(const ImportChoices& choices) {
  const ResultsToStderr redirected(is_standard_output(choices.out));
  formats::FormatOptions options;
  if (choices.unit) {
    const auto metres = metres_per_unit(*choices.unit);
    if (!metres) return fail_with(ExitCode::wrong_usage, "--unit: " + metres.error());
    options.metres_per_unit = *metres;
  }
  if (choices.up) options.z_up = *choices.up == "z";
  options.positions_add_to_offset = choices.positions == "add";
  options.keep_end_sites = choices.end_sites == "keep";
  if (!is_stream(choices.out) && std::filesystem::path(choices.out).extension() != ".glb")
    return fail_with(ExitCode::wrong_usage, choices.out + ": OUT must end in .glb");
  const std::filesystem::path inputs[] = {choices.in};
  if (const auto error = find_output_error(choices.out, inputs)) return fail_with(ExitCode::wrong_usage, *error);

  const auto model = formats::import_format(choices.in, options);
  if (!model) {
    print_import_error(choices.in, model.error());
    return ExitCode::input_at_fault;
  }
  print_issues(choices.in, model->warnings);
  for (const std::string& thing : model->left_out) print_error(choices.in + ": left out: " + thing);
  const ExitCode code = write_output(choices.out, model->glb);
  if (code == ExitCode::done) print_result("{}\n", summary_of(*model, choices.out));
  return code;
}

ExitCode import_files(const ImportChoices& choices) {
  const auto run = [&](const Input& file, bool many) {
    ImportChoices own = choices;
    own.in = file.path;
    if (many) own.out = file.output;
    return import_file(own);
  };
  return run_batch(choices.files, {run, {}, BatchOutput{choices.out, ".glb"}, FileKind::other_formats});
}

}  // namespace

Command import_command() {
  auto choices = std::make_shared<ImportChoices>();
  Command command(
      "import",
      "Make a .glb of a file of another format: BVH, FBX or COLLADA\n"
      "Motion capture and models come into glTF with the names of their joints, in metres, and with y up. The other "
      "commands read the result: `sinew retarget` plays its clips on a character, `sinew convert --budget` leaves out "
      "keys.\n"
      "\n"
      "BVH: each joint becomes a node and each frame a key. Channels may be in any order, on any joint. The format "
      "says "
      "nothing of its unit, which is the centimetre unless --unit names another.\n"
      "\n"
      "FBX and COLLADA are read by assimp: nodes, meshes, skins, morph targets, clips, and of materials the colours. "
      "Unit and axes are those that the file names. Pivots are folded, so that a joint is one node; keys are added "
      "where "
      "a pivot bends the way between two keys. All keys are joined by straight lines: assimp does not tell curves or "
      "steps. Cameras, lights, textures, points and lines are left out and listed; NURBS, constraints and layers that "
      "assimp does not read are not. Import only files that you trust: assimp may crash on damaged ones.\n"
      "\n"
      "A file that cannot be read is an error that names its line, where the format has lines, and OUT stays as it "
      "was.");
  add_batch_options(command, choices->files,
                    ".bvh, .fbx and .dae files, and folders of them; the first bytes tell which", "IN")
      .required();
  command
      .argument("OUT", &choices->out,
                "The .glb file to write; of several files the folder for them; - writes to the standard output")
      .required()
      .takes_last = [](const std::string&) { return true; };
  command.option("--unit", "UNIT", &choices->unit,
                 "Unit of lengths in IN: m, dm, cm, mm, in, ft, or its length such as 2.54cm (default: what the file "
                 "says; cm for BVH)");
  command.option("--up", "AXIS", &choices->up, "Axis that points up in IN (default: what the file says; y for BVH)")
      .one_of({"y", "z"});
  command
      .option(
          "--positions", "HOW", &choices->positions,
          "BVH, joints with position channels: replace puts them in place of OFFSET, as Blender does; add adds them "
          "to it, as three.js does")
      .one_of({"replace", "add"});
  command
      .option("--end-sites", "HOW", &choices->end_sites,
              "BVH: keep makes a node of each end site, called PARENT_end; drop leaves them out")
      .one_of({"keep", "drop"});
  command.run = [choices] { return import_files(*choices); };
  return command;
}

}  // namespace sinew::tool
