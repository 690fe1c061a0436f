// SPDX-License-Identifier: MIT
#include "importer/tool/length_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>

#include <fmt/core.h>

namespace sinew::tool {
namespace {

struct Unit {
  const char* name;
  double metres;
};
constexpr Unit kUnits[] = {{"m", 1.0}, {"cm", 1e-2}, {"mm", 1e-3}, {"um", 1e-6}};

}  // namespace

tl::expected<Length, std::string> parse_length(std::string_view text) {
  const auto refuse = [&](const char* why) {
    return tl::unexpected(fmt::format(
        "\"{}\" {}; lengths look like 0.1mm, 1cm, 0.001m, 50um, 1e-4 (metres) or 0.01% (of the model)", text, why));
  };
  double number = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || !std::isfinite(number)) return refuse("is not a number with a unit");
  if (number < 0.0) return refuse("is negative");
  std::string_view unit(end, static_cast<std::size_t>(text.data() + text.size() - end));
  unit.remove_prefix(std::min(unit.find_first_not_of(' '), unit.size()));
  if (unit.empty()) return Length{number};
  if (unit == "%") return Length{0.0, number / 100.0};
  for (const Unit& known : kUnits)
    if (unit == known.name) return Length{number * known.metres};
  return refuse("has a unit that is not m, cm, mm, um or %");
}

std::string length_text(double metres) {
  if (metres == 0.0) return "0";
  const Unit* unit = std::begin(kUnits);
  if (metres < 1e-4)
    unit = &kUnits[3];
  else if (metres < 1.0)
    unit = &kUnits[2];
  return fmt::format("{:.3g} {}", metres / unit->metres, unit->name);
}

}  // namespace sinew::tool
