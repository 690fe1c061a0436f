// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "runtime/library/bind_clips.h"

namespace sinew {

/// What `ClipLibrary::add` does with clips that move what the skeleton does not have.
enum class IfUnbound : std::uint8_t { leave_out, refuse };

/// Clips of any number of files, bound to one skeleton. Scenes with models on that skeleton share it.
///
///     ClipLibrary library(body.skeleton);
///     library.add(walks);  // scenes of other files; what does not bind is listed
///     library.add(gestures);
///     // The same keys for a scene, with its own rest pose, weights and properties:
///     const BoundClips clips = clips_for(library, outfit);
///     const Plan plan = compile_plan(lend(outfit), clips.clips, needs);
///
/// Clips bind by the names of joints. Morph weights and properties keep their names, and bind to each scene on its own.
/// Where the skeleton of a file rests otherwise than that of the library, joints that a clip does not move rest as the
/// library says; what it moves has its local transforms as they are. A clip of the same skeleton and rest pose is the
/// same handle: it takes no memory, and poses have the same bits.
///
/// A library is a value. Copies share clips, so that a copy before each addition is a version of its own, and layers
/// name clips by index: those of a version keep theirs in later ones. Plans share the clips that they were compiled
/// for. They need neither the library nor its next version: new plans are compiled for that, while old frames go on
/// with theirs.
class ClipLibrary {
 public:
  /// cost O(J), allocates
  explicit ClipLibrary(const Skeleton& skeleton) : channels_(clip_channels(skeleton)) {}

  /// Adds all clips of a scene, or those given, in their order; with IfUnbound::refuse none when some do not bind as a
  /// whole.
  /// in   clips  compiled for `from`: clips of a scene have clip_channels(scene)
  /// out  what does not bind
  /// cost O(names + clips * (joints + weights + numbers)), allocates
  Unbound add(const Scene& file, IfUnbound if_unbound = IfUnbound::leave_out);
  Unbound add(std::span<const Clip> clips, const ClipChannels& from, IfUnbound if_unbound = IfUnbound::leave_out);

  std::size_t size() const noexcept { return clips_.size(); }

  /// Bound to the library's skeleton, with the morph weights and properties of their files.
  const Clip& operator[](std::size_t index) const noexcept { return clips_[index]; }

  /// The one clip of that name; nothing where there is none, and where there are several.     cost O(clips)
  std::optional<std::uint32_t> find(std::string_view name) const noexcept;

  std::uint64_t signature() const noexcept { return channels_.signature; }

 private:
  friend BoundClips clips_for(const ClipLibrary& library, const Scene& scene);
  friend class MemoryCount;

  /// Clips that were added at once, up to `end`.
  struct File {
    std::size_t end;
    ClipChannels channels;  ///< joints of the library, weights and numbers of the file
  };

  ClipChannels channels_;
  std::vector<Clip> clips_;
  std::vector<File> files_;
};

/// The clips of a library for a scene, in the library's order, as compile_plan takes them. They share the keys of the
/// library, unless joints or morph targets come in another order in the scene. Bodies of other sizes are scenes whose
/// skeleton rests otherwise.
/// out  what does not bind: morph weights and properties that only other outfits have are listed, too. Properties bind
///      where clips of the scene itself animate them (Scene::properties).
/// cost O(names + clips * (joints + weights + numbers)), allocates
BoundClips clips_for(const ClipLibrary& library, const Scene& scene);

}  // namespace sinew
