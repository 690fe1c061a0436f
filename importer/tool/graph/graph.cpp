// SPDX-License-Identifier: MIT
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "importer/graph/graph_files.h"
#include "importer/graph/graph_setting.h"
#include "importer/platform/files.h"
#include "importer/tool/commands.h"
#include "importer/tool/files/output.h"
#include "importer/tool/graph/golden_trace.h"
#include "importer/tool/graph/graph_trace.h"
#include "importer/tool/graph/program_rows.h"
#include "importer/tool/json.h"
#include "importer/tool/load_file.h"
#include "importer/tool/messages.h"

namespace sinew::tool {
namespace {

struct GraphOptions {
  std::string action, model, graph, variation;
  std::vector<std::string> set;
  double duration_s = 5.0, fps = 30.0;
  std::optional<std::string> out;
  bool json = false;
};

std::string quoted_parameters(const GraphDefinition& graph) {
  std::string names;
  const auto& parameters = graph.tables().parameters;
  for (std::size_t p = 0; p < parameters.size(); ++p)
    names += (names.empty() ? "" : ", ") + in_quotes(graph.tables().name_at(parameters[p].name)) +
             (graph.is_computed(static_cast<GraphIndex>(p)) ? " (computed)" : "");
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
  for (std::size_t f = 1; f < loaded.source.files.size(); ++f) print_result("  with {}\n", loaded.source.files[f]);
  print_result("  {}, {}, {}, {}, {}\n", counted(t.nodes.size(), "node"), counted(t.clip_names.size(), "clip"),
               counted(t.machines.size(), "machine"), counted(t.states.size(), "state"),
               counted(t.transitions.size(), "transition"));
  print_result("  parameters: {}\n", quoted_parameters(graph));
  print_result("  a character's state takes {} bytes\n", graph.state_bytes());
  print_result("  a program has at most {} and {} at once\n", counted(graph.room().ops, "operation"),
               counted(graph.room().slots, "pose"));
  return ExitCode::done;
}

/// Reads the settings of --set.
/// err  a sentence for the user
tl::expected<std::vector<GraphSetting>, std::string> read_settings(const std::vector<std::string>& texts,
                                                                   const GraphDefinition& graph) {
  std::vector<GraphSetting> settings;
  for (const std::string& text : texts) {
    auto setting = parse_graph_setting(text);
    if (!setting) return tl::unexpected("--set: " + setting.error());
    settings.push_back(std::move(*setting));
  }
  return settings_for(graph, std::move(settings));
}

/// Writes a golden trace, which names the graph as it is seen from there.
ExitCode write_golden(const GraphOptions& options, const GraphOfModel& loaded, const Json& trace) {
  std::vector<std::filesystem::path> inputs = {platform::path_of(options.model)};
  for (const std::string& file : loaded.source.files) inputs.push_back(platform::path_of(file));
  if (const auto error = find_output_error(*options.out, inputs)) return fail_with(ExitCode::wrong_usage, *error);
  TraceDocument golden{options.graph,      options.variation, options.set,
                       options.duration_s, options.fps,       trace_lines(loaded, trace)};
  if (*options.out != "-") {
    std::error_code error;
    const auto folder = std::filesystem::absolute(platform::path_of(*options.out), error).parent_path();
    const auto graph = std::filesystem::absolute(platform::path_of(options.graph), error).lexically_proximate(folder);
    golden.graph = platform::text_of(std::filesystem::path(graph.generic_u8string()));
  }
  const std::string text = golden_trace_text(golden);
  return write_output(*options.out, std::as_bytes(std::span(text)));
}

/// The script that the options describe.
/// err  a sentence for the user
tl::expected<GraphScript, std::string> script_of(const GraphOptions& options, const GraphDefinition& graph) {
  auto settings = read_settings(options.set, graph);
  if (!settings) return tl::unexpected(settings.error());
  if (options.duration_s * options.fps > 1e6) return tl::unexpected(std::string("--for and --fps: too many frames"));
  return GraphScript{std::move(*settings), options.duration_s, options.fps};
}

/// Lists the operations of the program that the graph writes at the end of the script.
ExitCode plan_program(const GraphOptions& options, const GraphOfModel& loaded, const Scene& scene) {
  const auto script = script_of(options, loaded.graph);
  if (!script) return fail_with(ExitCode::wrong_usage, script.error());
  GraphMoment moment = play_graph(loaded, *script);
  ProgramOfModel program{{}, std::move(moment.program), loaded.masks};
  for (const auto& [name, joints] : loaded.source.document().masks) program.document.masks[name];
  Needs needs;
  add_program(program, scene, needs);
  const Plan plan = compile_plan(lend(scene), needs);
  const std::vector<ProgramRow> rows = program_rows(plan, program, true);
  if (options.json) {
    print_json({{"time_s", moment.time_s}, {"states", moment.states}, {"operations", program_json(rows, true)}}, false);
    return ExitCode::done;
  }
  print_result("{} at {:g} s\n", options.graph, moment.time_s);
  for (const Json& state : moment.states)
    print_result("  {}:{} {:.3f} for {:.3f} s\n", state["machine"].get<std::string>(),
                 state["state"].get<std::string>(), state["weight"].get<double>(), state["time_s"].get<double>());
  print_result("{}", program_text(rows, true));
  return ExitCode::done;
}

ExitCode trace(const GraphOptions& options, const GraphOfModel& loaded) {
  const auto script = script_of(options, loaded.graph);
  if (!script) return fail_with(ExitCode::wrong_usage, script.error());
  const Json result = trace_graph(loaded, *script);
  if (options.out) return write_golden(options, loaded, result);
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

/// `dot` and `diff`, which need no model.
ExitCode read_alone(const GraphOptions& options) {
  const auto first = read_graph_alone(options.model);
  if (!first) return fail_with(ExitCode::input_at_fault, first.error());
  if (options.action == "dot") {
    print_result("{}", draw_graph(*first));
    return ExitCode::done;
  }
  if (options.graph.empty()) return fail_with(ExitCode::wrong_usage, "graph diff: the second graph is missing");
  const auto second = read_graph_alone(options.graph);
  if (!second) return fail_with(ExitCode::input_at_fault, second.error());
  const std::vector<std::string> differences = compare_graphs(*first, *second);
  for (const std::string& difference : differences) print_result("{}\n", difference);
  return differences.empty() ? ExitCode::done : ExitCode::input_at_fault;
}

ExitCode graph(const GraphOptions& options) {
  if (options.action == "dot" || options.action == "diff") return read_alone(options);
  ImportOptions plain;
  plain.decode_images = plain.make_tangents = plain.make_normals = false;
  const auto model = load_file(options.model, plain);
  if (!model) return ExitCode::input_at_fault;
  if (options.action == "new") return write_new_graph(options, model->scene, model->facts.files);
  if (options.graph.empty()) return fail_with(ExitCode::wrong_usage, "graph " + options.action + ": GRAPH is missing");
  const auto loaded = load_graph(options.graph, model->scene, {.variation = options.variation});
  if (!loaded) return fail_with(ExitCode::input_at_fault, loaded.error());
  if (options.action == "plan") return plan_program(options, *loaded, model->scene);
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
      "weights and times, the pose program, events, and a hash for golden tests; with -o a golden trace, which `sinew "
      "verify` compares. `plan` plays it to the end of --for and lists the operations of the pose program there, each "
      "with its reason, its share and its microseconds. `new` writes a first graph "
      "from the names of the model's clips. `diff` says in words how two graph files differ, and ends with 1 if they "
      "do. `dot` draws one for GraphViz: `sinew graph dot walk.json | dot -Tsvg -o walk.svg`.");
  command.argument("ACTION", &options->action, "What to do")
      .required()
      .one_of({"check", "trace", "plan", "new", "diff", "dot"});
  command.argument("FILE", &options->model, "A .gltf or .glb file with the clips; for diff and dot a graph file")
      .required();
  command.argument("GRAPH", &options->graph,
                   "The graph file; `new` writes it, or to stdout without it; for diff the newer one");
  command.option("--set", "NAME=VALUE@TIME", &options->set,
                 "trace, plan: sets a parameter at a time in seconds (0 without @TIME); several times");
  command.option("--variation", "NAME", &options->variation,
                 "check, trace, plan: play the clips of a variation of the graph");
  command.option("--for", "S", &options->duration_s, "trace, plan: seconds to play").within(0.0, 1e6);
  command.option("--fps", "N", &options->fps, "trace, plan: frames a second").within(0.001, 1e5);
  command.option("-o,--output", "FILE", &options->out, "trace: write a golden trace instead");
  command.flag("--json", options->json, "Print JSON");
  command.run = [options] { return graph(*options); };
  return command;
}

}  // namespace sinew::tool
