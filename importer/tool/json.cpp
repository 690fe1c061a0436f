// SPDX-License-Identifier: MIT
#include "importer/tool/json.h"

#include <algorithm>
#include <stdexcept>
#include <type_traits>

#include <nlohmann/json.hpp>

namespace sinew::tool {
namespace {

template <class Leaf>
std::string leaf_text(const Leaf& leaf) {
  if constexpr (std::is_same_v<Leaf, std::monostate>)
    return "null";
  else
    return nlohmann::json(leaf).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

void end_line(std::string& out, int indent, int level) {
  if (indent >= 0) (out += '\n').append(static_cast<std::size_t>(indent * level), ' ');
}

}  // namespace

Json::Json(std::initializer_list<Json> entries) {
  const auto is_member = [](const Json& entry) {
    return entry.kind_ == Kind::array && entry.size() == 2 && std::holds_alternative<std::string>(entry[0].leaf_);
  };
  const bool is_object = std::all_of(entries.begin(), entries.end(), is_member);
  kind_ = is_object ? Kind::object : Kind::array;
  for (const Json& entry : entries) {
    if (is_object) keys_.push_back(entry[0].get<std::string>());
    values_.push_back(is_object ? entry[1] : entry);
  }
}

bool Json::contains(std::string_view key) const { return std::find(keys_.begin(), keys_.end(), key) != keys_.end(); }

Json& Json::operator[](std::string_view key) {
  const auto found = std::find(keys_.begin(), keys_.end(), key);
  if (found != keys_.end()) return values_[static_cast<std::size_t>(found - keys_.begin())];
  kind_ = Kind::object;
  keys_.emplace_back(key);
  return values_.emplace_back();
}

const Json& Json::operator[](std::string_view key) const {
  const auto found = std::find(keys_.begin(), keys_.end(), key);
  if (found == keys_.end()) throw std::out_of_range("no member " + std::string(key));
  return values_[static_cast<std::size_t>(found - keys_.begin())];
}

void Json::push_back(Json value) {
  if (is_null()) kind_ = Kind::array;
  values_.push_back(std::move(value));
}

std::vector<std::pair<std::string_view, const Json&>> Json::items() const {
  std::vector<std::pair<std::string_view, const Json&>> out;
  for (std::size_t i = 0; i < keys_.size(); ++i) out.emplace_back(keys_[i], values_[i]);
  return out;
}

double Json::number() const {
  return std::visit(
      [](const auto& leaf) -> double {
        using Leaf = std::decay_t<decltype(leaf)>;
        if constexpr (std::is_arithmetic_v<Leaf> && !std::is_same_v<Leaf, bool>)
          return static_cast<double>(leaf);
        else
          throw std::invalid_argument("not a number");
      },
      leaf_);
}

std::string Json::dump(int indent) const {
  std::string out;
  write(out, indent, 1);
  return out;
}

void Json::write(std::string& out, int indent, int level) const {
  if (kind_ == Kind::leaf) {
    out += std::visit([](const auto& leaf) { return leaf_text(leaf); }, leaf_);
    return;
  }
  const bool is_object = kind_ == Kind::object;
  out += is_object ? '{' : '[';
  for (std::size_t i = 0; i < values_.size(); ++i) {
    if (i > 0) out += ',';
    end_line(out, indent, level);
    if (is_object) out += leaf_text(keys_[i]) + (indent >= 0 ? ": " : ":");
    values_[i].write(out, indent, level + 1);
  }
  if (!values_.empty()) end_line(out, indent, level - 1);
  out += is_object ? '}' : ']';
}

}  // namespace sinew::tool
