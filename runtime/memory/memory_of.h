// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <unordered_set>

#include "runtime/library/clip_library.h"
#include "runtime/plan/compile_plan.h"
#include "runtime/plan/frame_buffer.h"

namespace sinew {

/// Bytes of assets and characters by kind: what they hold in memory of their own, beyond the objects themselves.
struct MemoryBytes {
  std::size_t skeletons = 0;    ///< hierarchies, rest poses, names of joints
  std::size_t animations = 0;   ///< keys in authoring form
  std::size_t clip_keys = 0;    ///< compiled: times and values
  std::size_t clip_tables = 0;  ///< which joints they move, constants, what is at rest, names
  std::size_t skins = 0;        ///< bind matrices and the joints that they are of
  std::size_t vertices = 0;     ///< attributes, influences and indices of meshes
  std::size_t morphs = 0;       ///< displacements of morph targets, names of targets
  std::size_t images = 0;       ///< decoded and encoded
  std::size_t others = 0;       ///< materials, lights, cameras, instances, correctives, names
  std::size_t plans = 0;        ///< tables of plans, without assets
  std::size_t frames = 0;       ///< blocks of frame buffers

  std::size_t total() const noexcept {
    return skeletons + animations + clip_keys + clip_tables + skins + vertices + morphs + images + others + plans +
           frames;
  }
};

/// Counts what several assets and characters hold together. What they share counts once: keys of clips, numbers at
/// rest, names, plans.
/// cost O(arrays of the asset), allocates
class MemoryCount {
 public:
  MemoryCount& add(const Skeleton& skeleton);
  MemoryCount& add(const Clip& clip);
  MemoryCount& add(const ClipLibrary& library);  ///< with its clips
  MemoryCount& add(const Scene& scene);          ///< with skeleton, animations and clips
  MemoryCount& add(const Plan& plan);            ///< with the clips that it shares, without the scene
  MemoryCount& add(const FrameBuffer& frame);    ///< the block that it took, without the plan

  const MemoryBytes& bytes() const noexcept { return bytes_; }

 private:
  bool is_new(const void* shared) { return shared != nullptr && seen_.insert(shared).second; }
  void add(const ClipChannels& channels);
  void add(const BaseNumbers& base);
  void add(const RestNumbers& rest);
  void add(const Mesh& mesh);

  MemoryBytes bytes_;
  std::unordered_set<const void*> seen_;
};

/// What one of them holds alone.
template <class Asset>
MemoryBytes memory_of(const Asset& asset) {
  return MemoryCount().add(asset).bytes();
}

}  // namespace sinew
