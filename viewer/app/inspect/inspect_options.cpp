// SPDX-License-Identifier: MIT
#include "viewer/app/inspect/inspect_options.h"

namespace sinew::viewer {
namespace {

void read_overlays(std::string_view text, Options& options) {
  while (!text.empty()) {
    const std::size_t comma = std::min(text.find(','), text.size());
    bool* overlay = named<bool*>("--overlay", std::string(text.substr(0, comma)),
                                 {{"skeleton", &options.skeleton},
                                  {"wireframe", &options.inspected.wireframe},
                                  {"boxes", &options.inspected.boxes},
                                  {"trail", &options.inspected.trail},
                                  {"ghosts", &options.inspected.ghosts}});
    *overlay = true;
    text.remove_prefix(std::min(comma + 1, text.size()));
  }
}

}  // namespace

void add_inspect_options(CLI::App& app, Options& options) {
  auto* joint = text_option(app, "--joint", "JOINT", "look at a joint: index or name",
                            [&](const std::string& text) { options.joint = text; });
  text_option(app, "--overlay", "WHAT,...",
              "lines over the picture: skeleton, wireframe, boxes, trail (the way of --joint through the clip), ghosts "
              "(skeletons shortly before and after)",
              [&](const std::string& text) { read_overlays(text, options); });
  text_option(
      app, "--paint", "WHAT",
      "in place of materials: weights (of --joint: blue 0, green half, red 1) or uv (a checkered texture)",
      [&, joint](const std::string& text) {
        options.inspected.paint = named<Paint>("--paint", text, {{"weights", Paint::weights}, {"uv", Paint::uv}});
        if (options.inspected.paint == Paint::weights && joint->count() == 0)
          throw CLI::ValidationError("--paint", "weights are those of a joint: --joint JOINT");
      });
}

}  // namespace sinew::viewer
