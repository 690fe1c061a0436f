// SPDX-License-Identifier: MIT
#include "importer/file/core_text.h"

#include <cstdint>
#include <string_view>

#include <rapidjson/stringbuffer.h>
#include <rapidjson/writer.h>

#include "importer/file/gltf_shape.h"
#include "importer/file/json_shape.h"

namespace sinew {
namespace {

constexpr std::size_t kSliceBytes = 2048;

using Text = rapidjson::GenericStringBuffer<rapidjson::UTF8<>, JsonMemory>;
using Writer = rapidjson::Writer<Text, rapidjson::UTF8<>, rapidjson::UTF8<>, JsonMemory>;

void write_name(std::string_view name, Writer& out) {
  out.Key(name.data(), static_cast<rapidjson::SizeType>(name.size()));
}

void write_value(const JsonNode& value, const JsonValueShape& shape, Writer& out);

/// Omits members named `indices`: among the written lists, only primitives have them.
void write_object(const JsonNode& value, const JsonObjectShape& shape, Writer& out) {
  out.StartObject();
  for (const JsonProperty& property : shape.properties) {
    if (property.value.kind == JsonKind::extensions || property.name == "indices") continue;
    const JsonNode* found = find_member(value, property.name);
    if (found == nullptr) continue;
    write_name(property.name, out);
    write_value(*found, property.value, out);
  }
  out.EndObject();
}

void write_map(const JsonNode& value, const JsonValueShape& shape, Writer& out) {
  out.StartObject();
  for (const auto& [key, entry] : value.GetObject()) {
    const std::string_view name = text_of(key);
    if (name.find('\0') != name.npos) continue;
    write_name(name, out);
    write_value(entry, *shape.element, out);
  }
  out.EndObject();
}

void write_array(const JsonNode& value, const JsonValueShape& shape, Writer& out) {
  out.StartArray();
  for (const JsonNode& entry : value.GetArray()) write_value(entry, *shape.element, out);
  out.EndArray();
}

void write_value(const JsonNode& value, const JsonValueShape& shape, Writer& out) {
  switch (shape.kind) {
    case JsonKind::integer: out.Uint64(static_cast<std::uint64_t>(value.GetDouble())); return;
    case JsonKind::object: return write_object(value, *shape.object, out);
    case JsonKind::index_map: return write_map(value, shape, out);
    case JsonKind::array: return write_array(value, shape, out);
    case JsonKind::boolean:
    case JsonKind::number:
    case JsonKind::string:
    case JsonKind::extensions: value.Accept(out);
  }
}

const JsonValueShape& shape_of(const JsonObjectShape& object, std::string_view property) {
  const JsonProperty* known = object.properties.data();
  while (known->name != property) ++known;
  return known->value;
}

/// Writes a camera. A missing lens object is replaced by one with zeros, which also means "no values".
void write_camera(const JsonNode& camera, const JsonValueShape& shape, Writer& out) {
  const std::string_view type = text_of(*find_member(camera, "type"));
  if (find_member(camera, type) != nullptr) return write_value(camera, shape, out);
  out.StartObject();
  for (const char* property : {"type", "name"})
    if (const JsonNode* text = find_member(camera, property)) {
      write_name(property, out);
      text->Accept(out);
    }
  write_name(type, out);
  out.StartObject();
  for (const JsonProperty& number : shape_of(*shape.object, type).object->properties) {
    write_name(number.name, out);
    out.Uint(0);
  }
  out.EndObject();
  out.EndObject();
}

}  // namespace

std::string head_text(const JsonNode& root) {
  Text text;
  Writer out(text);
  out.StartObject();
  for (const char* name : {"asset", "extensionsUsed", "extensionsRequired", "scene"})
    if (const JsonNode* value = find_member(root, name)) {
      write_name(name, out);
      write_value(*value, shape_of(*gltf_shape().object, name), out);
    }
  out.EndObject();
  return {text.GetString(), text.GetSize()};
}

std::string slice_text(const char* name, const JsonNode& list, std::size_t& next) {
  const JsonValueShape& shape = *shape_of(*gltf_shape().object, name).element;
  const auto write_entry = std::string_view(name) == "cameras" ? write_camera : write_value;
  Text text;
  Writer out(text);
  out.StartObject();
  write_name(name, out);
  out.StartArray();
  while (next < list.Size() && text.GetSize() < kSliceBytes)
    write_entry(list[static_cast<rapidjson::SizeType>(next++)], shape, out);
  out.EndArray();
  out.EndObject();
  return {text.GetString(), text.GetSize()};
}

}  // namespace sinew
