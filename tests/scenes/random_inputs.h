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

/// The input of a character that an engine drives: each step changes few parts of it, so that frames in a row share
/// layers, weights, the root or all of it, in every combination. Always valid for its plan.
class RandomInputs {
 public:
  /// in   plan  of a scene with two clips or more
  explicit RandomInputs(const Plan& plan);

  /// Changes none to three parts. The same seeds give the same inputs on every machine.
  void step(std::uint32_t seed);

  /// Views of this object, valid until the next step.
  FrameInput view() const;

  /// The same with every layer from its whole clip instead of a page of it.
  RandomInputs without_pages() const;

  /// Whether frames cannot tell the inputs apart: numbers by their bits, a character asleep is asleep, layers that
  /// are not reached do not count, an empty list of what is out of view says that all is in view, and what is out of
  /// view plays nothing.
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

  /// What a mesh instance plays: a source, none or one that weighs nothing.
  struct Playing {
    std::uint32_t source = kNone;
    float weight = 1.0f;
  };
  using Sources = std::array<WavingVertices, 3>;
  bool is_seen_playing(std::size_t slot) const;

  Plan plan_;
  std::shared_ptr<const std::vector<std::vector<Clip>>> pages_;  ///< [clips][pages]; empty where pages may not play
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

/// A scene of every kind of data that frames evaluate: joints, some of which no clip moves, morph targets, materials
/// and visibility that clips animate, correctives, flat normals. What it has of these depends on the seed.
Scene busy_scene(std::uint64_t seed);

/// A mirror of a scene that is not symmetric: neighbours under one parent are partners, and so are the first and the
/// last morph target of each instance.
MirrorMap some_mirror(const Scene& scene);

/// What a consumer may ask of a busy scene; depends on the seed.
Needs busy_needs(std::uint64_t seed, const Scene& scene);

}  // namespace sinew::test
