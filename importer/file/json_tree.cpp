// SPDX-License-Identifier: MIT
#include "importer/file/json_tree.h"

#include <cstddef>
#include <cstdint>
#include <string>

namespace sinew {
namespace {

/// Compares lengths and first letters before all: names of one object rarely share both.
bool is_named(const JsonNode::Member& member, std::string_view name) noexcept {
  const std::string_view own = text_of(member.name);
  return own.size() == name.size() && (own.empty() || (own.front() == name.front() && own == name));
}

rapidjson::SizeType size_of(const std::string& text) { return static_cast<rapidjson::SizeType>(text.size()); }

}  // namespace

JsonNode* find_member(JsonNode& object, std::string_view name) noexcept {
  const auto first = object.MemberBegin();
  for (auto left = static_cast<std::ptrdiff_t>(object.MemberCount()); left > 0;
       --left)  // of duplicate names, the last one counts
    if (const auto member = first + (left - 1); is_named(*member, name)) return &member->value;
  return nullptr;
}

nlohmann::json to_json(const JsonNode& node) {
  switch (node.GetType()) {
    case rapidjson::kNullType: break;
    case rapidjson::kFalseType: return false;
    case rapidjson::kTrueType: return true;
    case rapidjson::kStringType: return std::string(text_of(node));
    case rapidjson::kNumberType:
      if (node.IsUint64()) return node.GetUint64();
      if (node.IsInt64()) return node.GetInt64();
      return node.GetDouble();
    case rapidjson::kArrayType: {
      nlohmann::json::array_t out;
      out.reserve(node.Size());
      for (const JsonNode& entry : node.GetArray()) out.push_back(to_json(entry));
      return out;
    }
    case rapidjson::kObjectType: {
      nlohmann::json::object_t out;
      for (const auto& [name, value] : node.GetObject())
        out.insert_or_assign(std::string(text_of(name)), to_json(value));
      return out;
    }
  }
  return nullptr;
}

JsonNode from_json(const nlohmann::json& value, JsonPool& pool) {
  if (value.is_boolean()) return JsonNode(value.get<bool>());
  if (value.is_number_unsigned()) return JsonNode(value.get<std::uint64_t>());
  if (value.is_number_integer()) return JsonNode(value.get<std::int64_t>());
  if (value.is_number_float()) return JsonNode(value.get<double>());
  if (const auto* text = value.get_ptr<const std::string*>()) return JsonNode(text->data(), size_of(*text), pool);
  JsonNode out;
  if (value.is_array()) {
    out.SetArray();
    for (const auto& entry : value) out.PushBack(from_json(entry, pool), pool);
  } else if (value.is_object()) {
    out.SetObject();
    for (const auto& [name, entry] : value.items())
      out.AddMember(JsonNode(name.data(), size_of(name), pool), from_json(entry, pool), pool);
  }
  return out;
}

}  // namespace sinew
