// SPDX-License-Identifier: MIT
#include "importer/tool/command.h"

#include <algorithm>
#include <string_view>
#include <utility>

namespace sinew::tool {

Command::Command(std::string command, const std::string& about) : name(std::move(command)) {
  const std::size_t line = std::min(about.find('\n'), about.size());
  summary = about.substr(0, line);
  details = about.substr(std::min(line + 1, about.size()));
  option("-h,--help", "", {}, "Print this help and exit");
}

Option& Command::option(const char* names, const char* value, OptionTarget target, std::string about) {
  Option& out = options.emplace_back();
  for (std::string_view rest = names; !rest.empty();) {
    const std::size_t comma = std::min(rest.find(','), rest.size());
    out.names.emplace_back(rest.substr(0, comma));
    rest.remove_prefix(std::min(comma + 1, rest.size()));
  }
  out.value = value;
  out.target = target;
  out.about = std::move(about);
  return out;
}

Option& Command::flag(const char* names, bool& target, std::string about) {
  return option(names, "", &target, std::move(about));
}

Option& Command::argument(const char* argument_name, OptionTarget target, std::string about) {
  return option("", argument_name, target, std::move(about));
}

}  // namespace sinew::tool
