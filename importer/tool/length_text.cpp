// SPDX-License-Identifier: MIT
#include "importer/tool/length_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <numbers>

#include <fmt/core.h>

namespace sinew::tool {
namespace {

struct Unit {
  const char* name;
  double metres;
};
constexpr Unit kUnits[] = {{"m", 1.0}, {"cm", 1e-2}, {"mm", 1e-3}, {"um", 1e-6}};

struct NumberWithUnit {
  double number = 0.0;
  std::string_view unit;
};

/// Splits a text into number and unit.     err   why the text is no number >= 0, as the end of a sentence
tl::expected<NumberWithUnit, const char*> split(std::string_view text) {
  NumberWithUnit out;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), out.number);
  if (error != std::errc() || !std::isfinite(out.number))
    return tl::unexpected<const char*>("is not a number with a unit");
  if (out.number < 0.0) return tl::unexpected<const char*>("is negative");
  out.unit = std::string_view(end, static_cast<std::size_t>(text.data() + text.size() - end));
  out.unit.remove_prefix(std::min(out.unit.find_first_not_of(' '), out.unit.size()));
  return out;
}

}  // namespace

tl::expected<Length, std::string> parse_length(std::string_view text) {
  const auto refuse = [&](const char* why) {
    return tl::unexpected(fmt::format(
        "\"{}\" {}; lengths look like 0.1mm, 1cm, 0.001m, 50um, 1e-4 (metres) or 0.01% (of the model)", text, why));
  };
  const auto parts = split(text);
  if (!parts) return refuse(parts.error());
  const auto& [number, unit] = *parts;
  if (unit.empty()) return Length{number};
  if (unit == "%") return Length{0.0, number / 100.0};
  for (const Unit& known : kUnits)
    if (unit == known.name) return Length{number * known.metres};
  return refuse("has a unit that is not m, cm, mm, um or %");
}

tl::expected<double, std::string> parse_angle(std::string_view text) {
  const auto parts = split(text);
  const bool degrees = parts && (parts->unit == "deg" || parts->unit.empty());
  const double radians = !parts ? -1.0 : degrees ? parts->number * std::numbers::pi / 180.0 : parts->number;
  if ((degrees || (parts && parts->unit == "rad")) && radians <= std::numbers::pi) return radians;
  return tl::unexpected(
      fmt::format("\"{}\" is no angle from 0 to 180deg; angles look like 1deg, 0.5 (degrees) or 0.01rad", text));
}

tl::expected<double, std::string> parse_ratio(std::string_view text) {
  const auto parts = split(text);
  if (parts && parts->unit.empty()) return parts->number;
  if (parts && parts->unit == "%") return parts->number / 100.0;
  return tl::unexpected(fmt::format("\"{}\" is no number of 0 or more; it looks like 0.001 or 0.1%", text));
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
