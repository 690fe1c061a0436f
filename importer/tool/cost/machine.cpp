// SPDX-License-Identifier: MIT
#include "importer/tool/cost/machine.h"

#include <sys/utsname.h>

#include <cstdlib>
#include <ctime>
#include <fstream>
#include <thread>

#include <fmt/format.h>

#include "importer/tool/cost/instruction_sets.h"

namespace sinew::cost {
namespace {

std::string processor() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);)
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  return "unknown";
}

std::string system_name() {
  utsname name{};
  return uname(&name) == 0 ? fmt::format("{} {} {}", name.sysname, name.release, name.machine) : "unknown";
}

std::string load_now() {
  double load = 0.0;
  return getloadavg(&load, 1) == 1 ? fmt::format("{:.1f}", load) : "unknown";
}

std::string date_now() {
  const std::time_t now = std::time(nullptr);
  std::tm utc{};
  gmtime_r(&now, &utc);
  return fmt::format("{:04}-{:02}-{:02}", utc.tm_year + 1900, utc.tm_mon + 1, utc.tm_mday);
}

std::string compiler() {
#ifdef __clang__
  return "clang " __clang_version__;
#else
  return "g++ " __VERSION__;
#endif
}

}  // namespace

std::vector<std::pair<std::string, std::string>> describe_machine() {
  const InstructionSet best = instruction_sets().front();
  return {{"processor", processor()},
          {"cores", std::to_string(std::thread::hardware_concurrency())},
          {"load while measuring", load_now()},
          {"system", system_name()},
          {"compiler", compiler()},
          {"build", SINEW_BUILD_TYPE},
          {"instructions", fmt::format("{}, {} floats wide", best.name, best.float_lanes)},
          {"sinew", SINEW_VERSION},
          {"measured on", date_now()}};
}

}  // namespace sinew::cost
