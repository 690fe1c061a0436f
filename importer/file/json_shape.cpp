// SPDX-License-Identifier: MIT
#include "importer/file/json_shape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "importer/file/json_place.h"

namespace sinew {
namespace {

std::string_view name_of(JsonKind kind) {
  constexpr std::string_view names[] = {"true or false", "a number", "an integer",           "a string",
                                        "an object",     "an array", "an object of indices", "an object"};
  return names[static_cast<std::size_t>(kind)];
}

/// glTF allows integers written with a fraction of zero ("3.0").
bool is_integer(const JsonNode& value) {
  return value.IsNumber() && std::floor(value.GetDouble()) == value.GetDouble();
}

bool has_kind(const JsonNode& value, JsonKind kind) {
  switch (kind) {
    case JsonKind::boolean: return value.IsBool();
    case JsonKind::number: return value.IsNumber();
    case JsonKind::integer: return is_integer(value);
    case JsonKind::string: return value.IsString();
    case JsonKind::object:
    case JsonKind::index_map:
    case JsonKind::extensions: return value.IsObject();
    case JsonKind::array: break;
  }
  return value.IsArray();
}

class Checker {
 public:
  explicit Checker(IssueLog& log) : log_(log) {}

  void check(const JsonNode& value, const JsonValueShape& shape, const JsonPlace& place) {
    if (!has_kind(value, shape.kind))
      return log_.report(Rule::json_type, place.text(),
                         "must be " + std::string(name_of(shape.kind)) + ", is " + to_json(value).type_name());
    switch (shape.kind) {
      case JsonKind::number:
      case JsonKind::integer: return check_number(value, shape, place);
      case JsonKind::string: return check_word(value, shape, place);
      case JsonKind::array: return check_array(value, shape, place);
      case JsonKind::object: return check_object(value, shape, place);
      case JsonKind::index_map: return check_map(value, shape, place);
      case JsonKind::extensions: return check_extensions(value, place);
      case JsonKind::boolean: return;
    }
  }

 private:
  void check_number(const JsonNode& value, const JsonValueShape& shape, const JsonPlace& place) {
    const double number = value.GetDouble();
    if (!(number >= shape.lower && number <= shape.upper))
      return log_.report(Rule::json_type, place.text(), to_json(value).dump() + " is out of range");
    const auto same = [&](std::int64_t allowed) { return number == static_cast<double>(allowed); };
    if (!shape.numbers.empty() && std::none_of(shape.numbers.begin(), shape.numbers.end(), same))
      log_.report(Rule::json_type, place.text(), to_json(value).dump() + " is none of the values that glTF defines");
  }

  void check_word(const JsonNode& value, const JsonValueShape& shape, const JsonPlace& place) {
    const std::string_view text = text_of(value);
    if (!shape.words.empty() && std::find(shape.words.begin(), shape.words.end(), text) == shape.words.end())
      log_.report(Rule::json_type, place.text(), in_quotes(text) + " is none of the words that glTF defines");
  }

  void check_array(const JsonNode& value, const JsonValueShape& shape, const JsonPlace& place) {
    if (shape.length != 0 && value.Size() != shape.length)
      return log_.report(Rule::json_type, place.text(),
                         "has " + std::to_string(value.Size()) + " entries instead of " + std::to_string(shape.length));
    if (value.Empty()) return log_.report(Rule::empty_array, place.text(), "an empty array is taken as absent");
    if (shape.element == nullptr) return;
    for (rapidjson::SizeType i = 0; i < value.Size(); ++i) check(value[i], *shape.element, {&place, {}, i});
  }

  void check_object(const JsonNode& value, const JsonValueShape& shape, const JsonPlace& place) {
    if (shape.object == nullptr) return;
    const auto properties = shape.object->properties;
    std::array<const JsonNode*, JsonObjectShape::kMost> found;
    std::fill_n(found.begin(), properties.size(), nullptr);
    bool repeated = false;
    std::size_t unknown = 0;
    for (const auto& [name, member] : value.GetObject())
      if (const std::size_t p = shape.object->find(text_of(name)); p < properties.size())
        repeated |= std::exchange(found[p], &member) != nullptr;
      else
        ++unknown;
    if (repeated || unknown > 1) check_names(value, place);
    for (std::size_t p = 0; p < properties.size(); ++p) {
      const JsonProperty& property = properties[p];
      if (found[p] != nullptr)
        check(*found[p], property.value, {&place, property.name});
      else if (property.required)
        log_.report(Rule::json_missing, place.text(), "has no " + in_quotes(property.name));
    }
  }

  void check_map(const JsonNode& value, const JsonValueShape& shape, const JsonPlace& place) {
    check_names(value, place);
    for (const auto& [name, entry] : value.GetObject()) check(entry, *shape.element, {&place, text_of(name)});
  }

  /// Checks only that entries are objects; the content of an extension is checked where it is read.
  void check_extensions(const JsonNode& value, const JsonPlace& place) {
    check_names(value, place);
    for (const auto& [name, entry] : value.GetObject())
      if (!entry.IsObject())
        log_.report(Rule::extension_value, JsonPlace{&place, text_of(name)}.text(), "is no object; ignored");
  }

  /// Finds duplicate names. Small objects are compared pairwise; large ones are sorted.
  void check_names(const JsonNode& value, const JsonPlace& place) {
    constexpr rapidjson::SizeType kMany = 24;
    const auto report = [&](std::string_view name) {
      log_.report(Rule::json_duplicate, place.text(), "has " + in_quotes(name) + " more than once");
    };
    if (value.MemberCount() > kMany) {
      std::vector<std::string_view> names;
      for (const auto& member : value.GetObject()) names.push_back(text_of(member.name));
      std::sort(names.begin(), names.end());
      if (const auto twice = std::adjacent_find(names.begin(), names.end()); twice != names.end()) report(*twice);
      return;
    }
    for (auto member = value.MemberBegin(); member != value.MemberEnd(); ++member)
      if (find_member(value, text_of(member->name)) != &member->value) return report(text_of(member->name));
  }

  IssueLog& log_;
};

}  // namespace

void check_shape(const JsonNode& value, const JsonValueShape& shape, const std::string& place, IssueLog& log) {
  Checker(log).check(value, shape, {nullptr, place, 0});
}

void check_shape(const nlohmann::json& value, const JsonValueShape& shape, const std::string& place, IssueLog& log) {
  constexpr std::size_t kPiece = 1024;
  JsonTree tree(kPiece);
  tree.root = from_json(value, tree.pool);
  check_shape(tree.root, shape, place, log);
}

}  // namespace sinew
