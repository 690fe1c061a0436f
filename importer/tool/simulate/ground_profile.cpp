// SPDX-License-Identifier: MIT
#include "importer/tool/simulate/ground_profile.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <optional>
#include <string_view>
#include <system_error>

#include <nlohmann/json.hpp>

namespace sinew::tool {
namespace {

using nlohmann::json;

constexpr double kFarthestGround_m = 1e6, kSteepest_deg = 89.0;

/// Value and slope of the line through points of increasing x, flat before the first and after the last.
struct LinePoint {
  double value, slope;
};
LinePoint on_line(const std::vector<double>& x, const std::vector<double>& y, double at) {
  const auto after = std::upper_bound(x.begin(), x.end(), at);
  if (after == x.begin()) return {y.front(), 0.0};
  if (after == x.end()) return {y.back(), 0.0};
  const auto i = static_cast<std::size_t>(after - x.begin());
  const double slope = (y[i] - y[i - 1]) / (x[i] - x[i - 1]);
  return {y[i - 1] + slope * (at - x[i - 1]), slope};
}

/// A number that takes all of the text and is no larger than `most`.
std::optional<double> number_in(std::string_view text, double most) {
  double number = 0.0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || stop != text.data() + text.size() || !(std::abs(number) <= most)) return std::nullopt;
  return number;
}

/// "slope=DEGREES" or "steps=RISExTREAD".
std::optional<GroundProfile> endless_ground(std::string_view text) {
  GroundProfile out;
  if (text.starts_with("slope=")) {
    const auto degrees = number_in(text.substr(6), kSteepest_deg);
    if (!degrees) return std::nullopt;
    out.slope = std::tan(*degrees * std::numbers::pi / 180.0);
    return out;
  }
  const std::size_t by = text.find('x');
  if (!text.starts_with("steps=") || by == std::string_view::npos) return std::nullopt;
  const auto rise = number_in(text.substr(6, by - 6), kFarthestGround_m),
             tread = number_in(text.substr(by + 1), kFarthestGround_m);
  if (!rise || !tread || *tread < 0.01) return std::nullopt;
  out.rise_m = *rise;
  out.tread_m = *tread;
  return out;
}

bool is_number_list(const json& from, const char* name) {
  const auto list = from.find(name);
  return list != from.end() && list->is_array() && std::all_of(list->begin(), list->end(), [](const json& value) {
           return value.is_number() && std::abs(value.get<double>()) <= kFarthestGround_m;
         });
}

tl::expected<GroundProfile, std::string> listed_ground(const json& from) {
  if (!from.is_object() || !is_number_list(from, "distances") || !is_number_list(from, "heights"))
    return tl::unexpected<std::string>("is no JSON of the form {\"distances\": [0, 1], \"heights\": [0, 0.2]}");
  GroundProfile out;
  out.distances_m = from["distances"].get<std::vector<double>>();
  out.heights_m = from["heights"].get<std::vector<double>>();
  if (out.distances_m.empty()) return tl::unexpected<std::string>("/distances: is empty");
  if (out.distances_m.size() != out.heights_m.size())
    return tl::unexpected("/heights: has " + std::to_string(out.heights_m.size()) + " entries for " +
                          std::to_string(out.distances_m.size()) + " distances");
  for (std::size_t i = 1; i < out.distances_m.size(); ++i)
    if (!(out.distances_m[i] > out.distances_m[i - 1]))
      return tl::unexpected("/distances/" + std::to_string(i) + ": is not beyond the distance before");
  if (from.contains("steps") && !from["steps"].is_boolean())
    return tl::unexpected<std::string>("/steps: is neither true nor false");
  out.has_steps = from.value("steps", true);
  if (!from.contains("direction")) return out;
  if (!is_number_list(from, "direction") || from["direction"].size() != 2)
    return tl::unexpected<std::string>("/direction: is no list of two numbers, x and z");
  const double x = from["direction"][0].get<double>(), z = from["direction"][1].get<double>(), far = std::hypot(x, z);
  if (!(far > 0.0)) return tl::unexpected<std::string>("/direction: has no length");
  out.direction = {x / far, 0.0, z / far};
  return out;
}

}  // namespace

GroundHit GroundProfile::at(const Vec3<double>& place) const {
  const double way = place.x * direction.x + place.z * direction.z;
  LinePoint here{height_m + slope * way, slope};
  if (tread_m > 0.0) here = {rise_m * std::floor(way / tread_m), 0.0};
  if (!distances_m.empty() && !has_steps) here = on_line(distances_m, heights_m, way);
  if (!distances_m.empty() && has_steps) {
    const auto next = std::upper_bound(distances_m.begin(), distances_m.end(), way);
    here = {heights_m[static_cast<std::size_t>(std::max<std::ptrdiff_t>(next - distances_m.begin() - 1, 0))], 0.0};
  }
  const double length = std::hypot(1.0, here.slope);
  return {here.value, Vec3<double>(-here.slope * direction.x, 1.0, -here.slope * direction.z) / length};
}

double GroundProfile::body_height(const Vec3<double>& place) const {
  const double way = place.x * direction.x + place.z * direction.z;
  if (tread_m > 0.0) return rise_m * (way / tread_m - 0.5);
  if (distances_m.size() < 2 || !has_steps) return at(place).height_m;
  // The line passes the middle of each riser.
  std::vector<double> x = distances_m, y = heights_m;
  for (std::size_t i = 1; i < y.size(); ++i) y[i] = 0.5 * (heights_m[i - 1] + heights_m[i]);
  x.push_back(x.back() + 0.5 * (x.back() - x[x.size() - 2]));
  y.push_back(heights_m.back());
  return on_line(x, y, way).value;
}

Ground GroundProfile::ground() const noexcept {
  const auto find = [](void* context, std::size_t, const Vec3<double>& place, GroundHit& hit) {
    hit = static_cast<const GroundProfile*>(context)->at(place);
    return true;
  };
  return {find, const_cast<GroundProfile*>(this)};
}

tl::expected<GroundProfile, std::string> read_ground(const std::string& text) {
  GroundProfile flat;
  if (const auto height = number_in(text, kFarthestGround_m)) {
    flat.height_m = *height;
    return flat;
  }
  if (const auto endless = endless_ground(text)) return *endless;
  if (!std::filesystem::is_regular_file(text))
    return tl::unexpected(text + ": is neither a height, slope=DEGREES, steps=RISExTREAD nor a file");
  std::ifstream stream{std::filesystem::path(text)};
  auto listed = listed_ground(json::parse(stream, nullptr, false));
  if (!listed) return tl::unexpected(text + ": " + listed.error());
  return listed;
}

}  // namespace sinew::tool
