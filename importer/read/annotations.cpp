// SPDX-License-Identifier: MIT
#include "importer/read/annotations.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "importer/file/json_pointer.h"
#include "runtime/math/quaternion.h"

namespace sinew {
namespace {

using gltf::Json;

constexpr std::array<std::string_view, 3> kSteps = {"hold", "linear", "cubic"};   // in the order of CurveStep
constexpr std::array<std::string_view, 3> kBlends = {"mean", "sum", "heaviest"};  // in the order of CurveBlend
constexpr std::string_view kRotation = "rotation";

/// Index in `words` of the member's word. `fallback` if the member is absent; kCount if its value is not in the list.
template <std::size_t kCount>
std::size_t index_of(const Json& object, const char* member, const std::array<std::string_view, kCount>& words,
                     std::size_t fallback) {
  const auto found = object.find(member);
  if (found == object.end()) return fallback;
  std::size_t index = 0;
  while (index < kCount && !(found->is_string() && found->get_ref<const std::string&>() == words[index])) ++index;
  return index;
}

template <class V>
constexpr std::size_t kComponents = sizeof(V) / sizeof(float);
bool read(const Json& json, bool& out) {
  if (!json.is_boolean()) return false;
  out = json.get<bool>();
  return true;
}

bool read(const Json& json, float& out) {
  if (!json.is_number()) return false;
  out = static_cast<float>(json.get<double>());
  return std::isfinite(out);
}

template <class V>
bool read(const Json& json, V& out) {
  if (!json.is_array() || json.size() != kComponents<V>) return false;
  for (std::size_t c = 0; c < kComponents<V>; ++c)
    if (!read(json[c], out[static_cast<int>(c)])) return false;
  return true;
}

class AnnotationReader {
 public:
  AnnotationReader(double duration_s, IssueLog& log) : duration_s_(duration_s), log_(log) {}

  void add_event(const Json& event, const std::string& place) {
    float time_s = 0.0f;
    if (!event.is_object() || !event.contains("name") || !event["name"].is_string() || !event.contains("time") ||
        !read(event["time"], time_s))
      return leave_out(place, "is no event with a \"name\" and a \"time\" in seconds");
    const double exact_s = event["time"].get<double>();
    if (!(exact_s >= 0.0 && exact_s <= duration_s_))
      return leave_out(pointer(place, "time"), "is not within the animation");
    out.add_event(exact_s, event["name"].get<std::string>());
  }

  void add_curve(const std::string& name, const Json& curve, const std::string& place) {
    if (!curve.is_object() || !curve.contains("keys") || !curve["keys"].is_array() || curve["keys"].empty())
      return leave_out(place, "is no curve with \"keys\"");
    const std::size_t blend = index_of(curve, "blend", kBlends, 0);
    if (blend == kBlends.size()) return leave_out(pointer(place, "blend"), "is not mean, sum or heaviest");
    NamedCurve made{name, static_cast<CurveBlend>(blend), {}};
    const Json& first = curve["keys"][0];
    const Json value = first.is_object() ? first.value("value", Json()) : Json();
    const std::size_t count = value.is_array() ? value.size() : 0;
    const bool turns = curve.value("type", Json()) == kRotation;
    const std::string keys = pointer(place, "keys");
    const bool read = value.is_boolean()    ? read_keys<bool>(curve["keys"], keys, made)
                      : value.is_number()   ? read_keys<float>(curve["keys"], keys, made)
                      : count == 2          ? read_keys<glm::vec2>(curve["keys"], keys, made)
                      : count == 3          ? read_keys<glm::vec3>(curve["keys"], keys, made)
                      : count == 4 && turns ? read_keys<glm::quat>(curve["keys"], keys, made)
                      : count == 4          ? read_keys<glm::vec4>(curve["keys"], keys, made)
                                            : refuse(keys, "values are numbers, flags, or lists of 2 to 4 numbers");
    if (!read) return;
    Annotations alone;
    alone.curves.push_back(made);
    if (const ErrorCode fault = check(alone, duration_s_); fault != ErrorCode::ok)
      return leave_out(place, std::string(describe(fault)));
    out.curves.push_back(std::move(made));
  }

  void leave_out(const std::string& place, const std::string& why) {
    log_.report(Rule::animation_extras, place, why + "; it is left out");
  }

  Annotations out;

 private:
  bool refuse(const std::string& place, const char* why) {
    leave_out(place, why);
    return false;
  }

  template <class V>
  bool read_keys(const Json& list, const std::string& place, NamedCurve& out_curve) {
    std::vector<CurveKey<V>> keys;
    for (std::size_t k = 0; k < list.size(); ++k) {
      const Json& json = list[k];
      CurveKey<V> key;
      const std::size_t step =
          json.is_object() ? index_of(json, "step", kSteps, std::is_same_v<V, bool> ? 0 : 1) : kSteps.size();
      key.step = static_cast<CurveStep>(step);
      const auto has = [&](const char* member, auto& to) { return json.contains(member) && read(json[member], to); };
      if (step == kSteps.size() || !has("time", key.time_s) || !has("value", key.value) ||
          (json.contains("in") && !has("in", key.in_tangent)) || (json.contains("out") && !has("out", key.out_tangent)))
        return refuse(pointer(place, k),
                      "is no key like the first one: {\"time\", \"value\", \"step\", \"in\", \"out\"}");
      if constexpr (kIsRotation<V>) key.value = normalised(key.value);
      keys.push_back(key);
    }
    out_curve.keys = std::move(keys);
    return true;
  }

  double duration_s_;
  IssueLog& log_;
};

template <class V>
Json json_of(const V& value) {
  if constexpr (std::is_arithmetic_v<V>) {
    return value;
  } else {
    Json list = Json::array();
    for (int c = 0; c < value.length(); ++c) list.push_back(value[c]);
    return list;
  }
}

}  // namespace

Annotations read_annotations(const Json& extras, const std::string& place, double duration_s, IssueLog& log) {
  AnnotationReader reader(duration_s, log);
  if (!extras.is_object()) return {};
  if (const auto events = extras.find("events"); events != extras.end()) {
    if (!events->is_array()) reader.leave_out(pointer(place, "events"), "is no list of events");
    for (std::size_t e = 0; events->is_array() && e < events->size(); ++e)
      reader.add_event((*events)[e], pointer(place, "events", e));
  }
  if (const auto curves = extras.find("curves"); curves != extras.end()) {
    if (!curves->is_object()) reader.leave_out(pointer(place, "curves"), "is no object of curves");
    for (auto c = curves->begin(); curves->is_object() && c != curves->end(); ++c)
      reader.add_curve(c.key(), *c, pointer(place, "curves", pointer_token(c.key())));
  }
  return std::move(reader.out);
}

void set_annotations(const Annotations& annotations, Json& animation) {
  Json extras = animation.value("extras", Json::object());
  if (!extras.is_object()) extras = Json::object();
  extras.erase("events");
  extras.erase("curves");
  for (std::size_t e = 0; e < annotations.event_times_s.size(); ++e)
    extras["events"].push_back({{"time", annotations.event_times_s[e]}, {"name", annotations.event_names[e]}});
  for (const NamedCurve& curve : annotations.curves) {
    Json& out = extras["curves"][curve.name];
    out["blend"] = kBlends[static_cast<std::size_t>(curve.blend)];
    out["keys"] = Json::array();
    const auto add_keys = [&](const auto& keys) {
      for (const auto& key : keys) {
        Json json{
            {"time", key.time_s}, {"value", json_of(key.value)}, {"step", kSteps[static_cast<std::size_t>(key.step)]}};
        if (key.in_tangent != decltype(key.value){}) json["in"] = json_of(key.in_tangent);
        if (key.out_tangent != decltype(key.value){}) json["out"] = json_of(key.out_tangent);
        out["keys"].push_back(std::move(json));
      }
    };
    std::visit(add_keys, curve.keys);
    if (std::holds_alternative<std::vector<CurveKey<glm::quat>>>(curve.keys)) out["type"] = kRotation;
  }
  animation.erase("extras");
  if (!extras.empty()) animation["extras"] = std::move(extras);
}

}  // namespace sinew
