// SPDX-License-Identifier: MIT
#include "viewer/app/pictures/screenshot.h"

#include <cstdio>
#include <filesystem>

#include "viewer/app/headless.h"
#include "viewer/app/pictures/png_writer.h"
#include "viewer/upload/visibility_blend.h"

namespace sinew::viewer {
namespace {

constexpr int kMostScreenshots = 9999;

std::string free_name() {
  for (int number = 1; number <= kMostScreenshots; ++number) {
    char name[32];
    std::snprintf(name, sizeof(name), "sinew-%04d.png", number);
    std::error_code error;
    if (!std::filesystem::exists(name, error)) return name;
  }
  return {};
}

}  // namespace

std::string write_screenshot(Device& device, ShownScene& shown, const View& view, RenderOptions look,
                             const Settings& settings, VkExtent2D size, const TextureFilter& filter) {
  const std::string name = free_name();
  if (name.empty()) return "no screenshot: sinew-0001.png to sinew-9999.png exist";
  const LoadedScene& loaded = shown.loaded();
  look.smooth_edges = true;
  const FrameResult& pose = shown.newest();
  Headless headless(device, loaded.scene, size.width, size.height, {}, loaded.visibility.get(), filter);
  const VisibilityBlend visibility =
      loaded.visibility ? visibility_blend(*loaded.visibility, shown.playback().clip(), shown.playback().time_s())
                        : VisibilityBlend{};
  PngWriter writer;
  writer.write(name, headless.render(pose, view, look, shown.lines(settings.inspected, settings.skeleton),
                                     settings.variant, visibility));
  const auto failed = writer.finish();
  return failed.empty() ? name + ": written" : failed.front();
}

}  // namespace sinew::viewer
