// SPDX-License-Identifier: MIT
#include "importer/tool/units/unit_result.h"

#include <fstream>
#include <span>

#include <nlohmann/json.hpp>

#include "importer/platform/files.h"

namespace sinew::tool {

std::string UnitResult::last_line() const {
  const std::size_t end = output.find_last_not_of("\r\n");
  if (end == std::string::npos) return {};
  const std::size_t before = output.find_last_of('\n', end);
  const std::size_t begin = before == std::string::npos ? 0 : before + 1;
  return output.substr(begin, end + 1 - begin);
}

std::filesystem::path result_file(const std::filesystem::path& out, const std::string& id) {
  return out / "units" / (id + ".json");
}

std::optional<UnitResult> read_result(const std::filesystem::path& file) {
  std::ifstream text(file, std::ios::binary);
  if (!text) return std::nullopt;
  const auto json = nlohmann::json::parse(text, nullptr, false);
  if (!json.is_object()) return std::nullopt;
  const auto name = json.find("name"), status = json.find("status"), output = json.find("output"),
             seconds = json.find("seconds"), none = json.end();
  if (name == none || !name->is_string() || status == none || !status->is_number_integer() || output == none ||
      !output->is_string() || seconds == none || !seconds->is_number())
    return std::nullopt;
  return UnitResult{name->get<std::string>(), status->get<int>(), output->get<std::string>(), seconds->get<double>()};
}

bool write_result(const std::filesystem::path& file, const UnitResult& result) {
  const nlohmann::ordered_json json = {
      {"name", result.name}, {"status", result.status}, {"seconds", result.seconds}, {"output", result.output}};
  const std::string text = json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) + '\n';
  const std::filesystem::path own = platform::temporary_beside(file);
  const int descriptor = platform::create_new(own);
  if (descriptor < 0) return false;
  const bool written = platform::write_all(descriptor, std::as_bytes(std::span(text.data(), text.size()))) &&
                       platform::flush_to_disk(descriptor);
  platform::close(descriptor);
  if (written && platform::rename_over(own, file)) return true;
  platform::remove(own);
  return false;
}

}  // namespace sinew::tool
