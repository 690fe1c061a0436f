// SPDX-License-Identifier: MIT
#include "importer/read/extension_fields.h"

#include "importer/file/json_pointer.h"
#include "importer/read/json_member.h"

namespace sinew {
namespace {

using gltf::Json;

/// True if the number is in range; false for NaN.
bool in_range(const Json& value, double lower, double upper) {
  return value.is_number() && value.get<double>() >= lower && value.get<double>() <= upper;
}

std::string range_text(double lower, double upper) {
  const bool below = lower > -ExtensionFields::kAny, above = upper < ExtensionFields::kAny;
  std::string text;
  if (below) text += " from " + std::to_string(lower);
  if (above) text += " to " + std::to_string(upper);
  return text;
}

}  // namespace

ExtensionFields::ExtensionFields(const Json& extensions, const std::string& place, const char* name, IssueLog& log)
    : object_(member(&extensions, name)),
      place_(place.empty() ? pointer("extensions", name) : pointer(place, "extensions", name)),
      log_(log) {
  if (object_ != nullptr && !object_->is_object()) object_ = nullptr;  // reported by check_shape()
}

const Json* ExtensionFields::find(const char* field) const { return member(object_, field); }

bool ExtensionFields::has(const char* field) const { return find(field) != nullptr; }

void ExtensionFields::complain(const char* field, const std::string& needed) const {
  log_.report(Rule::extension_value, pointer(place_, field), "is no " + needed + "; the default is used");
}

ExtensionFields ExtensionFields::object(const char* field) const {
  const Json* value = find(field);
  if (value != nullptr && !value->is_object()) {
    complain(field, "object");
    value = nullptr;
  }
  return {value, pointer(place_, field), log_};
}

std::vector<ExtensionFields> ExtensionFields::list(const char* field) const {
  std::vector<ExtensionFields> out;
  const Json* value = find(field);
  if (value == nullptr) return out;
  if (!value->is_array()) complain(field, "array");
  for (std::size_t i = 0; value->is_array() && i < value->size(); ++i) {
    const std::string place = pointer(place_, field, i);
    if ((*value)[i].is_object())
      out.push_back(ExtensionFields(&(*value)[i], place, log_));
    else
      log_.report(Rule::extension_value, place, "is no object; ignored");
  }
  return out;
}

std::vector<std::pair<std::string, ExtensionFields>> ExtensionFields::members() const {
  std::vector<std::pair<std::string, ExtensionFields>> out;
  if (object_ == nullptr) return out;
  // Longer names are dropped, because they would be copied into many locations.
  constexpr std::size_t kLongestName = 256;
  for (const auto& [name, value] : object_->items())
    if (name.size() > kLongestName)
      log_.report(Rule::extension_value, place_, in_quotes(name) + " is too long a name; ignored");
    else if (value.is_object())
      out.emplace_back(name, ExtensionFields(&value, pointer(place_, pointer_token(name)), log_));
  return out;
}

std::string ExtensionFields::text(const char* field) const {
  const Json* value = find(field);
  if (value == nullptr) return {};
  if (value->is_string()) return value->get<std::string>();
  complain(field, "string");
  return {};
}

std::vector<std::uint32_t> ExtensionFields::indices(const char* field, std::size_t limit) const {
  std::vector<std::uint32_t> out;
  const Json* value = find(field);
  if (value == nullptr) return out;
  if (!value->is_array()) complain(field, "array");
  for (std::size_t i = 0; value->is_array() && i < value->size(); ++i) {
    const std::uint32_t index = index_below(&(*value)[i], limit);
    if (index != kNone)
      out.push_back(index);
    else
      log_.report(Rule::extension_value, pointer(place_, field, i),
                  "is no index below " + std::to_string(limit) + "; ignored");
  }
  return out;
}

bool ExtensionFields::boolean(const char* field, bool fallback) const {
  const Json* value = find(field);
  if (value == nullptr) return fallback;
  if (value->is_boolean()) return value->get<bool>();
  complain(field, "true or false");
  return fallback;
}

double ExtensionFields::number(const char* field, double fallback, double lower, double upper) const {
  const Json* value = find(field);
  if (value == nullptr) return fallback;
  if (in_range(*value, lower, upper)) return value->get<double>();
  complain(field, "number" + range_text(lower, upper));
  return fallback;
}

void ExtensionFields::numbers(const char* field, float* out, std::size_t count, double lower, double upper) const {
  const Json* value = find(field);
  if (value == nullptr) return;
  bool good = value->is_array() && value->size() == count;
  for (std::size_t i = 0; good && i < count; ++i) good = in_range((*value)[i], lower, upper);
  if (!good) return complain(field, "array of " + std::to_string(count) + " numbers" + range_text(lower, upper));
  for (std::size_t i = 0; i < count; ++i) out[i] = (*value)[i].get<float>();
}

std::uint32_t ExtensionFields::index(const char* field, std::size_t limit) const {
  const Json* value = find(field);
  const std::uint32_t index = index_below(value, limit);
  if (value != nullptr && index == kNone) complain(field, "index below " + std::to_string(limit));
  return index;
}

const Json& ExtensionFields::extensions() const {
  static const Json kAbsent;
  const Json* value = find("extensions");
  return value == nullptr ? kAbsent : *value;
}

}  // namespace sinew
