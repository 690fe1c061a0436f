// SPDX-License-Identifier: MIT
#include "importer/file/json_shape.h"

#include <algorithm>
#include <cmath>

#include "importer/file/json_pointer.h"

namespace sinew {
namespace {

using Json = nlohmann::json;

std::string_view name_of(JsonKind kind) {
  constexpr std::string_view names[] = {"anything", "true or false", "a number",  "an integer",
                                        "a string", "an object",     "an array", "an object of indices"};
  return names[static_cast<std::size_t>(kind)];
}

/// glTF allows integers written with a fraction of zero ("3.0").
bool is_integer(const Json& value) {
  if (value.is_number_integer()) return true;
  return value.is_number_float() && std::floor(value.get<double>()) == value.get<double>();
}

bool has_kind(const Json& value, JsonKind kind) {
  switch (kind) {
    case JsonKind::any: return true;
    case JsonKind::boolean: return value.is_boolean();
    case JsonKind::number: return value.is_number();
    case JsonKind::integer: return is_integer(value);
    case JsonKind::string: return value.is_string();
    case JsonKind::object:
    case JsonKind::index_map: return value.is_object();
    case JsonKind::array: return value.is_array();
  }
  return false;
}

/// A place in the document as a chain of frames, so that text is made only for what is reported.
struct Place {
  const Place* parent = nullptr;
  std::string_view name;      ///< of a property; for an array entry empty
  std::size_t index = 0;

  std::string text() const {
    if (parent == nullptr) return std::string(name);
    return parent->text() + (name.data() != nullptr ? pointer(pointer_token(name)) : pointer(index));
  }
};

class Checker {
 public:
  explicit Checker(IssueLog& log) : log_(log) {}

  void check(const Json& value, const JsonValueShape& shape, const Place& place) {
    if (!has_kind(value, shape.kind))
      return log_.report(Rule::json_type, place.text(), "must be " + std::string(name_of(shape.kind)) + ", is " + value.type_name());
    switch (shape.kind) {
      case JsonKind::number:
      case JsonKind::integer: return check_number(value, shape, place);
      case JsonKind::string: return check_word(value, shape, place);
      case JsonKind::array: return check_array(value, shape, place);
      case JsonKind::object: return check_object(value, shape, place);
      case JsonKind::index_map: return check_map(value, shape, place);
      case JsonKind::any:
      case JsonKind::boolean: return;
    }
  }

 private:
  void check_number(const Json& value, const JsonValueShape& shape, const Place& place) {
    const double number = value.get<double>();
    if (!(number >= shape.lower && number <= shape.upper))
      return log_.report(Rule::json_type, place.text(), value.dump() + " is out of range");
    const auto same = [&](std::int64_t allowed) { return number == static_cast<double>(allowed); };
    if (!shape.numbers.empty() && std::none_of(shape.numbers.begin(), shape.numbers.end(), same))
      log_.report(Rule::json_type, place.text(), value.dump() + " is none of the values that glTF defines");
  }

  void check_word(const Json& value, const JsonValueShape& shape, const Place& place) {
    const auto& text = value.get_ref<const std::string&>();
    if (!shape.words.empty() && std::find(shape.words.begin(), shape.words.end(), text) == shape.words.end())
      log_.report(Rule::json_type, place.text(), in_quotes(text) + " is none of the words that glTF defines");
  }

  void check_array(const Json& value, const JsonValueShape& shape, const Place& place) {
    if (shape.length != 0 && value.size() != shape.length)
      return log_.report(Rule::json_type, place.text(),
                         "has " + std::to_string(value.size()) + " entries instead of " + std::to_string(shape.length));
    if (value.empty()) return log_.report(Rule::empty_array, place.text(), "an empty array is taken as absent");
    if (shape.element == nullptr) return;
    for (std::size_t i = 0; i < value.size(); ++i) check(value[i], *shape.element, {&place, {}, i});
  }

  void check_object(const Json& value, const JsonValueShape& shape, const Place& place) {
    if (shape.object == nullptr) return;
    for (const auto& property : shape.object->properties) {
      const auto found = value.find(property.name);
      if (found != value.end())
        check(*found, property.value, {&place, property.name});
      else if (property.required)
        log_.report(Rule::json_missing, place.text(), "has no " + in_quotes(property.name));
    }
  }

  void check_map(const Json& value, const JsonValueShape& shape, const Place& place) {
    for (const auto& [name, entry] : value.items()) check(entry, *shape.element, {&place, name});
  }

  IssueLog& log_;
};

}  // namespace

void check_shape(const Json& value, const JsonValueShape& shape, const std::string& place, IssueLog& log) {
  Checker(log).check(value, shape, {nullptr, place, 0});
}

}  // namespace sinew
