// SPDX-License-Identifier: MIT
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/core.h>

#include "importer/tool/clip_choice.h"
#include "importer/tool/commands.h"
#include "importer/tool/files/output.h"
#include "importer/tool/files/streamed_file.h"
#include "importer/tool/json.h"
#include "importer/tool/load_file.h"
#include "importer/tool/messages.h"
#include "importer/tool/simulate/ground_profile.h"
#include "importer/tool/simulate/root_path.h"
#include "importer/tool/simulate/simulation.h"
#include "importer/visible_text.h"

namespace sinew::tool {
namespace {

struct SimulateOptions {
  std::string file, output;
  std::optional<std::string> clip, root, look_at, ground;
  double fps = 60.0, seconds = 1.0;
};

constexpr double kMostSimulatedFrames = 1e6;  // so that a typing error does not fill the disk

constexpr double kFarthestPlace_m = 1e12;

std::string text_of(double x, double y, double z) { return fmt::format("[{},{},{}]", x, y, z); }

std::string text_of(const Gaze& gaze) {
  return fmt::format(R"(,"gaze":{{"yaw":{},"pitch":{},"left":{},"right":{},"up":{},"down":{}}})", gaze.yaw_rad,
                     gaze.pitch_rad, gaze.left, gaze.right, gaze.up, gaze.down);
}

/// Left and right foot; nothing without ground.
std::string text_of(std::span<const FootResult> feet) {
  std::string all;
  for (const FootResult& foot : feet)
    all += fmt::format("{}{{\"locked\":{},\"tip\":{},\"heel\":{}}}", all.empty() ? "" : ",", foot.is_locked,
                       foot.tip_above_ground_m, foot.heel_above_ground_m);
  return all.empty() ? "" : fmt::format(",\"feet\":[{}]", all);
}

/// Reads "0,1.6,3".
std::optional<Vec3<double>> read_place(std::string_view text) {
  Vec3<double> place(0.0);
  const char *at = text.data(), *const end = at + text.size();
  for (int i = 0; i < 3; ++i) {
    if (i > 0 && (at == end || *at++ != ',')) return std::nullopt;
    const auto [stop, error] = std::from_chars(at, end, place[i]);
    if (error != std::errc{} || !(std::abs(place[i]) <= kFarthestPlace_m)) return std::nullopt;
    at = stop;
  }
  return at == end ? std::optional(place) : std::nullopt;
}

/// Writes frames as they are stepped, in the form that Simulation's joints have.
class FrameWriter {
 public:
  FrameWriter(StreamedFile& out, const SimulateOptions& options, const Simulation& simulation) : out_(out) {
    Json joints = Json::array();
    for (const std::string& name : simulation.joints()) joints.push_back(name);
    const std::string file = std::filesystem::path(options.file).filename().string();
    out_.write(fmt::format("{{\"file\":{},\"fps\":{},\"joints\":{},\"frames\":[", Json(file).dump(), options.fps,
                           joints.dump()));
  }

  void write(double time_s, const std::vector<SimulatedJoint>& joints, const Simulation& simulation) {
    std::string q, tails;
    for (const SimulatedJoint& joint : joints) {
      const auto& r = joint.rotation;
      const std::string_view comma = q.empty() ? "" : ",";
      q += fmt::format("{}[{},{},{},{}]", comma, r.x, r.y, r.z, r.w);
      tails += fmt::format("{}{}", comma, text_of(joint.tail.x, joint.tail.y, joint.tail.z));
    }
    const std::optional<Gaze>& gaze = simulation.gaze();
    out_.write(fmt::format("{}{{\"t\":{},\"q\":[{}],\"tail\":[{}]{}{}}}", is_first_ ? "\n" : ",\n", time_s, q, tails,
                           gaze ? text_of(*gaze) : "", text_of(simulation.feet())));
    is_first_ = false;
  }

  void end() { out_.write("]}\n"); }

 private:
  StreamedFile& out_;
  bool is_first_ = true;
};

ExitCode write_frames(const SimulateOptions& options, const RootPath& path, Simulation& simulation) {
  const std::string target = is_standard_output(options.output) ? "" : options.output;
  StreamedFile out(target);
  if (!out.opened())
    return fail_with(ExitCode::machine_lacks, fmt::format("{}: {}", visible_text(target), std::strerror(errno)));
  FrameWriter writer(out, options, simulation);
  simulation.reset(0.0, path.at(0.0));
  const auto frames = static_cast<std::uint64_t>(std::llround(options.fps * options.seconds));
  for (std::uint64_t frame = 1; frame <= frames; ++frame) {
    const double time_s = static_cast<double>(frame) / options.fps;
    writer.write(time_s, simulation.step(time_s, 1.0 / options.fps, path.at(time_s)), simulation);
  }
  writer.end();
  if (!out.finish())
    return fail_with(ExitCode::machine_lacks, fmt::format("{}: {}", visible_text(target), std::strerror(errno)));
  const ResultsToStderr to_stderr(target.empty());
  print_result("{}: {} of {}\n", target.empty() ? "-" : visible_text(target), counted(frames, "frame"),
               counted(simulation.joints().size(), "joint"));
  return ExitCode::done;
}

ExitCode simulate(const SimulateOptions& options) {
  if (options.fps * options.seconds > kMostSimulatedFrames)
    return fail_with(ExitCode::wrong_usage, fmt::format("--fps {} --for {}: more than {} frames", options.fps,
                                                        options.seconds, kMostSimulatedFrames));
  std::optional<Vec3<double>> look_at;
  if (options.look_at && !(look_at = read_place(*options.look_at)))
    return fail_with(ExitCode::wrong_usage, fmt::format("--look-at {}: is no place of the form X,Y,Z in metres",
                                                        visible_text(*options.look_at)));
  RootPath path;
  std::vector<std::filesystem::path> inputs;
  if (options.root) {
    auto read = read_root_path(*options.root);
    if (!read) return fail_with(ExitCode::input_at_fault, "--root " + visible_text(read.error()));
    path = *std::move(read);
    inputs.emplace_back(*options.root);
  }
  std::optional<GroundProfile> ground;
  if (options.ground) {
    auto read = read_ground(*options.ground);
    if (!read) return fail_with(ExitCode::input_at_fault, "--ground " + visible_text(read.error()));
    ground = *std::move(read);
    if (std::filesystem::is_regular_file(*options.ground)) inputs.emplace_back(*options.ground);
  }
  ImportOptions import;
  import.decode_images = false;
  const auto file = load_file(options.file, import);
  if (!file) return ExitCode::input_at_fault;
  inputs.insert(inputs.end(), file->facts.files.begin(), file->facts.files.end());
  if (const auto error = find_output_error(options.output, inputs)) return fail_with(ExitCode::wrong_usage, *error);
  std::uint32_t clip = kNone;
  if (options.clip) {
    const auto chosen = choose_clips(file->scene, options.clip);
    if (!chosen) return fail_with(ExitCode::wrong_usage, chosen.error());
    clip = chosen->front();
  }
  auto simulation = Simulation::make(*file, clip, look_at, ground);
  if (!simulation)
    return fail_with(ExitCode::input_at_fault, fmt::format("{}: {}", visible_text(options.file), simulation.error()));
  for (const std::string& what : simulation->left_out())
    print_error(fmt::format("{}: left out: {}", visible_text(options.file), what));
  return write_frames(options, path, *simulation);
}

}  // namespace

Command simulate_command() {
  auto options = std::make_shared<SimulateOptions>();
  Command command(
      "simulate",
      "Step feet, eyes, constraints and springs of a character, and write its joints\n"
      "Springs step 60 times a second, whatever --fps is: frames between two steps are interpolated. They start at "
      "rest "
      "at time 0; the first frame is at 1/fps.\n"
      "\n"
      "OUT is JSON: {\"file\", \"fps\", \"joints\": [names], \"frames\": [{\"t\": seconds, \"q\": [[x, y, z, w], ...], "
      "\"tail\": [[x, y, z], ...]}, ...]}. For each joint, q is its local rotation, and tail is where its bone ends in "
      "the world, in metres. A joint without a spring, such as one with a constraint, has its own place as tail. With "
      "--look-at, frames also have \"gaze\": {\"yaw\", \"pitch\"} of the target in radians, > 0 to the left and down, "
      "and "
      "the weights \"left\", \"right\", \"up\", \"down\" of expressions. With --ground, joints include pelvis and "
      "legs, and frames have \"feet\", left and right: \"locked\", and the metres of \"tip\" and \"heel\" above the "
      "ground.");
  command.argument("FILE", &options->file, "A .vrm, .gltf or .glb file; - is the standard input").required();
  command
      .option("-o,--output", "OUT.json", &options->output,
              "The file to write (compressed if it ends in .gz); - is the standard output")
      .required();
  command.option("--fps", "N", &options->fps, "Frames per second (default: 60)").within(1e-3, 1e6);
  command.option("--for", "SECONDS", &options->seconds, "How long (default: 1)").within(0.0, 1e6);
  command.option(
      "--root", "PATH.json", &options->root,
      "Moves the whole character: {\"times\": [0, 0.5, ...], \"translations\": [[0, 0, 0], [1, 0, 0], ...]}, "
      "in seconds and metres, linear between times (default: it stays)");
  command.option("--look-at", "X,Y,Z", &options->look_at,
                 "A place in the world that the eyes look at, in metres (default: they look at nothing)");
  command.option("--ground", "HEIGHT|slope=DEGREES|steps=RISExTREAD|GROUND.json", &options->ground,
                 "Ground under the feet of a humanoid, in metres; slopes and steps rise along +z from the origin. "
                 "GROUND.json: {\"distances\": [0, 1], \"heights\": [0, 0.2], \"steps\": true, \"direction\": [0, 1]} "
                 "(x, z). The root is above the ground by its path (default: no ground)");
  command.option("--clip", "INDEX|NAME|none", &options->clip,
                 "Plays this clip, in a loop (default: none, the rest pose)");
  command.run = [options] { return simulate(*options); };
  return command;
}

}  // namespace sinew::tool
