// SPDX-License-Identifier: MIT
#include <algorithm>

#include "importer/tool/help/help.h"

namespace sinew::tool {
namespace {

const Option* find_option(const Command& command, const std::string& name) {
  for (const Option& option : command.options)
    if (std::find(option.names.begin(), option.names.end(), name) != option.names.end()) return &option;
  return nullptr;
}

}  // namespace

std::string candidates(const Program& program, const std::vector<std::string>& words) {
  std::string out;
  if (words.empty()) return out;
  const std::string& typed = words.back();
  const auto offer = [&](const std::string& word, const std::string& about) {
    if (word.starts_with(typed)) out += word + (about.empty() ? "" : '\t' + about.substr(0, about.find('\n'))) + '\n';
  };
  const auto offer_options = [&](const Command& command) {
    for (const Option& option : command.options)
      for (const std::string& name : option.names) offer(name, option.about);
  };
  if (words.size() == 1) {
    for (const Command& command : program.commands) offer(command.name, command.summary);
    offer_options(program.self);
    return out;
  }
  for (const Command& command : program.commands) {
    if (command.name != words.front()) continue;
    const Option* before = words.size() > 2 ? find_option(command, words[words.size() - 2]) : nullptr;
    if (before == nullptr || before->value.empty() || !before->value_if_bare.empty()) {
      if (typed.starts_with('-')) offer_options(command);
    } else {
      const std::size_t comma = before->is_list ? typed.rfind(',') + 1 : 0;
      for (const std::string& choice : before->choices) offer(typed.substr(0, comma) + choice, "");
    }
  }
  return out;
}

}  // namespace sinew::tool
