// SPDX-License-Identifier: MIT
#include "viewer/app/reload/scene_reloader.h"

#include <utility>

namespace sinew::viewer {
namespace fs = std::filesystem;

SceneReloader::SceneReloader(const fs::path& file) : files_{stamp_key(file)} {
  folder_ = files_.front().parent_path();
  before_ = stamps_of(files_);
  add_stamps_in(folder_, before_);
}

void SceneReloader::was_read(std::span<const fs::path> files) {
  files_.clear();
  for (const fs::path& file : files) files_.push_back(stamp_key(file));
  failed_ = false;
  FileStamps read = stamps_of(files_);
  for (const fs::path& file : files_)
    if (const auto known = before_.find(file); known != before_.end()) read.insert_or_assign(file, known->second);
  watch_.was_read(std::move(read));
}

FileStamps SceneReloader::stamps() const {
  FileStamps stamps = stamps_of(files_);
  if (!failed_) return stamps;
  FileStamps beside;
  add_stamps_in(folder_, beside);
  for (const auto& [file, stamp] : beside)
    if (ignored_.count(file) == 0) stamps.emplace(file, stamp);
  return stamps;
}

void SceneReloader::fail() {
  if (!failed_) {
    ignored_.clear();
    for (const auto& [file, stamp] : before_) ignored_.insert(file);
    for (const fs::path& file : files_) ignored_.erase(file);
  }
  failed_ = true;
  std::erase_if(before_, [this](const auto& known) { return ignored_.count(known.first) > 0; });
  watch_.was_read(before_);
}

void SceneReloader::look(double now_s, const std::function<BackgroundReload::Read()>& make_read) {
  if (read_.running() || !watch_.due(now_s) || !watch_.look(now_s, stamps())) return;
  before_ = stamps_of(files_);
  add_stamps_in(folder_, before_);
  read_.begin(make_read());
}

std::optional<ReloadResult> SceneReloader::take() {
  auto read = read_.take();
  if (!read) return std::nullopt;
  if (read->loaded)
    was_read(read->loaded->files);
  else
    fail();
  return read;
}

}  // namespace sinew::viewer
