// SPDX-License-Identifier: MIT
#include "importer/tool/cost/overview/choices.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <optional>

#include <fmt/format.h>

#include "importer/platform/files.h"
#include "importer/tool/cost/overview/frame_parts.h"
#include "importer/tool/cost/words.h"
#include "importer/tool/length_text.h"

namespace sinew::cost {
namespace {

constexpr const char* kApart = "apart from linear here";  // a value of the points of the group "skinning"
constexpr std::string_view kBudget = "budget ";           // how points of the group "storage" begin that have one

/// "0.065 % of the model"
std::string of_model(double share) { return fmt::format("{} % of the model", number(100.0 * share)); }

const Group* group_named(std::span<const Group> groups, std::string_view name) {
  for (const Group& group : groups)
    if (group.name == name && !group.points.empty()) return &group;
  return nullptr;
}

double us_of(std::span<const FramePart> evaluation, std::string_view name) {
  for (const FramePart& part : evaluation)
    if (part.name == name) return part.us;
  return 0.0;
}

/// A choice between the default of a group and another point. Its error is that of the points, as shares of the model.
Choice choice_between(const Group& group, const Point& other, const char* title, double part_us, double size_m) {
  const Point& now = default_of(group);
  Choice choice;
  choice.group = group.name;
  choice.title = title;
  choice.now = now.name;
  choice.other = other.name;
  choice.us_change = now.time_ns > 0.0 ? part_us * (other.time_ns / now.time_ns - 1.0) : 0.0;
  choice.error_unit = "% of the model";
  choice.error_now = 0.1 * now.error / size_m;
  choice.error_other = 0.1 * other.error / size_m;
  return choice;
}

std::optional<Choice> skinning_choice(std::span<const Group> groups, std::span<const FramePart> evaluation,
                                      double size_m) {
  const Group* group = group_named(groups, "skinning");
  const Point* other = group == nullptr ? nullptr : find(*group, "dual quaternion");
  if (other == nullptr) return std::nullopt;
  Choice choice = choice_between(*group, *other, "Kind of skinning", us_of(evaluation, kSkinPart), size_m);
  double apart = 0.0;
  for (const Value& value : other->values)
    if (value.name == kApart) apart = 1e-3 * value.value / size_m;
  choice.error_unit = "% of a limb's volume";
  choice.error_now = default_of(*group).error;
  choice.error_other = other->error;
  choice.takes_other = apart > kSeen;
  choice.why =
      choice.takes_other
          ? fmt::format(
                "The kinds put vertices up to {} apart, which is seen: dual quaternions keep the volume "
                "of limbs that bend and twist.",
                of_model(apart))
          : fmt::format("Limbs hardly bend or twist here: the kinds put vertices at most {} apart.", of_model(apart));
  return choice;
}

/// The point of a budget with the fewest bytes whose error is hardly seen; null if none has fewer than the keys as they
/// are.
const Point* best_budget(const Group& group, double size_m) {
  const Point* best = nullptr;
  for (const Point& point : group.points)
    if (point.name.starts_with(kBudget) && point.error <= 1e3 * kHardlySeen * size_m &&
        group.cost_of(point) < group.cost_of(best == nullptr ? default_of(group) : *best))
      best = &point;
  return best;
}

std::optional<Choice> storage_choice(std::span<const Group> groups, std::span<const FramePart> evaluation,
                                     double size_m) {
  const Group* group = group_named(groups, "storage");
  if (group == nullptr) return std::nullopt;
  const Point* best = best_budget(*group, size_m);
  const Point* shown = best != nullptr ? best : find(*group, "16 bits");
  if (shown == nullptr) return std::nullopt;
  Choice choice = choice_between(*group, *shown, "Storage of keys", us_of(evaluation, kSamplePart), size_m);
  choice.size_ratio = group->cost_of(*shown) / group->cost_of(default_of(*group));
  choice.takes_other = best != nullptr;
  if (best != nullptr)
    if (const auto budget = tool::parse_length(best->name.substr(kBudget.size())))
      choice.budget = 100.0 * budget->metres / size_m;
  choice.why = best == nullptr
                   ? fmt::format("No budget within {} makes this clip smaller.", of_model(kHardlySeen))
                   : fmt::format("No vertex is farther off than {}.", of_model(1e-3 * best->error / size_m));
  return choice;
}

/// The way to compare with the default: the cheapest that is hardly seen, or else the most accurate that is cheaper.
const Point* other_way(const Group& group, double size_m) {
  const Point& now = default_of(group);
  const Point* best = cheapest_within(group, 1e3 * kHardlySeen * size_m);
  if (best != nullptr && best != &now) return best;
  const Point* cheapest = nullptr;
  for (const Point& point : group.points)
    if (&point != &now && !point.other_aim && point.pareto && point.time_ns < now.time_ns &&
        (cheapest == nullptr || point.error < cheapest->error))
      cheapest = &point;
  return cheapest;
}

std::optional<Choice> time_choice(const Group& group, const char* title, double part_us, double size_m) {
  const Point* other = other_way(group, size_m);
  if (other == nullptr || group.error_unit != "mm") return std::nullopt;
  Choice choice = choice_between(group, *other, title, part_us, size_m);
  const double seen = 1e-3 * other->error / size_m;
  choice.takes_other = seen <= kHardlySeen;
  choice.why = choice.takes_other
                   ? fmt::format("It saves time, and is off by at most {}, which is hardly seen.", of_model(seen))
                   : fmt::format("Whatever is cheaper is seen: {} is off by up to {}.", other->name, of_model(seen));
  return choice;
}

}  // namespace

std::vector<Choice> find_choices(std::span<const Group> groups, std::span<const FramePart> evaluation, double size_m) {
  std::vector<Choice> choices;
  if (auto skinning = skinning_choice(groups, evaluation, size_m)) choices.push_back(std::move(*skinning));
  if (auto storage = storage_choice(groups, evaluation, size_m)) choices.push_back(std::move(*storage));
  struct Timed {
    const char *group, *title, *part;
  };
  constexpr std::array kTimed = {Timed{"influences", "Influences of a vertex", kSkinPart},
                                 Timed{"rotation", "Interpolation of rotations", kSamplePart},
                                 Timed{"morphing", "Morph targets", kMorphPart}};
  std::optional<Choice> largest;
  for (const Timed& timed : kTimed) {
    const Group* group = group_named(groups, timed.group);
    auto choice =
        group == nullptr ? std::nullopt : time_choice(*group, timed.title, us_of(evaluation, timed.part), size_m);
    if (choice && (!largest || std::abs(choice->us_change) > std::abs(largest->us_change))) largest = std::move(choice);
  }
  if (largest) choices.push_back(std::move(*largest));
  return choices;
}

std::string recommended_command(std::span<const Choice> choices, std::span<const Group> groups,
                                const std::string& file) {
  const auto takes = [&](std::string_view group) {
    const auto found = std::find_if(choices.begin(), choices.end(), [&](const Choice& c) { return c.group == group; });
    return found != choices.end() && found->takes_other ? &*found : nullptr;
  };
  const auto quoted = [](const std::string& name) {
    return name.find_first_of(" '\"$&()") == std::string::npos ? name : "'" + name + "'";
  };
  const std::string out = quoted(platform::text_of(platform::path_of(file).filename().replace_extension(".sinew")));
  const Choice* stored = takes("storage");
  const std::string budget = stored != nullptr && stored->budget ? number(*stored->budget) + "%" : "0";
  std::string command = fmt::format("sinew compile {} --budget {} -o {}", quoted(file), budget, out);
  if (group_named(groups, "skinning") != nullptr)
    command += fmt::format("\nsinew-viewer {} --skinning {}", out,
                           takes("skinning") == nullptr ? "linear" : "dual-quaternion");
  return command;
}

}  // namespace sinew::cost
