// SPDX-License-Identifier: MIT
#include "viewer/app/open/dropped_files.h"

#include <chrono>
#include <new>
#include <utility>

#include "viewer/app/load_environment.h"
#include "viewer/app/open/add_clips.h"
#include "viewer/app/open/file_names.h"

namespace sinew::viewer {
namespace {

void append(OpenedFiles from, OpenedFiles& to) {
  for (LoadedScene& character : from.characters) to.characters.push_back(std::move(character));
  for (LoadedScene& clips : from.clips) to.clips.push_back(std::move(clips));
  for (std::string& cache : from.caches) to.caches.push_back(std::move(cache));
}

}  // namespace

DroppedFiles open_dropped(const std::vector<std::string>& paths, const Options& asked) {
  DroppedFiles dropped;
  Options options = asked;
  options.scene.reset();
  const auto note = [&](const std::string& line) { dropped.messages.push_back(line); };
  const std::vector<std::string> files = expand_folders(paths);
  if (files.empty()) note("the folder has no file that can be shown");
  for (const std::string& file : files) {
    try {
      if (names_panorama(file)) {
        auto environment = load_environment(file, options.disk_cache);
        if (environment)
          dropped.environment = *std::move(environment);
        else
          note(environment.error());
        continue;
      }
      auto opened = open_files(
          {file}, options, [](const std::string&) {}, nullptr);  // scenes keep their messages
      if (opened)
        append(*std::move(opened), dropped.files);
      else
        note(opened.error().message);
    } catch (const std::bad_alloc&) {
      note(file + ": out of memory");
    }
  }
  return dropped;
}

void FileDrop::add(std::vector<std::string> paths) {
  for (std::string& path : paths) waiting_.push_back(std::move(path));
}

std::optional<DroppedFiles> FileDrop::follow(const Options& options) {
  if (!running() && !waiting_.empty())
    result_ = std::async(std::launch::async,
                         [paths = std::exchange(waiting_, {}), options] { return open_dropped(paths, options); });
  if (!running() || result_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return std::nullopt;
  return result_.get();
}

DropOutcome apply_dropped(DroppedFiles dropped, const LoadedScene& shown, const Options& options) {
  DropOutcome outcome;
  outcome.messages = std::move(dropped.messages);
  OpenedFiles& files = dropped.files;
  const auto note = [&](const std::string& line) { outcome.messages.push_back(line); };
  if (!files.characters.empty() || shown.scene.skeleton.joint_count() == 0) {
    auto scenes = combine_files(std::move(files), [](const std::string&) {});
    if (!scenes) {
      note(scenes.error().message);
      return outcome;
    }
    outcome.new_scenes = std::move(*scenes);
    for (LoadedScene& loaded : outcome.new_scenes) (void)prepare_rig(loaded, options, false, [](const std::string&) {});
    return outcome;
  }
  if (files.clips.empty() && files.caches.empty()) return outcome;
  LoadedScene changed = shown;
  const auto own = [&](const std::string& line) { changed.messages.push_back(line); };
  for (const LoadedScene& clips : files.clips) {
    add_clips(clips, changed, own);
    outcome.added_files.push_back(clips.files.front().string());
  }
  const auto clip_count = static_cast<std::uint32_t>(shown.scene.animations.size());
  if (changed.scene.animations.size() > clip_count) outcome.new_clip = clip_count;
  for (const std::string& cache : files.caches) {
    if (auto done = play_cache(cache, changed, own))
      outcome.added_files.push_back(cache);
    else
      note(done.error().message);
  }
  if (auto done = prepare_rig(changed, options, shown.rig && shown.rig->graph, [](const std::string&) {}); !done)
    note(done.error().message);
  outcome.changed = std::move(changed);
  return outcome;
}

}  // namespace sinew::viewer
