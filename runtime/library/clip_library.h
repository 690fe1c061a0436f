// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "runtime/base/api.h"
#include "runtime/library/bind_clips.h"

namespace sinew {

/// For ClipLibrary::add: how to treat clips that move joints which the skeleton does not have.
enum class IfUnbound : std::uint8_t { leave_out, refuse };

/// Clips from any number of files, bound to one skeleton. All scenes with models on that skeleton can share it.
///
///     ClipLibrary library(body.skeleton);
///     library.add(walks);  // scenes of other files; returns the channels that do not bind
///     library.add(gestures);
///     const BoundClips clips = clips_for(library, outfit);  // same keys; rest values and weights of the outfit
///     const Plan plan = compile_plan(lend(outfit), clips.clips, needs);
///
/// Joints bind by name. Morph weights and properties keep their names, and bind to each scene separately. If the rest
/// pose of a file differs from the library's, joints that a clip does not move have the library's rest pose. Local
/// transforms of joints that it moves do not change. A clip from the same skeleton and rest pose is stored as the same
/// handle: it takes no memory, and its poses have the same bits.
///
/// A library is a value whose copies share clips, so a copy before each addition is a cheap version. Clips keep their
/// index in later versions. Plans keep alive the clips that they were compiled with, and do not need the library. So
/// new plans can be compiled with a new version while frames still run with the old one.
class SINEW_API ClipLibrary {
 public:
  /// cost O(J), allocates
  explicit ClipLibrary(const Skeleton& skeleton) : channels_(clip_channels(skeleton)) {}

  /// Adds all clips of a scene, or the given clips, in their order. With IfUnbound::refuse it adds none if a channel
  /// of any clip does not bind.
  /// in   clips  compiled for `from`; for clips of a scene that is clip_channels(scene)
  /// out  the channels that do not bind
  /// cost O(names + clips * (joints + weights + numbers)), allocates
  Unbound add(const Scene& file, IfUnbound if_unbound = IfUnbound::leave_out);
  Unbound add(std::span<const Clip> clips, const ClipChannels& from, IfUnbound if_unbound = IfUnbound::leave_out);

  std::size_t size() const noexcept { return clips_.size(); }

  /// A clip bound to the library's skeleton, with the morph weights and properties of its file.
  const Clip& operator[](std::size_t index) const noexcept { return clips_[index]; }

  /// The clip with that name; nullopt if there is none, or several.     cost O(clips)
  std::optional<std::uint32_t> find(std::string_view name) const noexcept;

  std::uint64_t signature() const noexcept { return channels_.signature; }

 private:
  friend BoundClips clips_for(const ClipLibrary& library, const Scene& scene);
  friend class MemoryCount;

  /// The clips of one call of add, up to `end`.
  struct File {
    std::size_t end;
    ClipChannels channels;  ///< joints of the library; weights and properties of the file
  };

  ClipChannels channels_;
  std::vector<Clip> clips_;
  std::vector<File> files_;
};

/// The clips of a library bound to a scene, in the library's order, for compile_plan. They share the keys of the
/// library, unless joints or morph targets have another order in the scene. A body of another size is a scene with
/// another rest pose.
/// out  the clips, and the channels that do not bind, including channels that only other outfits have. Properties bind
///      only if clips of the scene itself animate them (Scene::properties).
/// cost O(names + clips * (joints + weights + numbers)), allocates
SINEW_API BoundClips clips_for(const ClipLibrary& library, const Scene& scene);

}  // namespace sinew
