// SPDX-License-Identifier: MIT
#include "importer/tool/commands.h"

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

using MakeCommand = Command (*)();

constexpr MakeCommand kCommands[] = {
    info_command,     sample_command,  verify_command,   check_command, plan_command, convert_command, import_command,
    retarget_command, compile_command, simulate_command, graph_command, bake_command, batch_command,
#ifdef SINEW_WITH_RAYS
    bake_ao_command,
#endif
#ifdef SINEW_WITH_COST
    cost_command,
#endif
};

std::vector<LeftOutCommand> left_out_commands() {
  std::vector<LeftOutCommand> out;
#ifndef SINEW_WITH_RAYS
  out.push_back({"bake-ao", "it was made without Embree"});
#endif
#ifndef SINEW_WITH_COST
  out.push_back({"cost", "it was made without the option SINEW_COST"});
#endif
  return out;
}

}  // namespace

Program make_program() {
  Program program{Command("", kAbout), std::string("sinew ") + SINEW_VERSION, kEnding, {}, left_out_commands()};
  program.self.option("--version", "", {}, "Print the version and exit");
  for (const MakeCommand make : kCommands) program.commands.push_back(make());
  for (const LeftOutCommand& command : program.left_out)
    program.ending += "\n\nThis build has no `sinew " + command.name + "`: " + command.reason + '.';
  return program;
}

}  // namespace sinew::tool
