// SPDX-License-Identifier: MIT
#include "viewer/app/motion_options.h"

#include <utility>

#include "viewer/app/option_text.h"

namespace sinew::viewer {
namespace {

/// An option that may be given several times; `read` gets each of its arguments.
template <class Read>
CLI::Option* repeated_option(CLI::App& app, const char* name, const char* type, const char* what, Read read) {
  return app
      .add_option_function<std::vector<std::string>>(
          name,
          [name, read](const std::vector<std::string>& texts) {
            for (const std::string& text : texts) {
              const auto done = read(text);
              if (!done) throw CLI::ValidationError(name, done.error());
            }
          },
          what)
      ->type_name(type)
      ->expected(1)
      ->allow_extra_args(false)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

}  // namespace

void add_motion_options(CLI::App& app, Options& options, CLI::Option* file) {
  auto* layer = repeated_option(
      app, "--layer", "CLIP,...",
      "lay a clip over the chosen one, in step with it: CLIP[,weight=W][,mask=JOINT][,mirror][,add or ,add-start]; "
      "several times, the last on top",
      [&](const std::string& text) {
        return parse_layer(text).map([&](LayerText parsed) { options.layers.push_back(std::move(parsed)); });
      });
  layer->needs(file);
  app.add_flag("--mirror", options.mirrored, "play the clip with left and right exchanged");
  text_option(app, "--root", "HOW",
              "the motion of the root: clip (back to the start in each round), in-place, or moving on (clip)",
              [&](const std::string& text) {
                options.root = named<RootPlay>(
                    "--root", text,
                    {{"clip", RootPlay::as_in_clip}, {"in-place", RootPlay::in_place}, {"moving", RootPlay::moving}});
              });
  text_option(app, "--fade", "SECONDS", "cross-fade to another clip chosen in the window (0)",
              [&](const std::string& text) {
                const auto seconds = number<float>(text);
                if (!seconds || *seconds < 0.0f || *seconds > 60.0f)
                  throw CLI::ValidationError("--fade", "'" + text + "' is not a time of 0 to 60 seconds");
                options.fade_s = *seconds;
              });
  app.add_flag_callback(
      "--no-springs", [&] { options.springs = false; }, "hold springs and constraints of a VRM file still");
  auto* graph = app.add_option("--graph", options.graph, "let a motion graph (JSON, see `sinew graph`) drive FILE")
                    ->type_name("GRAPH");
  graph->needs(file);
  repeated_option(app, "--set", "NAME=V@T",
                  "set a parameter of the graph to V at second T (0 without @T); several times",
                  [&](const std::string& text) {
                    return parse_graph_setting(text).map(
                        [&](GraphSetting setting) { options.graph_script.push_back(std::move(setting)); });
                  })
      ->needs(graph);
}

}  // namespace sinew::viewer
