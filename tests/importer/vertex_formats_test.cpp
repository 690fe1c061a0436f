// SPDX-License-Identifier: MIT
// Every type of every attribute and displacement, compared with the tables of glTF 2.0 and KHR_mesh_quantization.
#include "importer/read/vertex_formats.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace sinew::test {
namespace {

using gltf::ComponentType;
using gltf::ElementType;
using Names = std::set<std::string>;

constexpr std::pair<ComponentType, const char*> kComponents[] = {
    {ComponentType::i8, "i8"},   {ComponentType::u8, "u8"},   {ComponentType::i16, "i16"},
    {ComponentType::u16, "u16"}, {ComponentType::u32, "u32"}, {ComponentType::f32, "f32"}};
constexpr ElementType kElements[] = {ElementType::scalar, ElementType::vec2, ElementType::vec3, ElementType::vec4,
                                     ElementType::mat2,   ElementType::mat3, ElementType::mat4};

/// Allowed formats; a trailing "n" means normalised integers.
struct Row {
  Attribute attribute;
  bool displacement;
  std::set<ElementType> elements;
  Names core, quantized;
};
const Row kRows[] = {
    {Attribute::position,
     false,
     {ElementType::vec3},
     {"f32"},
     {"i8", "i8n", "u8", "u8n", "i16", "i16n", "u16", "u16n"}},
    {Attribute::normal, false, {ElementType::vec3}, {"f32"}, {"i8n", "i16n"}},
    {Attribute::tangent, false, {ElementType::vec4}, {"f32"}, {"i8n", "i16n"}},
    {Attribute::texcoord,
     false,
     {ElementType::vec2},
     {"f32", "u8n", "u16n"},
     {"i8", "i8n", "u8", "i16", "i16n", "u16"}},
    {Attribute::color, false, {ElementType::vec3, ElementType::vec4}, {"f32", "u8n", "u16n"}, {}},
    {Attribute::joints, false, {ElementType::vec4}, {"u8", "u16"}, {}},
    {Attribute::weights, false, {ElementType::vec4}, {"f32", "u8n", "u16n"}, {}},
    {Attribute::position, true, {ElementType::vec3}, {"f32"}, {"i8", "i8n", "i16", "i16n"}},
    {Attribute::normal, true, {ElementType::vec3}, {"f32"}, {"i8n", "i16n"}},
    {Attribute::tangent, true, {ElementType::vec3}, {"f32"}, {"i8n", "i16n"}},
    {Attribute::texcoord, true, {ElementType::vec2}, {"f32", "i8n", "u8n", "i16n", "u16n"}, {"i8", "i16"}},
    {Attribute::color, true, {ElementType::vec3, ElementType::vec4}, {"f32", "i8n", "u8n", "i16n", "u16n"}, {}}};

/// "fits" if the format is allowed, the rule of the warning, or "no".
std::string fit_of(const Row& row, ElementType element, ComponentType component, bool normalized, bool declared) {
  gltf::Document document;
  document.accessors.resize(1);
  document.accessors[0].type = element;
  document.accessors[0].component_type = component;
  document.accessors[0].normalized = normalized;
  if (declared) document.extensions_used = {"KHR_mesh_quantization"};
  IssueLog log;
  const bool fits = check_vertex_format(document, 0, row.attribute, row.displacement, "/here", log);
  const auto warnings = log.take_warnings();
  EXPECT_EQ(fits, log.ok());
  if (!fits) return "no";
  return warnings.empty() ? "fits" : warnings[0].rule;
}

TEST(vertex_formats, are_those_of_the_tables) {
  for (const Row& row : kRows)
    for (const ElementType element : kElements)
      for (const auto& [component, name] : kComponents)
        for (const bool normalized : {false, true}) {
          const std::string type = name + std::string(normalized ? "n" : "");
          // glTF never normalises floats and 32-bit integers.
          if (normalized && (component == ComponentType::f32 || component == ComponentType::u32)) continue;
          const bool right = row.elements.contains(element);
          const std::string context = std::to_string(static_cast<int>(row.attribute)) + ' ' + type + ' ' +
                                      std::to_string(static_cast<int>(element)) + (row.displacement ? " moved" : "");
          const bool core = right && row.core.contains(type), quantized = right && row.quantized.contains(type);
          EXPECT_EQ(fit_of(row, element, component, normalized, true), core || quantized ? "fits" : "no") << context;
          EXPECT_EQ(fit_of(row, element, component, normalized, false), core        ? "fits"
                                                                        : quantized ? "mesh-quantization"
                                                                                    : "no")
              << context;
        }
}

TEST(vertex_formats, names_of_attributes_have_a_number_where_there_may_be_several) {
  const auto parsed = [](const char* name) {
    const auto semantic = parse_semantic(name);
    return semantic ? std::to_string(static_cast<int>(semantic->attribute)) + ' ' + std::to_string(semantic->set)
                    : "none";
  };
  EXPECT_EQ(parsed("POSITION"), "0 0");
  EXPECT_EQ(parsed("NORMAL"), "1 0");
  EXPECT_EQ(parsed("TANGENT"), "2 0");
  EXPECT_EQ(parsed("TEXCOORD_0"), "3 0");
  EXPECT_EQ(parsed("COLOR_1"), "4 1");
  EXPECT_EQ(parsed("JOINTS_10"), "5 10");
  EXPECT_EQ(parsed("WEIGHTS_4294967295"), "6 4294967295");
  for (const char* name :
       {"", "_", "_0", "POSITION_0", "NORMAL_1", "TEXCOORD", "TEXCOORD_", "TEXCOORD_00", "TEXCOORD_01", "TEXCOORD_-1",
        "TEXCOORD_1x", "TEXCOORD_4294967296", "COLORS_0", "_TEXCOORD_0", "texcoord_0", "JOINTS0", "WEIGHTS_ 1"})
    EXPECT_EQ(parsed(name), "none") << name;
}

}  // namespace
}  // namespace sinew::test
