// SPDX-License-Identifier: MIT
#include "importer/tool/cost/overview/pictures.h"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <sstream>
#include <vector>

#include <fmt/format.h>

#include "importer/platform/files.h"
#include "importer/platform/program.h"
#include "importer/tool/cost/run_beside.h"
#include "importer/tool/cost/words.h"
#include "importer/tool/length_text.h"
#include "runtime/base/index.h"

namespace sinew::cost {
namespace fs = std::filesystem;
namespace {

struct Drawn {
  std::string png, printed;
};

tl::expected<Drawn, std::string> draw_moment(const DrawnMoment& moment, const std::vector<std::string>& more) {
  std::error_code error;
  const fs::path picture =
      fs::temp_directory_path(error) / fmt::format("sinew-cost-{}.png", platform::process_number());
  if (error) return tl::unexpected(error.message());
  std::vector<std::string> arguments{moment.file,
                                     "--clip",
                                     moment.clip == kNone ? "none" : fmt::format("{}", moment.clip),
                                     "--time",
                                     fmt::format("{:.9g}", moment.time_s),
                                     "--headless",
                                     platform::text_of(picture)};
  arguments.insert(arguments.end(), more.begin(), more.end());
  auto printed = output_of_program_beside("sinew-viewer", arguments);
  Drawn drawn;
  std::ifstream stream(picture, std::ios::binary);
  drawn.png.assign(std::istreambuf_iterator<char>(stream), {});
  stream.close();
  fs::remove(picture, error);
  if (!printed) return tl::unexpected(printed.error());
  if (drawn.png.empty()) return tl::unexpected(std::string("sinew-viewer drew nothing"));
  drawn.printed = std::move(*printed);
  return drawn;
}

/// The other view of a choice, as --compare takes it; empty if the viewer has none.
std::string view_of(const Choice& choice, double size_m) {
  if (choice.group == "skinning") return "dual-quaternion";
  if (choice.group == "storage" && choice.budget) return fmt::format("compiled={:.9g}", 10.0 * *choice.budget * size_m);
  return {};
}

/// The length at the red end of the colours: "colours: blue 0, red 100 mm" in what the viewer prints.
std::optional<double> red_m(const std::string& printed) {
  constexpr std::string_view kRed = "colours: blue 0, red ";
  const std::size_t at = printed.find(kRed);
  if (at == std::string::npos) return std::nullopt;
  const std::size_t begin = at + kRed.size();
  const auto length = tool::parse_length(printed.substr(begin, printed.find('\n', begin) - begin));
  return length ? std::optional(length->metres) : std::nullopt;
}

}  // namespace

tl::expected<std::string, std::string> plan_of_picture(const DrawnMoment& moment) {
  auto drawn = draw_moment(moment, {"--plan"});
  if (!drawn) return tl::unexpected(drawn.error());
  return std::move(drawn->printed);
}

tl::expected<void, std::string> add_picture(const DrawnMoment& moment, double size_m, Choice& choice) {
  const std::string view = view_of(choice, size_m);
  if (view.empty()) return {};
  auto drawn = draw_moment(moment, {"--compare", "linear," + view, "--size", "480x270"});
  if (!drawn) return tl::unexpected(drawn.error());
  choice.picture = std::move(drawn->png);
  choice.picture_note = "how far it moves the surface";
  if (const auto red = red_m(drawn->printed))
    choice.picture_note += fmt::format(": blue 0, red {} % of the model", number(100.0 * *red / size_m));
  return {};
}

}  // namespace sinew::cost
