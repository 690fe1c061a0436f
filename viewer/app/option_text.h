// SPDX-License-Identifier: MIT
#pragma once
#include <charconv>
#include <cmath>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include <CLI/CLI.hpp>

namespace sinew::viewer {

/// Parses all of `text` as a finite number; empty if that fails.
template <class T>
std::optional<T> number(std::string_view text) {
  T value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  if constexpr (std::is_floating_point_v<T>)
    if (!std::isfinite(value)) return std::nullopt;
  return value;
}

/// Parses two numbers with `separator` between them.
template <class T>
std::optional<std::pair<T, T>> two_numbers(std::string_view text, char separator) {
  const auto at = text.find(separator);
  if (at == std::string_view::npos) return std::nullopt;
  const auto a = number<T>(text.substr(0, at)), b = number<T>(text.substr(at + 1));
  if (!a || !b) return std::nullopt;
  return std::pair(*a, *b);
}

/// Looks `text` up in a table of names and values; an unknown name is a validation error that lists all names.
template <class T>
T named(const char* option, const std::string& text, std::initializer_list<std::pair<const char*, T>> names) {
  std::string all;
  for (const auto& [name, value] : names) {
    if (text == name) return value;
    all += (all.empty() ? "" : ", ") + std::string(name);
  }
  throw CLI::ValidationError(option, "'" + text + "' is not one of: " + all);
}

/// Adds an option to the command line. The parser calls `read` with the text of its value.
template <class Read>
CLI::Option* text_option(CLI::App& app, const char* name, const char* type, const char* what, Read read) {
  return app.add_option_function<std::string>(name, read, what)->type_name(type);
}

}  // namespace sinew::viewer
