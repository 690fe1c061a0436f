// SPDX-License-Identifier: MIT
#include "importer/read/memory_budget.h"

#include <algorithm>
#include <string>
#include <vector>

#include "importer/read/accessor.h"
#include "importer/read/json_member.h"
#include "importer/read/mesh_copies.h"
#include "importer/read/property_pointer.h"
#include "runtime/clip/clip_layout.h"
#include "runtime/model/scene.h"

namespace sinew {
namespace {

class Budget {
 public:
  explicit Budget(const gltf::Document& document) : document_(document) {}

  /// Adds an accessor; components count as floats, because attributes are converted to float.
  void add(std::uint32_t accessor, std::uint64_t times = 1) {
    if (accessor == kNone) return;
    const auto& source = document_.accessors[accessor];
    const std::uint64_t count = std::min(source.count, kHuge);
    total_ = std::min(kHuge, total_ + count * element_layout(source).components() * 4 * times);
  }

  /// Adds `count` elements of `size` bytes.   in   both at most 2^32
  void add_bytes(std::uint64_t count, std::uint64_t size) { total_ = std::min(kHuge, total_ + count * size); }

  std::uint64_t total() const noexcept { return total_; }

 private:
  static constexpr std::uint64_t kHuge = std::uint64_t{1} << 48;
  const gltf::Document& document_;
  std::uint64_t total_ = 0;
};

/// Number of nodes that a channel animates; each gets its own track.
class Users {
 public:
  explicit Users(const gltf::Document& document)
      : document_(document), meshes_(document.meshes.size()), cameras_(document.cameras.size()) {
    for (const auto& node : document.nodes) {
      if (node.mesh != gltf::kAbsent) ++meshes_[node.mesh];
      if (node.camera != gltf::kAbsent) ++cameras_[node.camera];
      lights_ += node.extensions.is_object() && node.extensions.contains("KHR_lights_punctual");
    }
  }

  std::uint64_t of(const gltf::AnimationChannel& channel) const {
    if (channel.path != "pointer") return 1;
    PointerFault ignored_fault;
    const auto pointed = read_property_pointer(document_, channel.pointer, ignored_fault);
    if (!pointed) return 1;
    switch (pointed->list) {
      case PointedProperty::List::meshes: return meshes_[pointed->index];
      case PointedProperty::List::cameras: return cameras_[pointed->index];
      case PointedProperty::List::lights: return lights_;
      case PointedProperty::List::nodes:
      case PointedProperty::List::materials: break;
    }
    return 1;
  }

 private:
  const gltf::Document& document_;
  std::vector<std::uint64_t> meshes_, cameras_;
  std::uint64_t lights_ = 0;
};

std::size_t target_count(const gltf::Mesh& mesh) {
  std::size_t count = 0;
  for (const auto& primitive : mesh.primitives) count = std::max(count, primitive.targets.size());
  return count;
}

/// Adds copies of cameras and lights that several nodes use, including their names.
void add_placements(const gltf::Document& document, Budget& budget) {
  const gltf::Json* lights = member(member(&document.extensions, "KHR_lights_punctual"), "lights");
  const std::size_t light_count = lights != nullptr && lights->is_array() ? lights->size() : 0;
  for (const auto& node : document.nodes) {
    if (node.camera != gltf::kAbsent) budget.add_bytes(1, sizeof(Camera));
    const gltf::Json* use = member(member(&node.extensions, "KHR_lights_punctual"), "light");
    if (index_below(use, light_count) != kNone) budget.add_bytes(1, sizeof(Light));
  }
}

/// Adds products of lists: targets times primitives, weights times nodes. Each clip stores only what its channels
/// animate, both as authored and compiled.
void add_products(const gltf::Document& document, const Users& users, Budget& budget) {
  constexpr std::uint64_t kProperty = 4 * sizeof(float);
  constexpr std::uint64_t kJoint =
      2 * sizeof(Transform) + sizeof(std::string) + 4 * sizeof(std::uint32_t);  // rest pose in two layouts; name
  constexpr std::uint64_t kClip = sizeof(Animation) + sizeof(ClipLayout);
  constexpr std::uint64_t kTrack = sizeof(BoneAnimation) + sizeof(TimeGroup) + sizeof(TrackBlock);
  std::vector<std::size_t> targets;
  for (const auto& mesh : document.meshes) {
    targets.push_back(target_count(mesh));
    budget.add_bytes(mesh.primitives.size() * targets.back(), sizeof(MorphTarget));
  }
  std::uint64_t weights = 0, properties = 0;
  for (const auto& node : document.nodes)
    if (node.mesh != gltf::kAbsent) weights += targets[node.mesh];
  std::uint64_t tracks = 0;
  for (const auto& animation : document.animations)
    for (const auto& channel : animation.channels) {
      tracks += users.of(channel);
      if (channel.path == "pointer") properties += users.of(channel);
    }
  budget.add_bytes(document.nodes.size(), kJoint);
  budget.add_bytes(document.animations.size(), kClip);
  budget.add_bytes(std::min(tracks, std::uint64_t{1} << 32), kTrack);
  budget.add_bytes(3 * std::min(weights, std::uint64_t{1} << 32), sizeof(float));
  budget.add_bytes(2 * std::min(properties, std::uint64_t{1} << 32), kProperty);
  add_placements(document, budget);
}

}  // namespace

std::uint64_t allowed_bytes(std::uint64_t file_bytes, std::uint64_t most) noexcept {
  constexpr std::uint64_t kFree = std::uint64_t{64} << 20;
  constexpr std::uint64_t kPerByte = 64;
  return std::min(most, kFree + kPerByte * std::min(file_bytes, std::uint64_t{1} << 40));
}

void check_memory_budget(const gltf::Document& document, std::uint64_t file_bytes, std::uint64_t most, IssueLog& log) {
  Budget budget(document);
  for (const auto& mesh : document.meshes)
    for (const auto& primitive : mesh.primitives) {
      for (const auto& [name, accessor] : primitive.attributes) budget.add(accessor);
      for (const auto& target : primitive.targets)
        for (const auto& [name, accessor] : target) budget.add(accessor);
      budget.add(primitive.indices, 3);  // unrolling a strip triples its length
    }
  const Users users(document);
  add_products(document, users, budget);
  for (const auto& animation : document.animations)
    for (const auto& channel : animation.channels) {
      if (channel.sampler == kNone) continue;  // the channel was left out
      budget.add(animation.samplers[channel.sampler].input, users.of(channel));
      budget.add(animation.samplers[channel.sampler].output, users.of(channel));
    }
  IssueLog discarded_log;  // build_instances reports these issues
  for (std::uint32_t n = 0; n < document.nodes.size(); ++n)
    for (const auto& [name, accessor] : copy_attributes(document, n, discarded_log)) budget.add(accessor, 3);
  for (const auto& skin : document.skins) budget.add(skin.inverseBindMatrices);
  const std::uint64_t allowed = allowed_bytes(file_bytes, most);
  if (budget.total() > allowed)
    log.report(Rule::memory_budget, "",
               "what it describes would take " + std::to_string(budget.total()) + " bytes, a file of " +
                   std::to_string(file_bytes) + " bytes may take " + std::to_string(allowed));
}

}  // namespace sinew
