// SPDX-License-Identifier: MIT
#include "importer/read/vertex_formats.h"

#include <algorithm>
#include <charconv>

namespace sinew {
namespace {

using gltf::ComponentType;
using gltf::ElementType;

std::optional<std::uint32_t> set_number(std::string_view digits) {
  std::uint32_t number = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  if (error != std::errc() || end != digits.data() + digits.size() || digits.empty()) return std::nullopt;
  if (digits.size() > 1 && digits.front() == '0') return std::nullopt;
  return number;
}

bool type_fits(ElementType type, Attribute attribute, bool displacement) {
  switch (attribute) {
    case Attribute::position:
    case Attribute::normal: return type == ElementType::vec3;
    case Attribute::tangent: return type == (displacement ? ElementType::vec3 : ElementType::vec4);
    case Attribute::texcoord: return type == ElementType::vec2;
    case Attribute::color: return type == ElementType::vec3 || type == ElementType::vec4;
    case Attribute::joints:
    case Attribute::weights: break;
  }
  return type == ElementType::vec4;
}

enum class Fit { no, core, quantized };

bool is_signed(ComponentType type) { return type == ComponentType::i8 || type == ComponentType::i16; }

Fit component_fit(const gltf::Accessor& accessor, Attribute attribute, bool displacement) {
  const ComponentType type = accessor.component_type;
  if (type == ComponentType::u32) return Fit::no;
  if (type == ComponentType::f32) return attribute == Attribute::joints ? Fit::no : Fit::core;
  switch (attribute) {
    case Attribute::joints: return !is_signed(type) && !accessor.normalized ? Fit::core : Fit::no;
    case Attribute::weights: return !is_signed(type) && accessor.normalized ? Fit::core : Fit::no;
    case Attribute::color: return accessor.normalized && (displacement || !is_signed(type)) ? Fit::core : Fit::no;
    case Attribute::texcoord:
      if (accessor.normalized && (displacement || !is_signed(type))) return Fit::core;
      return is_signed(type) || !displacement ? Fit::quantized : Fit::no;
    case Attribute::position: return is_signed(type) || !displacement ? Fit::quantized : Fit::no;
    case Attribute::normal:
    case Attribute::tangent: break;
  }
  return is_signed(type) && accessor.normalized ? Fit::quantized : Fit::no;
}

}  // namespace

std::optional<Semantic> parse_semantic(std::string_view name) {
  if (name == "POSITION") return Semantic{Attribute::position, 0};
  if (name == "NORMAL") return Semantic{Attribute::normal, 0};
  if (name == "TANGENT") return Semantic{Attribute::tangent, 0};
  const auto underscore = name.find('_');
  if (underscore == name.npos || underscore == 0) return std::nullopt;
  const auto number = set_number(name.substr(underscore + 1));
  if (!number) return std::nullopt;
  const std::string_view stem = name.substr(0, underscore);
  if (stem == "TEXCOORD") return Semantic{Attribute::texcoord, *number};
  if (stem == "COLOR") return Semantic{Attribute::color, *number};
  if (stem == "JOINTS") return Semantic{Attribute::joints, *number};
  if (stem == "WEIGHTS") return Semantic{Attribute::weights, *number};
  return std::nullopt;
}

bool check_vertex_format(const gltf::Document& document, std::uint32_t index, Attribute attribute, bool displacement,
                         const std::string& place, IssueLog& log) {
  const gltf::Accessor& accessor = document.accessors[index];
  const Fit fit =
      type_fits(accessor.type, attribute, displacement) ? component_fit(accessor, attribute, displacement) : Fit::no;
  if (fit == Fit::no) {
    log.report(Rule::mesh_attribute_format, place, "has a type that glTF does not allow for this attribute");
    return false;
  }
  const auto& used = document.extensions_used;
  if (fit == Fit::quantized && std::find(used.begin(), used.end(), "KHR_mesh_quantization") == used.end())
    log.report(Rule::mesh_quantization, place,
               "holds integers without KHR_mesh_quantization in extensionsUsed; read as if it were there");
  return true;
}

}  // namespace sinew
