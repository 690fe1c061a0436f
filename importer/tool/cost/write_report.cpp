// SPDX-License-Identifier: MIT
#include "importer/tool/cost/write_report.h"

#include <algorithm>
#include <fstream>
#include <string_view>

#include <fmt/core.h>

#include "importer/platform/files.h"
#include "importer/platform/program.h"
#include "importer/tool/cost/report_json.h"
#include "importer/tool/files/output.h"
#include "importer/visible_text.h"

namespace sinew::cost {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view kFiles[] = {"report.json", "report.csv", "report.html"};

/// "DIR" for "DIR/", because both name the same folder.
fs::path without_slash(const fs::path& folder) { return folder.has_filename() ? folder : folder.parent_path(); }

fs::path beside(const fs::path& folder, std::string_view ending) {
  return platform::path_of(platform::text_of(folder) + fmt::format(".{}.{}", platform::process_number(), ending));
}

std::optional<std::string> write_file(const fs::path& file, const std::string& text) {
  std::ofstream stream(file, std::ios::binary);
  stream << text;
  stream.close();
  if (stream) return std::nullopt;
  return fmt::format("{} cannot be written", platform::text_of(file));
}

std::string json_of(const Report& report) {
  return visible_json(report_json(report).dump(2, ' ', false, nlohmann::json::error_handler_t::replace)) + '\n';
}

std::optional<std::string> fill(const Report& report, const fs::path& folder) {
  for (const std::string_view name : kFiles) {
    const std::string text = name == "report.json"  ? json_of(report)
                             : name == "report.csv" ? report_csv(report)
                                                    : report_page(report);
    if (auto failed = write_file(folder / name, text)) return failed;
  }
  return std::nullopt;
}

/// Renames `made` to `folder`. An older folder is moved aside first and comes back if that fails.
std::optional<std::string> put_in_place(const fs::path& made, const fs::path& folder) {
  std::error_code error;
  const fs::path older = beside(folder, "old");
  const bool replaces = fs::exists(folder, error);
  if (replaces) fs::rename(folder, older, error);
  if (!error) fs::rename(made, folder, error);
  if (error) {
    const std::string why = error.message();
    if (replaces && !fs::exists(folder, error)) fs::rename(older, folder, error);
    return why;
  }
  if (replaces) fs::remove_all(older, error);
  return std::nullopt;
}

}  // namespace

std::string find_folder_error(const fs::path& given, std::span<const fs::path> inputs) {
  const fs::path folder = without_slash(given),
                 parent = folder.has_parent_path() ? folder.parent_path() : fs::path(".");
  std::error_code error;
  if (!fs::is_directory(parent, error)) return fmt::format("there is no folder {}", platform::text_of(parent));
  if (!fs::exists(folder, error)) return {};
  if (!fs::is_directory(folder, error) || fs::is_symlink(folder, error)) return "exists and is not a folder";
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    const std::string name = platform::text_of(entry.path().filename());
    if (std::find(std::begin(kFiles), std::end(kFiles), name) == std::end(kFiles))
      return fmt::format("holds {}, which is no part of a report; it is left as it is", name);
    if (const auto in_use = tool::find_output_error(entry.path(), inputs)) return *in_use;
  }
  return error ? error.message() : std::string();
}

std::optional<std::string> write_report(const Report& report, const fs::path& given) {
  const fs::path folder = without_slash(given), made = beside(folder, "new");
  std::error_code error;
  if (!fs::create_directory(made, error))
    return fmt::format("{} cannot be made: {}", platform::text_of(made), error.message());
  auto failed = fill(report, made);
  if (!failed) failed = put_in_place(made, folder);
  if (failed) fs::remove_all(made, error);
  return failed;
}

}  // namespace sinew::cost
