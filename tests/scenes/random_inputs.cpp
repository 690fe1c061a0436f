// SPDX-License-Identifier: MIT
#include "tests/scenes/random_inputs.h"

#include <algorithm>
#include <iterator>

#include "runtime/base/same_bits.h"
#include "runtime/paging/cut_clip.h"
#include "runtime/paging/page_table.h"
#include "tests/scenes/random_scene.h"

namespace sinew::test {
namespace {

constexpr std::size_t kMostLayers = 5;

/// Includes both zeros, times before and after the clips, and repeated instants.
double some_time(FixedRandom& random) {
  constexpr double kTimes[] = {0.0, -0.0, 0.25, 0.5, 0.5, 0.75, 1.0, 1.9, 2.0, 3.0, -1.0};
  return kTimes[random.below(std::size(kTimes))];
}

float some_weight(FixedRandom& random) {
  constexpr float kWeights[] = {0.0f, 0.25f, 0.5f, 1.0f, 1.0f, 1.0f, 2.0f};
  return kWeights[random.below(std::size(kWeights))];
}

WeightTrack random_numbers(FixedRandom& random, Interpolation interpolation, std::uint32_t count) {
  WeightTrack track{interpolation, {0.0f, 0.7f, 2.0f}, {}, count};
  const std::size_t per_key = count * (interpolation == Interpolation::cubic_spline ? 3 : 1);
  for (std::size_t i = 0; i < 3 * per_key; ++i) track.values.push_back(static_cast<float>(random.in(-1, 2)));
  return track;
}

/// A material whose colour and roughness change, and a joint that is visible only part of the time.
void animate_properties(Scene& scene, FixedRandom& random) {
  scene.materials.resize(1);
  for (Animation& animation : scene.animations)
    animation.properties = {{{PropertyKind::base_color, 0}, random_numbers(random, Interpolation::linear, 4)},
                            {{PropertyKind::roughness, 0}, random_numbers(random, Interpolation::cubic_spline, 1)}};
  const std::uint32_t joint = 1 + random.below(static_cast<std::uint32_t>(scene.skeleton.joint_count()) - 1);
  std::vector<PropertyTrack>& first = scene.animations[0].properties;
  first.insert(first.begin(),
               {{PropertyKind::node_visible, joint}, {Interpolation::step, {0.0f, 0.6f}, {0.0f, 1.0f}, 1}});
}

constexpr double kPage_s = 0.4;

/// All clips cut into pages; empty if the clips have fewer joints than the scene (skeleton LOD).
std::vector<std::vector<Clip>> cut_pages(const Plan& plan) {
  std::vector<std::vector<Clip>> pages;
  if (!plan.needs().out.skeleton_lod.kept.empty()) return pages;
  for (const Clip& clip : plan.scene().clips) {
    std::vector<Clip>& of_clip = pages.emplace_back();
    const std::size_t count = page_count_of(clip.duration_s(), kPage_s);
    for (std::size_t page = 0; page < count; ++page) of_clip.push_back(cut_page(clip, kPage_s, page));
  }
  return pages;
}

bool is_out_of_view(const std::vector<std::uint8_t>& flags, std::size_t instance) {
  return !flags.empty() && flags[instance] != 0;
}

}  // namespace

RandomInputs::RandomInputs(const Plan& plan)
    : plan_(plan),
      pages_(std::make_shared<const std::vector<std::vector<Clip>>>(cut_pages(plan))),
      sources_(std::make_shared<Sources>(Sources{WavingVertices(plan.scene(), 11), WavingVertices(plan.scene(), 12),
                                                 WavingVertices(plan.scene(), 11)})),
      playing_(plan.needs().in.cached_instances.size()) {
  WavingVertices& other = (*sources_)[1];
  other.space = VertexSpace::mesh;
  other.has_normals = true;
  other.there_until = 1.9;
}

ClipLayer RandomInputs::some_layer(FixedRandom& random) const {
  ClipLayer layer{random.below(static_cast<std::uint32_t>(plan_.clip_tracks().size())), some_time(random)};
  layer.weight = some_weight(random);
  return layer;
}

void RandomInputs::change_layer(ClipLayer& layer, FixedRandom& random) {
  const auto masks = static_cast<std::uint32_t>(plan_.needs().in.masks.size());
  switch (random.below(6)) {
    case 0: layer.clip = some_layer(random).clip; break;
    case 1: layer.weight = some_weight(random); break;
    case 2: layer.mask = masks == 0 || random.below(2) == 0 ? kNone : random.below(masks); break;
    case 3: {
      const std::uint32_t kind = random.below(6);
      layer.kind = static_cast<LayerKind>(kind % 3);
      layer.mirrored = kind >= 3;
      break;
    }
    default: layer.time_s = some_time(random);
  }
}

void RandomInputs::change_layers(Layers& layers, FixedRandom& random) {
  const auto count = static_cast<std::uint32_t>(layers.size());
  switch (random.below(6)) {
    case 0:
      if (count < kMostLayers) layers.insert(layers.begin() + random.below(count + 1), some_layer(random));
      break;
    case 1:
      if (count > 0) layers.erase(layers.begin() + random.below(count));
      break;
    case 2:
      if (count > 1) std::swap(layers[0], layers[1 + random.below(count - 1)]);
      break;
    case 3: layers.assign(1, {random.below(2), some_time(random)}); break;
    default:
      if (count > 0) change_layer(layers[random.below(count)], random);
  }
}

/// Moves as a character that is not evaluated each frame: to the next update, to a new next update, or between both.
void RandomInputs::move_between_updates(FixedRandom& random) {
  constexpr float kFactors[] = {0.0f, 0.25f, 0.5f, 1.0f};
  switch (random.below(5)) {
    case 0: layers_ = next_layers_; break;
    case 1:
      next_layers_ = layers_;
      for (ClipLayer& layer : next_layers_) layer.time_s += 0.25;
      break;
    case 2: change_layers(next_layers_, random); break;
    default: interpolation_factor_ = kFactors[random.below(std::size(kFactors))];
  }
}

void RandomInputs::change_weights(FixedRandom& random) {
  const std::size_t count = plan_.scene().weight_count();
  if (weights_.empty() || random.below(3) == 0)
    weights_.assign(random.below(2) == 0 ? 0 : count, 0.5f * static_cast<float>(random.below(3)));
  else
    weights_[random.below(static_cast<std::uint32_t>(count))] = 0.25f * static_cast<float>(random.below(5));
}

void RandomInputs::change_root(FixedRandom& random) {
  root_ = {};
  switch (random.below(4)) {
    case 0: root_.row[random.below(3)].w = 1.0f; break;
    case 1: root_.row[1].y = -1.0f; break;
    case 2: root_.row[2].z = 1.5f; break;
    default: break;
  }
}

void RandomInputs::change_view(FixedRandom& random) {
  if (random.below(3) == 0) return out_of_view_.clear();
  if (out_of_view_.empty()) out_of_view_.resize(plan_.scene().instances.size());
  std::uint8_t& flag = out_of_view_[random.below(static_cast<std::uint32_t>(out_of_view_.size()))];
  flag = flag == 0 ? 1 : 0;
}

/// The first and the last source have the same content, so swapping them must change nothing.
void RandomInputs::change_geometry(FixedRandom& random) {
  constexpr float kWeights[] = {0.0f, 0.25f, 0.5f, 1.0f, 1.0f, 1.0f};
  if (playing_.empty()) return;
  Playing& one = playing_[random.below(static_cast<std::uint32_t>(playing_.size()))];
  switch (random.below(4)) {
    case 0: one.source = random.below(4) == 0 ? kNone : random.below(3); break;
    case 1: one.weight = kWeights[random.below(std::size(kWeights))]; break;
    case 2:
      for (Playing& all : playing_) all = one;
      break;
    default: source_times_[random.below(3)] = some_time(random);
  }
}

void RandomInputs::set_geometry() {
  geometry_.assign(playing_.size(), {});
  for (std::size_t slot = 0; slot < playing_.size(); ++slot)
    if (const std::uint32_t source = playing_[slot].source; source != kNone)
      geometry_[slot] = {(*sources_)[source].source(), source_times_[source], playing_[slot].weight};
}

bool RandomInputs::is_seen_playing(std::size_t slot) const {
  return slot < geometry_.size() && geometry_[slot].plays() &&
         !is_out_of_view(out_of_view_, plan_.needs().in.cached_instances[slot]);
}

void RandomInputs::change_one_part(FixedRandom& random) {
  switch (random.below(14)) {
    case 13: paged_ = !paged_ && !pages_->empty(); break;
    case 10:
    case 11:
    case 12: change_geometry(random); break;
    case 0: change_weights(random); break;
    case 1: change_root(random); break;
    case 2:
    case 3: change_view(random); break;
    case 4: asleep_ = random.below(3) == 0; break;
    case 5:
    case 6:
      if (plan_.needs().in.between_updates) move_between_updates(random);
      break;
    default: change_layers(layers_, random);
  }
}

/// A plan without blending plays one clip in full; other plans blend up to max_layers.
void RandomInputs::make_valid(Layers& layers) const {
  const Needs& needs = plan_.needs();
  std::uint32_t active = 0;
  for (ClipLayer& layer : layers) {
    if (!needs.in.additive) layer.kind = LayerKind::blend;
    layer.mirrored &= needs.in.mirror != nullptr;
    if (layer.kind != LayerKind::blend || layer.weight == 0.0f) continue;
    if (++active > needs.in.max_layers)
      layer.weight = 0.0f;
    else if (needs.in.max_layers == 1)
      layer.weight = std::max(layer.weight, 1.0f);
  }
}

void RandomInputs::step(std::uint32_t seed) {
  FixedRandom random(seed);
  asleep_ = asleep_ && random.below(2) == 0;
  for (std::uint32_t changes = random.below(4); changes > 0; --changes) change_one_part(random);
  make_valid(layers_);
  make_valid(next_layers_);
  set_pages(layers_);
  set_pages(next_layers_);
  set_geometry();
}

void RandomInputs::set_pages(Layers& layers) const {
  for (ClipLayer& layer : layers) {
    layer.page = nullptr;
    if (!paged_) continue;
    const std::vector<Clip>& pages = (*pages_)[layer.clip];
    layer.page = &pages[page_at(layer.time_s, kPage_s, pages.size())];
  }
}

RandomInputs RandomInputs::without_pages() const {
  RandomInputs whole = *this;
  for (Layers* layers : {&whole.layers_, &whole.next_layers_})
    for (ClipLayer& layer : *layers) layer.page = nullptr;
  return whole;
}

FrameInput RandomInputs::view() const {
  return {.layers = layers_,
          .weights = weights_,
          .root = root_,
          .next_layers = next_layers_,
          .interpolation_factor = interpolation_factor_,
          .out_of_view = out_of_view_,
          .geometry = geometry_,
          .asleep = asleep_};
}

bool means_the_same(const RandomInputs& a, const RandomInputs& b) {
  if (a.asleep_ || b.asleep_) return a.asleep_ == b.asleep_;
  const bool reached = a.interpolation_factor_ != 0.0f;
  for (std::size_t i = 0; i < std::max(a.out_of_view_.size(), b.out_of_view_.size()); ++i)
    if (is_out_of_view(a.out_of_view_, i) != is_out_of_view(b.out_of_view_, i)) return false;
  for (std::size_t slot = 0; slot < a.playing_.size(); ++slot) {
    if (a.is_seen_playing(slot) != b.is_seen_playing(slot)) return false;
    if (a.is_seen_playing(slot) && !same_geometry(a.geometry_[slot], b.geometry_[slot])) return false;
  }
  return same_layers(a.layers_, b.layers_) && same_bits<float>(a.weights_, b.weights_) && same_bits(a.root_, b.root_) &&
         same_bits(a.interpolation_factor_, b.interpolation_factor_) &&
         (!reached || same_layers(a.next_layers_, b.next_layers_));
}

Scene busy_scene(std::uint64_t seed) {
  FixedRandom random(seed);
  RandomSceneOptions options;
  options.skins = random.below(3);
  options.targets = random.below(3);
  options.triangles = 8;
  options.clips = 2 + random.below(2);
  options.flat_normals = random.below(2) == 0;
  options.centers = true;
  options.mirrored_joints = random.below(3) == 0;
  options.combinations = random.below(2) * 3;
  options.correctives = options.targets > 0 ? random.below(2) : 0;
  Scene scene = random_scene(seed, options);
  if (random.below(3) == 0) move_few_joints(scene);
  if (random.below(2) == 0) animate_properties(scene, random);
  if (random.below(4) == 0)
    scene.hidden_joints = {random.below(static_cast<std::uint32_t>(scene.skeleton.joint_count()))};
  scene.clips.clear();
  finish_scene(scene);
  return scene;
}

MirrorMap some_mirror(const Scene& scene) {
  MirrorOptions options;
  const std::vector<std::uint32_t>& parents = scene.skeleton.parents;
  for (std::uint32_t j = 1; j < parents.size(); ++j)
    if (parents[j] == parents[j - 1] && (options.pairs.empty() || options.pairs.back()[1] != j - 1))
      options.pairs.push_back({j - 1, j});
  MirrorMap map = make_mirror_map(scene.skeleton, options);
  for (std::size_t i = 0; i < scene.instances.size(); ++i)
    for (std::uint32_t w = scene.first_weight[i]; w < scene.first_weight[i + 1]; ++w)
      map.weight_source.push_back(scene.first_weight[i] + scene.first_weight[i + 1] - 1 - w);
  return map;
}

Needs busy_needs(std::uint64_t seed, const Scene& scene) {
  FixedRandom random(seed);
  Needs needs;
  needs.out.positions = random.below(5) > 0;
  needs.out.normals = random.below(4) > 0;
  needs.out.bounds = random.below(2) == 0;
  needs.out.palettes = random.below(2) == 0;
  needs.out.hidden_meshes = random.below(4) == 0;
  needs.in.additive = random.below(2) == 0;
  needs.in.max_additive_layers = 1 + random.below(3);
  needs.in.max_layers = 1 + random.below(3);
  needs.in.between_updates = random.below(2) == 0;
  needs.skin.kind = static_cast<Skinning>(random.below(3));
  needs.skin.normal_rule = random.below(2) == 0 ? NormalRule::linear : NormalRule::cofactor;
  for (std::uint32_t m = random.below(3); m > 0; --m) {
    std::vector<float>& mask = needs.in.masks.emplace_back(scene.skeleton.joint_count());
    for (float& weight : mask) weight = 0.5f * static_cast<float>(random.below(3));
  }
  needs.out.joints = random.below(6) > 0;
  needs.out.tangents = random.below(4) > 0;
  needs.out.tangents_of_all = random.below(4) == 0;
  needs.out.weights = random.below(4) > 0;
  needs.out.properties = random.below(4) > 0;
  for (std::size_t i = random.below(3) == 0 ? scene.instances.size() : 0; i > 0; --i)
    needs.skin.per_instance.push_back(static_cast<Skinning>(random.below(3)));
  if (seed % 2 == 0) needs.in.mirror = std::make_shared<const MirrorMap>(some_mirror(scene));
  if (random.below(2) == 0) return needs;
  for (std::uint32_t i = 0; i < scene.instances.size(); ++i)
    if (random.below(3) > 0) needs.in.cached_instances.push_back(i);
  return needs;
}

}  // namespace sinew::test
