// SPDX-License-Identifier: MIT
#include "importer/tool/simulate/root_path.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>

#include <nlohmann/json.hpp>

namespace sinew::tool {
namespace {

using nlohmann::json;

constexpr const char* kForm = "is no JSON of the form {\"times\": [0, 0.5], \"translations\": [[0, 0, 0], [1, 0, 0]]}";
constexpr double kFarthest = 1e12;

std::string place(const char* list, std::size_t index) {
  return std::string("/") + list + '/' + std::to_string(index) + ": ";
}

bool is_usable(const json& value) {
  return value.is_number() && std::isfinite(value.get<double>()) && std::abs(value.get<double>()) <= kFarthest;
}

tl::expected<RootPath, std::string> read_path(const json& from) {
  const auto times = from.find("times"), translations = from.find("translations");
  if (times == from.end() || translations == from.end() || !times->is_array() || !translations->is_array())
    return tl::unexpected<std::string>(kForm);
  if (times->empty()) return tl::unexpected<std::string>("/times: is empty");
  if (times->size() != translations->size())
    return tl::unexpected("/translations: has " + std::to_string(translations->size()) + " entries for " +
                          std::to_string(times->size()) + " times");
  RootPath path;
  for (std::size_t i = 0; i < times->size(); ++i) {
    const json &time = (*times)[i], &at = (*translations)[i];
    if (!is_usable(time)) return tl::unexpected(place("times", i) + "is no number of seconds");
    if (i > 0 && time.get<double>() <= path.times_s.back())
      return tl::unexpected(place("times", i) + "is not later than the time before");
    if (!at.is_array() || at.size() != 3 || !std::all_of(at.begin(), at.end(), is_usable))
      return tl::unexpected(place("translations", i) + "is no list of three numbers");
    path.times_s.push_back(time.get<double>());
    path.translations.emplace_back(at[0].get<double>(), at[1].get<double>(), at[2].get<double>());
  }
  return path;
}

}  // namespace

Vec3<double> RootPath::at(double time_s) const {
  if (times_s.empty()) return Vec3<double>(0.0);
  const auto after = std::upper_bound(times_s.begin(), times_s.end(), time_s);
  if (after == times_s.begin()) return translations.front();
  if (after == times_s.end()) return translations.back();
  const auto i = static_cast<std::size_t>(after - times_s.begin());
  const double part = (time_s - times_s[i - 1]) / (times_s[i] - times_s[i - 1]);
  return translations[i - 1] * (1.0 - part) + translations[i] * part;
}

tl::expected<RootPath, std::string> read_root_path(const std::string& file) {
  if (!std::filesystem::is_regular_file(file)) return tl::unexpected(file + ": is no file");
  std::ifstream stream{std::filesystem::path(file)};
  const json content = json::parse(stream, nullptr, false);
  if (!content.is_object()) return tl::unexpected(file + ": " + kForm);
  auto path = read_path(content);
  if (!path) return tl::unexpected(file + ": " + path.error());
  return path;
}

}  // namespace sinew::tool
