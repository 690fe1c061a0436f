// SPDX-License-Identifier: MIT
#include "importer/tool/help/program_text.h"

#include <map>
#include <memory>
#include <string>

#include <fmt/format.h>

#include "importer/tool/help/completions.h"
#include "importer/tool/help/help_formatter.h"
#include "importer/tool/help/man_page.h"

namespace sinew::tool {
namespace {

constexpr const char* kAbout =
    "keyframe animation and skinning of glTF files (.gltf, .glb)\n"
    "What files hold, what is wrong with them, and where every joint and vertex is at any time of their clips.";

constexpr const char* kEnding =
    "`sinew COMMAND --help` explains one command. Examples:\n"
    "  sinew info fox.glb                                  what is inside\n"
    "  sinew check fox.glb                                 every rule that the file breaks\n"
    "  sinew sample fox.glb --clip Walk --fps 30 -o walk.json\n"
    "  sinew verify fox.glb walk.json                      fails when a pose has moved since\n"
    "  sinew plan fox.glb                                  which stages a frame runs, and why\n"
    "  sinew convert fox.gltf fox.glb --budget 0.1mm       with as few keys as keep every vertex there\n"
    "  sinew compile fox.glb -o fox.sinew --budget 0.01%   clips for playback, within a budget\n"
    "  sinew bake fox.glb --clip Walk -o walk.sgeo         every vertex of every frame\n"
    "  sinew cost fox.glb -o costs/                        what accuracy costs in time, with charts\n\n"
    "Results go to stdout, messages to stderr.\n\n"
    "Exit status: 0 done, 1 the input is at fault, 2 wrong usage, 3 the machine lacks something, "
    "4 `sinew verify` cannot read a file. Of several files the worst counts.";

using Generator = std::string (*)(const CLI::App&);
const std::map<std::string, Generator> kGenerators = {
    {"man", man_page}, {"bash", bash_completion}, {"zsh", zsh_completion}, {"fish", fish_completion}};

}  // namespace

void describe_program(CLI::App& program) {
  program.description(kAbout);
  program.footer(kEnding);
  program.set_version_flag("--version", std::string("sinew ") + SINEW_VERSION, "Print the version and exit");
  program.set_help_flag("-h,--help", "Print this help and exit");
  program.formatter(std::make_shared<HelpFormatter>());
}

void add_generate(CLI::App& program) {
  const auto print = [&program](const std::string& kind) {
    const auto generator = kGenerators.find(kind);
    if (generator == kGenerators.end()) throw CLI::ValidationError("--generate", "man, bash, zsh or fish");
    fmt::print("{}", generator->second(program));
    throw CLI::Success();
  };
  program.add_option_function<std::string>("--generate", print)->group("");
}

}  // namespace sinew::tool
