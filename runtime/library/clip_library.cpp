// SPDX-License-Identifier: MIT
#include "runtime/library/clip_library.h"

#include <algorithm>
#include <utility>

namespace sinew {

Unbound ClipLibrary::add(const Scene& file, IfUnbound if_unbound) {
  return add(file.clips, clip_channels(file), if_unbound);
}

Unbound ClipLibrary::add(std::span<const Clip> clips, const ClipChannels& from, IfUnbound if_unbound) {
  ClipChannels to = channels_;
  to.weights = from.weights;
  to.numbers = from.numbers;
  to.rest.weights = from.rest.weights;
  to.rest.properties = from.rest.properties;
  if (!clips.empty()) share_rest(clips.front(), to.rest);
  BoundClips bound = bind_clips(clips, from, to);
  if (if_unbound == IfUnbound::refuse && !bound.unbound.empty()) return std::move(bound.unbound);
  clips_.insert(clips_.end(), bound.clips.begin(), bound.clips.end());
  files_.push_back({clips_.size(), std::move(to)});
  return std::move(bound.unbound);
}

std::optional<std::uint32_t> ClipLibrary::find(std::string_view name) const noexcept {
  const auto is_it = [=](const Clip& clip) { return clip.name() == name; };
  const auto found = std::find_if(clips_.begin(), clips_.end(), is_it);
  if (found == clips_.end() || std::find_if(found + 1, clips_.end(), is_it) != clips_.end()) return std::nullopt;
  return static_cast<std::uint32_t>(found - clips_.begin());
}

BoundClips clips_for(const ClipLibrary& library, const Scene& scene) {
  const ClipChannels to = clip_channels(scene);
  BoundClips all;
  std::size_t begin = 0;
  for (const ClipLibrary::File& file : library.files_) {
    const std::span<const Clip> clips = std::span(library.clips_).subspan(begin, file.end - begin);
    const BoundClips bound = bind_clips(clips, file.channels, to);
    all.clips.insert(all.clips.end(), bound.clips.begin(), bound.clips.end());
    all.unbound.add(bound.unbound);
    begin = file.end;
  }
  return all;
}

}  // namespace sinew
