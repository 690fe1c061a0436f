// SPDX-License-Identifier: MIT
#pragma once
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace sinew::tool {

/// A JSON value that commands print: members of objects keep their order. It is a small class of ours because
/// nlohmann's takes 4 to 8 seconds in each object that builds a document; json.cpp writes the text with nlohmann's.
class Json {
 public:
  Json() = default;  ///< null
  Json(std::nullptr_t) {}
  Json(bool value) : leaf_(value) {}
  template <std::integral T>
  requires(!std::same_as<T, bool>) Json(T value) {
    if constexpr (std::signed_integral<T>)
      leaf_ = static_cast<std::int64_t>(value);
    else
      leaf_ = static_cast<std::uint64_t>(value);
  }
  Json(double value) : leaf_(value) {}
  Json(const char* text) : leaf_(std::string(text)) {}
  Json(std::string_view text) : leaf_(std::string(text)) {}
  Json(std::string text) : leaf_(std::move(text)) {}
  /// An object if each entry is a list of a string and a value, else an array.
  Json(std::initializer_list<Json> entries);
  template <class Range>
  requires(!std::same_as<Range, Json> && !std::convertible_to<const Range&, std::string_view> &&
           requires(const Range& range) { range.begin() != range.end(); }) Json(const Range& values)
      : kind_(Kind::array) {
    for (const auto& value : values) values_.emplace_back(value);
  }
  template <class Value>
  Json(const std::map<std::string, Value>& members) : kind_(Kind::object) {
    for (const auto& [key, value] : members) (*this)[key] = value;
  }
  static Json array() { return Json(Kind::array); }
  static Json object() { return Json(Kind::object); }

  bool is_null() const { return kind_ == Kind::leaf && std::holds_alternative<std::monostate>(leaf_); }
  bool is_number() const { return kind_ == Kind::leaf && leaf_.index() >= 2 && leaf_.index() <= 4; }

  /// The text of a string, or a number of any type. Another type, or a number for a bool, throws.
  template <class T>
  T get() const;

  std::size_t size() const { return values_.size(); }
  bool empty() const { return values_.empty(); }
  bool contains(std::string_view key) const;
  Json& operator[](std::string_view key);  ///< Adds the member if there is none.
  const Json& operator[](std::string_view key) const;
  Json& operator[](const char* key) { return (*this)[std::string_view(key)]; }
  const Json& operator[](const char* key) const { return (*this)[std::string_view(key)]; }
  // Templates, since a literal 0 would also be a null pointer to a key.
  Json& operator[](std::integral auto index) { return values_.at(static_cast<std::size_t>(index)); }
  const Json& operator[](std::integral auto index) const { return values_.at(static_cast<std::size_t>(index)); }
  Json& back() { return values_.back(); }
  void push_back(Json value);  ///< null becomes an array

  /// Elements of an array, or the values of an object.
  auto begin() const { return values_.begin(); }
  auto end() const { return values_.end(); }

  /// Keys and values of an object.
  std::vector<std::pair<std::string_view, const Json&>> items() const;

  /// The text in one line, or indented by `indent` spaces a level. Bytes of strings that are not UTF-8 are replaced.
  std::string dump(int indent = -1) const;

 private:
  enum class Kind { leaf, array, object };
  explicit Json(Kind kind) : kind_(kind) {}
  double number() const;
  void write(std::string& out, int indent, int level) const;

  Kind kind_ = Kind::leaf;
  std::variant<std::monostate, bool, std::int64_t, std::uint64_t, double, std::string> leaf_;
  std::vector<std::string> keys_;  ///< the members' names, one for each of values_; empty if this is no object
  std::vector<Json> values_;
};

template <class T>
T Json::get() const {
  if constexpr (std::same_as<T, bool> || std::same_as<T, std::string>)
    return std::get<T>(leaf_);
  else
    return static_cast<T>(number());
}

}  // namespace sinew::tool
