// SPDX-License-Identifier: MIT
#include "importer/read/lights.h"

#include <array>
#include <limits>
#include <string>
#include <utility>

#include "importer/file/json_pointer.h"
#include "importer/read/json_member.h"
#include "runtime/math/conventions.h"

namespace sinew {
namespace {

using gltf::Json;

constexpr float kQuarterTurn = 1.5707964f;
constexpr float kMost = std::numeric_limits<float>::max();

class LightReader {
 public:
  LightReader(const Json& json, std::string place, IssueLog& log) : json_(json), place_(std::move(place)), log_(log) {}

  std::optional<Light> read() {
    if (!json_.is_object()) return left_out("", "is no object");
    Light light;
    if (const Json* name = member(&json_, "name"); name != nullptr && name->is_string())
      light.name = name->get<std::string>();
    const Json* type = member(&json_, "type");
    if (type == nullptr) return left_out("", "has no type");
    constexpr std::array<std::pair<const char*, Light::Kind>, 3> kKinds{
        {{"directional", Light::Kind::directional}, {"point", Light::Kind::point}, {"spot", Light::Kind::spot}}};
    const auto* kind = kKinds.begin();
    while (kind != kKinds.end() && *type != kind->first) ++kind;
    if (kind == kKinds.end())
      return left_out("/type", type->is_string() ? in_quotes(type->get<std::string>()) : "is no word");
    light.kind = kind->second;
    read_color(light.color);
    number(json_, "/intensity", 0.0f, kMost, light.intensity);
    number(json_, "/range", 0.0f, kMost, light.range_m);
    if (light.kind == Light::Kind::spot) read_cone(light);
    return light;
  }

 private:
  std::nullopt_t left_out(const char* field, const std::string& what) {
    log_.report(Rule::light_values, place_ + field, what + "; the light is left out");
    return std::nullopt;
  }

  void complain(const std::string& field, const std::string& needed) {
    log_.report(Rule::light_values, place_ + field, "is no " + needed + "; the default is used");
  }

  void read_color(glm::vec3& color) {
    const Json* value = member(&json_, "color");
    if (value == nullptr) return;
    bool good = value->is_array() && value->size() == 3;
    for (std::size_t c = 0; good && c < 3; ++c) good = is_in((*value)[c], 0.0f, kMost);
    if (!good) return complain("/color", "array of three numbers from 0 on");
    for (int c = 0; c < 3; ++c) color[c] = (*value)[static_cast<std::size_t>(c)].get<float>();
  }

  /// eq   0 <= inner < outer <= pi / 2   (KHR_lights_punctual, "spot")
  void read_cone(Light& light) {
    const Json* spot = member(&json_, "spot");
    if (spot == nullptr || !spot->is_object()) return complain(spot == nullptr ? "" : "/spot", "object with a cone");
    const Light usual;
    number(*spot, "/spot/innerConeAngle", 0.0f, kQuarterTurn, light.inner_cone_rad);
    number(*spot, "/spot/outerConeAngle", 0.0f, kQuarterTurn, light.outer_cone_rad);
    if (light.inner_cone_rad < light.outer_cone_rad) return;
    complain("/spot", "cone whose inner angle is below the outer one");
    light.inner_cone_rad = usual.inner_cone_rad;
    light.outer_cone_rad = usual.outer_cone_rad;
  }

  static bool is_in(const Json& value, float lower, float upper) {
    return value.is_number() && value.get<double>() >= lower && value.get<double>() <= upper;
  }

  void number(const Json& object, const char* field, float lower, float upper, float& out) {
    const std::string_view path(field);
    const Json* value = member(&object, field + path.rfind('/') + 1);
    if (value == nullptr) return;
    if (is_in(*value, lower, upper))
      out = value->get<float>();
    else
      complain(field, upper < kMost ? "number from 0 to a quarter turn" : "number from 0 on");
  }

  const Json& json_;
  std::string place_;
  IssueLog& log_;
};

}  // namespace

std::vector<std::optional<Light>> read_lights(const gltf::Document& document, IssueLog& log) {
  constexpr const char* kExtension = "KHR_lights_punctual";
  const Json* list = member(member(&document.extensions, kExtension), "lights");
  std::vector<std::optional<Light>> lights;
  if (list == nullptr || !list->is_array()) return lights;
  for (std::size_t i = 0; i < list->size(); ++i)
    lights.push_back(LightReader((*list)[i], pointer("extensions", kExtension, "lights", i), log).read());
  return lights;
}

}  // namespace sinew
