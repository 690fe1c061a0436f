// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <unordered_set>

#include "runtime/library/clip_library.h"
#include "runtime/plan/frame_buffer.h"

namespace sinew {

/// Heap bytes of assets and characters by kind, without the objects themselves.
struct MemoryBytes {
  std::size_t skeletons = 0;    ///< hierarchies, rest poses, names of joints
  std::size_t animations = 0;   ///< keys in authoring form
  std::size_t clip_keys = 0;    ///< times and values of compiled clips
  std::size_t clip_tables = 0;  ///< other tables of clips: targets, constants, rest values, names
  std::size_t skins = 0;        ///< bind matrices and joint lists
  std::size_t vertices = 0;     ///< attributes, influences and indices of meshes
  std::size_t morphs = 0;       ///< displacements and names of morph targets
  std::size_t images = 0;       ///< decoded and encoded pixels
  std::size_t others = 0;       ///< materials, lights, cameras, instances, correctives, names
  std::size_t plans = 0;        ///< tables of plans, without assets
  std::size_t frames = 0;       ///< blocks of frame buffers

  std::size_t total() const noexcept {
    return skeletons + animations + clip_keys + clip_tables + skins + vertices + morphs + images + others + plans +
           frames;
  }
};

/// Sums the memory of several assets and characters. Shared memory counts once: keys of clips, rest values, names,
/// plans.
/// cost O(arrays of the asset), allocates
class MemoryCount {
 public:
  MemoryCount& add(const Skeleton& skeleton);
  MemoryCount& add(const Clip& clip);
  MemoryCount& add(const ClipLibrary& library);  ///< including its clips
  MemoryCount& add(const Scene& scene);          ///< including skeleton, animations and clips
  MemoryCount& add(const Plan& plan);            ///< including its clips, without the scene
  MemoryCount& add(const FrameBuffer& frame);    ///< the block that it allocated, without the plan

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

/// The memory of one asset or character.
template <class Asset>
MemoryBytes memory_of(const Asset& asset) {
  return MemoryCount().add(asset).bytes();
}

}  // namespace sinew
