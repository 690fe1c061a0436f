// SPDX-License-Identifier: MIT
#include "importer/tool/units/unit.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <map>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "importer/platform/files.h"
#include "importer/tool/batch/input_list.h"
#include "runtime/base/checksum.h"

namespace sinew::tool {
namespace {

namespace fs = std::filesystem;

void fill_in(std::string& word, const std::string& placeholder, const std::string& text) {
  for (std::size_t at = 0; (at = word.find(placeholder, at)) != std::string::npos; at += text.size())
    word.replace(at, placeholder.size(), text);
}

/// Chains the bytes of a file to a hash.   out   empty if it cannot be read
std::optional<std::uint64_t> hash_file(const fs::path& path, std::uint64_t hash) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return std::nullopt;
  std::vector<char> part(std::size_t{1} << 20);
  while (file.read(part.data(), static_cast<std::streamsize>(part.size())) || file.gcount() > 0)
    hash = checksum(std::as_bytes(std::span(part).first(static_cast<std::size_t>(file.gcount()))), hash);
  return hash;
}

/// The files beside a .gltf that its buffers and images name.
std::vector<fs::path> named_files(const fs::path& path) {
  std::vector<fs::path> files;
  if (path.extension() != ".gltf") return files;
  std::ifstream text(path, std::ios::binary);
  const auto json = nlohmann::json::parse(text, nullptr, false);
  for (const char* list : {"buffers", "images"})
    for (const auto& entry : json.is_object() ? json.value(list, nlohmann::json::array()) : nlohmann::json::array())
      if (const auto uri = entry.is_object() ? entry.value("uri", nlohmann::json()) : nlohmann::json();
          uri.is_string() && !uri.get_ref<const std::string&>().starts_with("data:"))
        files.push_back(path.parent_path() / platform::path_of(uri.get<std::string>()));
  return files;
}

/// Words of a command that only reads, and that name files beside {in}: goldens, programs.
std::vector<fs::path> other_inputs(const Unit& unit) {
  static constexpr std::array<std::string_view, 4> kReading = {"verify", "check", "info", "plan"};
  std::vector<fs::path> files;
  const auto reads = [&](const std::string& name) { return unit.words.front() == name; };
  const bool writes = std::find(unit.words.begin(), unit.words.end(), "--update") != unit.words.end();
  if (writes || std::none_of(kReading.begin(), kReading.end(), [&](auto name) { return reads(std::string(name)); }))
    return files;
  for (std::size_t i = 1; i < unit.words.size(); ++i) {
    std::error_code error;
    const fs::path path = platform::path_of(unit.words[i]);
    if (unit.words[i - 1] != "--junit" && unit.words[i] != unit.path && fs::is_regular_file(path, error))
      files.push_back(path);
  }
  return files;
}

tl::expected<InputList, std::string> read_manifest(const fs::path& manifest) {
  std::ifstream file(manifest);
  if (!file) return tl::unexpected(platform::text_of(manifest) + ": cannot be read");
  InputList list;
  for (std::string line; std::getline(file, line);) {
    while (!line.empty() && (line.back() == '\r' || line.back() == ' ')) line.pop_back();
    if (line.empty() || line.front() == '#') continue;
    const fs::path path = manifest.parent_path() / platform::path_of(line);
    list.inputs.push_back({platform::text_of(path), line, {}, false, {}});
  }
  return list;
}

}  // namespace

tl::expected<std::vector<std::string>, std::string> split_words(const std::string& command) {
  std::vector<std::string> words;
  char quote = 0;
  bool in_word = false;
  for (const char c : command) {
    if (quote != 0 ? c == quote : c == '"' || c == '\'') {
      quote = quote != 0 ? '\0' : c;
      if (!std::exchange(in_word, true)) words.emplace_back();
    } else if (c == ' ' && quote == 0) {
      in_word = false;
    } else {
      if (!std::exchange(in_word, true)) words.emplace_back();
      words.back() += c;
    }
  }
  if (quote != 0) return tl::unexpected(std::string("a quotation mark has no partner"));
  return words;
}

tl::expected<std::vector<Unit>, std::string> list_units(const std::string& input,
                                                        const std::vector<std::string>& command, const fs::path& out) {
  std::error_code error;
  InputList list;
  if (fs::is_directory(platform::path_of(input), error)) {
    list = list_inputs({input}, true, FileKind::models_and_assets);
  } else if (is_named_as(FileKind::models_and_assets, input)) {
    list.inputs.push_back({input, platform::text_of(platform::path_of(input).filename()), {}, false, {}});
  } else {
    auto manifest = read_manifest(platform::path_of(input));
    if (!manifest) return tl::unexpected(manifest.error());
    list = std::move(*manifest);
  }
  std::vector<Unit> units;
  std::map<fs::path, std::string> outputs;
  for (const Input& file : list.inputs) {
    if (!file.remark.empty() && file.fault) return tl::unexpected(file.path + ": " + file.remark);
    if (!file.remark.empty()) continue;
    const fs::path below = platform::path_of(file.below);
    const fs::path own = out / "files" / fs::path(below).replace_extension().relative_path();
    if (const auto [other, is_new] = outputs.emplace(own.lexically_normal(), file.path); !is_new)
      return tl::unexpected(file.path + ": has the output of " + other->second);
    Unit unit{file.below, file.path, command, {}};
    for (std::string& word : unit.words) {
      fill_in(word, "{in}", file.path);
      fill_in(word, "{out}", platform::text_of(own));
      fill_in(word, "{name}", platform::text_of(below.stem()));
    }
    units.push_back(std::move(unit));
  }
  return units;
}

std::string id_of(const Unit& unit, const std::vector<std::string>& command) {
  constexpr std::string_view kVersion = SINEW_VERSION;
  std::uint64_t hash = checksum(std::as_bytes(std::span(kVersion)));
  for (const std::string& word : command)
    hash = checksum(std::as_bytes(std::span(word.c_str(), word.size() + 1)), hash);
  hash = checksum(std::as_bytes(std::span(unit.name.data(), unit.name.size())), hash);
  const fs::path path = platform::path_of(unit.path);
  std::optional<std::uint64_t> all = hash_file(path, hash);
  if (!all) return {};
  std::vector<fs::path> others = named_files(path);
  for (fs::path& file : other_inputs(unit)) others.push_back(std::move(file));
  for (const fs::path& file : others) all = hash_file(file, *all).value_or(*all + 1);
  return fmt::format("{:016x}", *all);
}

}  // namespace sinew::tool
