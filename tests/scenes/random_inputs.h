// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "runtime/plan/compile_plan.h"
#include "runtime/plan/frame_input.h"
#include "tests/scenes/waving_vertices.h"
#include "tests/support/fixed_random.h"

namespace sinew::test {

/// The changing input of a character, as an engine would drive it. Each step changes few parts, so that successive
/// frames share layers, weights, the root or everything, in any combination. Always valid for its plan.
class RandomInputs {
 public:
  /// in   plan  of a scene with at least two clips
  explicit RandomInputs(const Plan& plan);

  /// Changes up to three parts. The same seeds give the same inputs on every machine.
  void step(std::uint32_t seed);

  /// Views of this object, valid until the next step.
  FrameInput view() const;

  /// A copy in which every layer samples its whole clip instead of a page of it.
  RandomInputs without_pages() const;

  /// True if frames must come out equal for both inputs. Numbers are compared by their bits. Two sleeping characters
  /// are equal. With an interpolation factor of 0 the next layers do not count.
  /// An empty out-of-view list equals one in which everything is in view. Instances out of view play no geometry.
  friend bool means_the_same(const RandomInputs& a, const RandomInputs& b);

 private:
  using Layers = std::vector<ClipLayer>;

  void change_one_part(FixedRandom& random);
  void set_pages(Layers& layers) const;
  void change_layers(Layers& layers, FixedRandom& random);
  void change_layer(ClipLayer& layer, FixedRandom& random);
  void move_between_updates(FixedRandom& random);
  void change_weights(FixedRandom& random);
  void change_root(FixedRandom& random);
  void change_view(FixedRandom& random);
  void change_geometry(FixedRandom& random);
  void set_geometry();
  void make_valid(Layers& layers) const;
  ClipLayer some_layer(FixedRandom& random) const;

  /// The geometry that a mesh instance plays: a source, no source, or a source of weight zero.
  struct Playing {
    std::uint32_t source = kNone;
    float weight = 1.0f;
  };
  using Sources = std::array<WavingVertices, 3>;
  bool is_seen_playing(std::size_t slot) const;

  Plan plan_;
  std::shared_ptr<const std::vector<std::vector<Clip>>> pages_;  ///< [clips][pages]; empty without paging
  std::shared_ptr<Sources> sources_;                             ///< copies of the inputs share them, as characters do
  std::array<double, 3> source_times_{};
  std::vector<Playing> playing_;  ///< [cached instances]
  std::vector<GeometryInput> geometry_;
  Layers layers_, next_layers_;
  std::vector<float> weights_;
  std::vector<std::uint8_t> out_of_view_;
  Affine root_;
  float interpolation_factor_ = 0.0f;
  bool asleep_ = false, paged_ = false;
};

/// A scene with every kind of data that frames evaluate: morph targets, correctives, flat normals, animated materials
/// and visibility, and joints that no clip moves. The seed decides which of these it has.
Scene busy_scene(std::uint64_t seed);

/// A mirror map for an asymmetric scene. Siblings are partners, and so are the first and the last morph target of each
/// instance.
MirrorMap some_mirror(const Scene& scene);

/// Random needs that a busy scene can satisfy; they depend on the seed.
Needs busy_needs(std::uint64_t seed, const Scene& scene);

}  // namespace sinew::test
