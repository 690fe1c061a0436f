// SPDX-License-Identifier: MIT
#include "viewer/app/output_options.h"

#include <utility>

#include "viewer/app/open/file_names.h"
#include "viewer/app/option_text.h"
#include "viewer/app/pictures/film_writer.h"

namespace sinew::viewer {
namespace {

constexpr std::uint32_t kSheetCellWidth = 240, kSheetCellHeight = 180;

void read_frames(const std::string& text, Options& options) {
  const auto range = two_numbers<std::uint32_t>(text, ':');
  if (!range || range->first > range->second)
    throw CLI::ValidationError("--frames", "'" + text + "' is not FIRST:LAST with FIRST <= LAST, such as 0:59");
  options.frames = FrameRange{range->first, range->second};
}

bool names_png(const std::string& path) { return ending_of(path) == ".png"; }

}  // namespace

void add_time_options(CLI::App& app, Options& options, CLI::Option* file) {
  const auto seconds = [](const char* option, const std::string& text, double least) {
    const auto value = number<double>(text);
    if (!value || *value < least) throw CLI::ValidationError(option, "'" + text + "' is not a time in seconds");
    return *value;
  };
  text_option(app, "--clip", "CLIP", "index, name, name#2 (the second of that name) or none (the first clip)",
              [&](const std::string& text) { options.clip = text; });
  auto* time = text_option(app, "--time", "T", "seconds into the clip (0)",
                           [&, seconds](const std::string& text) { options.time_s = seconds("--time", text, -1e9); });
  auto* headless =
      app.add_option("--headless", options.headless, "write OUT.png, or numbered pictures into DIR/, without a window")
          ->type_name("OUT");
  auto* frames = text_option(app, "--frames", "A:B", "pictures A to B, both included; picture n shows second n / fps",
                             [&](const std::string& text) { read_frames(text, options); });
  text_option(app, "--fps", "N", "pictures a second for --frames and --film (30)", [&](const std::string& text) {
    const auto value = number<double>(text);
    if (!value || *value <= 0.0 || *value > 1e6)
      throw CLI::ValidationError("--fps", "'" + text + "' is not a rate above 0");
    options.fps = *value;
  });
  text_option(
      app, "--updates", "HOW",
      "what is small in the picture: every, interpolated or held between updates (interpolated; with --headless every)",
      [&](const std::string& text) {
        options.updates = named<Updates>(
            "--updates", text,
            {{"every", Updates::every}, {"interpolated", Updates::interpolated}, {"held", Updates::held}});
      });
  auto* plan = app.add_flag("--plan", options.plan,
                            "print what a picture takes: each stage and pass, why it runs or not, and its time");
  auto* transparent = app.add_flag("--transparent", options.transparent, "alpha 0 where nothing was drawn");
  auto* exit_after =
      text_option(app, "--exit-after", "SECONDS", "close the window by itself, for tests",
                  [&, seconds](const std::string& text) { options.exit_after_s = seconds("--exit-after", text, 0.0); });
  app.add_flag("--validate", options.validate, "use Vulkan's validation layer; exit code 3 when it complains");
  auto* watch = app.add_flag("--watch", options.watch,
                             "read FILE again when it or a file that it names changes; clip, time and camera stay");
  watch->needs(file)->excludes(headless);
  auto* film =
      app.add_option("--film", options.film, "write a film .mp4, .webm or .gif (ffmpeg) of --frames or --turntable")
          ->type_name("OUT");
  auto* turntable =
      text_option(app, "--turntable", "N", "N pictures once around the scene, at --time", [&](const std::string& text) {
        const auto count = number<std::uint32_t>(text);
        if (!count || *count < 2 || *count > 100000)
          throw CLI::ValidationError("--turntable", "'" + text + "' is not a number from 2 to 100000");
        options.turntable = *count;
      });
  auto* sheet =
      app.add_option("--sheet", options.sheet,
                     "write all clips to one picture OUT.png: a row each, five poses; --size is that of a pose")
          ->type_name("OUT");
  auto* compare = app.add_option("--compare", options.compare,
                                 "two to four views side by side, and below each how far its vertices are from the "
                                 "first as colours: linear, dual-quaternion, center-of-rotation, compiled=MM with "
                                 "commas between; or files: those of the command line")
                      ->type_name("VIEWS");
  frames->excludes(time)->excludes(turntable);
  film->excludes(headless)->excludes(sheet);
  sheet->excludes(headless)->excludes(frames)->excludes(turntable)->excludes(time)->excludes(compare);
  exit_after->excludes(headless)->excludes(film)->excludes(sheet);
  watch->excludes(film)->excludes(sheet);
  transparent->excludes(film);
  plan->needs(headless);
  compare->excludes(plan);
  transparent->needs(headless);
}

void check_outputs(const CLI::App& app, Options& options) {
  if (!options.film.empty()) options.headless = options.film;
  if (!options.sheet.empty()) {
    options.headless = options.sheet;
    if (app.count("--size") == 0) {
      options.width = kSheetCellWidth;
      options.height = kSheetCellHeight;
    }
  }
  if (options.headless.empty())
    for (const auto& [is_given, name] :
         {std::pair(options.frames.has_value(), "--frames"), std::pair(options.turntable > 0, "--turntable"),
          std::pair(!options.compare.empty(), "--compare")})
      if (is_given) throw CLI::ValidationError(name, "it needs --headless or --film: there is nothing to write");
  if (app.count("--fps") > 0 && !options.is_sequence())
    throw CLI::ValidationError("--fps", "it is the rate of --frames, or of a film of --turntable");
  if (!options.film.empty() && !names_film(options.film))
    throw CLI::ValidationError("--film", "'" + options.film + "' does not end in .mp4, .webm or .gif");
  if (!options.film.empty() && !options.is_sequence())
    throw CLI::ValidationError("--film", "a film needs --frames FIRST:LAST or --turntable N");
  if (!options.sheet.empty() && !names_png(options.sheet))
    throw CLI::ValidationError("--sheet", "'" + options.sheet + "' does not end in .png");
  if (options.headless.empty() || !options.film.empty()) return;
  if (options.is_sequence() && names_png(options.headless))
    throw CLI::ValidationError("--headless", "'" + options.headless + "' is one picture, " +
                                                 (options.frames ? "--frames" : "--turntable") +
                                                 " needs a folder: DIR/");
  if (!options.is_sequence() && !names_png(options.headless))
    throw CLI::ValidationError(
        "--headless",
        "'" + options.headless + "' does not end in .png; for a folder of pictures add --frames FIRST:LAST --fps N");
}

}  // namespace sinew::viewer
