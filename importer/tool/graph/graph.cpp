// SPDX-License-Identifier: MIT
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "importer/tool/commands.h"
#include "importer/tool/files/output.h"
#include "importer/tool/graph/graph_files.h"
#include "importer/tool/graph/graph_trace.h"
#include "importer/tool/json.h"
#include "importer/tool/load_file.h"
#include "importer/tool/messages.h"

namespace sinew::tool {
namespace {

struct GraphOptions {
  std::string action, model, graph;
  std::vector<std::string> set;
  double duration_s = 5.0, fps = 30.0;
  std::optional<std::string> out;
  bool json = false;
};

std::string quoted_parameters(const GraphDefinition& graph) {
  std::string names;
  for (const GraphParameter& p : graph.tables().parameters)
    names += (names.empty() ? "" : ", ") + in_quotes(graph.tables().name_at(p.name));
  return names.empty() ? "none" : names;
}

ExitCode check_graph(const GraphOptions& options, const GraphOfModel& loaded) {
  const GraphDefinition& graph = loaded.graph;
  const GraphTables& t = graph.tables();
  if (options.json) {
    print_json({{"nodes", t.nodes.size()},
                {"clips", t.clip_names.size()},
                {"machines", t.machines.size()},
                {"states", t.states.size()},
                {"transitions", t.transitions.size()},
                {"parameters", t.parameters.size()},
                {"state_bytes", graph.state_bytes()},
                {"most_operations", graph.room().ops},
                {"most_poses", graph.room().slots}},
               false);
    return ExitCode::done;
  }
  print_result("{}: sound\n", options.graph);
  print_result("  {}, {}, {}, {}, {}\n", counted(t.nodes.size(), "node"), counted(t.clip_names.size(), "clip"),
               counted(t.machines.size(), "machine"), counted(t.states.size(), "state"),
               counted(t.transitions.size(), "transition"));
  print_result("  parameters: {}\n", quoted_parameters(graph));
  print_result("  a character's state takes {} bytes\n", graph.state_bytes());
  print_result("  a program has at most {} and {} at once\n", counted(graph.room().ops, "operation"),
               counted(graph.room().slots, "pose"));
  return ExitCode::done;
}

ExitCode trace(const GraphOptions& options, const GraphOfModel& loaded) {
  GraphScript script;
  script.duration_s = options.duration_s;
  script.fps = options.fps;
  auto settings = read_settings(options.set, loaded.graph);
  if (!settings) return fail_with(ExitCode::wrong_usage, settings.error());
  script.settings = std::move(*settings);
  if (script.duration_s * script.fps > 1e6) return fail_with(ExitCode::wrong_usage, "--for and --fps: too many frames");
  const Json result = trace_graph(loaded, script);
  if (options.json)
    print_json(result, false);
  else
    print_result("{}", trace_text(result));
  return ExitCode::done;
}

ExitCode write_new_graph(const GraphOptions& options, const Scene& scene,
                         const std::vector<std::filesystem::path>& inputs) {
  std::vector<std::string> clips;
  for (const Animation& animation : scene.animations) clips.emplace_back(animation.name);
  const auto document = new_graph(clips);
  if (!document) return fail_with(ExitCode::input_at_fault, options.model + ": " + document.error().sentence);
  const std::string text = write_graph(*document);
  const std::string out = options.graph.empty() ? "-" : options.graph;
  if (const auto error = find_output_error(out, inputs)) return fail_with(ExitCode::wrong_usage, *error);
  return write_output(out, std::as_bytes(std::span(text)));
}

ExitCode graph(const GraphOptions& options) {
  ImportOptions plain;
  plain.decode_images = plain.make_tangents = plain.make_normals = false;
  const auto model = load_file(options.model, plain);
  if (!model) return ExitCode::input_at_fault;
  if (options.action == "new") return write_new_graph(options, model->scene, model->facts.files);
  if (options.graph.empty()) return fail_with(ExitCode::wrong_usage, "graph " + options.action + ": GRAPH is missing");
  const auto loaded = load_graph(options.graph, model->scene);
  if (!loaded) return fail_with(ExitCode::input_at_fault, loaded.error());
  return options.action == "check" ? check_graph(options, *loaded) : trace(options, *loaded);
}

}  // namespace

Command graph_command() {
  auto options = std::make_shared<GraphOptions>();
  Command command(
      "graph",
      "Check, play and start motion graphs\n"
      "A motion graph is a JSON file that says how a character moves between clips: states, transitions, "
      "blend spaces and layers. `check` names what is wrong with one, by place and rule, and says how large "
      "the state of a character is. `trace` plays it without a picture and prints each frame: states with "
      "weights and times, the pose program, events, and a hash for golden tests. `new` writes a first graph "
      "from the names of the model's clips.");
  command.argument("ACTION", &options->action, "What to do").required().one_of({"check", "trace", "new"});
  command.argument("FILE", &options->model, "A .gltf or .glb file with the clips").required();
  command.argument("GRAPH", &options->graph, "The graph file; `new` writes it, or to stdout without it");
  command.option("--set", "NAME=VALUE@TIME", &options->set,
                 "trace: sets a parameter at a time in seconds (0 without @TIME); several times");
  command.option("--for", "S", &options->duration_s, "trace: seconds to play").within(0.0, 1e6);
  command.option("--fps", "N", &options->fps, "trace: frames a second").within(0.001, 1e5);
  command.flag("--json", options->json, "Print JSON");
  command.run = [options] { return graph(*options); };
  return command;
}

}  // namespace sinew::tool
