// SPDX-License-Identifier: MIT
#include "runtime/retarget/retarget_weights.h"

#include <algorithm>
#include <map>
#include <set>
#include <string_view>

#include "runtime/animation/track_sample.h"

namespace sinew {
namespace {

std::string_view target_name(const Scene& scene, std::size_t instance, std::size_t target) noexcept {
  const Mesh& mesh = scene.meshes[scene.instances[instance].mesh];
  return target < mesh.target_names.size() ? std::string_view(mesh.target_names[target]) : std::string_view{};
}

/// The letters and digits after the last dot, in lower case.
std::string key_of(std::string_view name) {
  std::string key;
  for (const char c : name) {
    if (c == '.') key.clear();
    if (c >= 'A' && c <= 'Z') key += static_cast<char>(c - 'A' + 'a');
    if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9')) key += c;
  }
  return key;
}

/// Calls body(instance, weight, name) for each morph weight of a scene.
template <class Body>
void for_each_weight(const Scene& scene, const Body& body) {
  for (std::size_t i = 0; i < scene.instances.size(); ++i)
    for (std::uint32_t w = scene.first_weight[i]; w < scene.first_weight[i + 1]; ++w)
      body(i, w, target_name(scene, i, w - scene.first_weight[i]));
}

const std::string& mesh_name(const Scene& scene, std::size_t instance) noexcept {
  return scene.meshes[scene.instances[instance].mesh].name;
}

struct NamedWeight {
  std::uint32_t weight = 0;
  std::size_t instance = 0;
};

/// A track of the source. For each morph target of an instance: the target of the track that drives it, or kNone.
struct FollowedTrack {
  const WeightAnimation* source = nullptr;
  std::vector<std::uint32_t> moved;
};

/// The tracks that an instance of the target follows.
std::vector<FollowedTrack> followed_tracks(const WeightMap& map, const Animation& animation, const Scene& source,
                                           std::span<const std::uint32_t> weights) {
  std::vector<FollowedTrack> followed;
  for (const WeightAnimation& track : animation.weights) {
    const std::uint32_t first = source.first_weight[track.instance] + track.first_target;
    FollowedTrack found{&track, std::vector<std::uint32_t>(weights.size(), kNone)};
    bool any = false;
    for (std::size_t t = 0; t < weights.size(); ++t) {
      const std::uint32_t from = map.source_of[weights[t]];
      if (from == kNone || from < first || from - first >= track.weights.target_count) continue;
      found.moved[t] = from - first;
      any = true;
    }
    if (any && !track.weights.empty()) followed.push_back(std::move(found));
  }
  return followed;
}

/// Copies the keys of a track into rows for all targets of the instance. Targets that it does not drive get rest
/// weights; their tangents are 0.
WeightTrack with_targets(const FollowedTrack& followed, std::span<const float> rest) {
  const WeightTrack& from = followed.source->weights;
  WeightTrack track{from.interpolation, from.times_s, {}, static_cast<std::uint32_t>(rest.size())};
  const std::size_t rows = from.values.size() / from.target_count;
  const bool cubic = from.interpolation == Interpolation::cubic_spline;
  for (std::size_t row = 0; row < rows; ++row)
    for (std::size_t t = 0; t < rest.size(); ++t) {
      const std::uint32_t moved = followed.moved[t];
      const float rests = cubic && row % 3 != 1 ? 0.0f : rest[t];
      track.values.push_back(moved == kNone ? rests : from.values[row * from.target_count + moved]);
    }
  return track;
}

WeightTrack sampled_together(std::span<const FollowedTrack> all, std::span<const float> rest) {
  std::set<float> times;
  for (const FollowedTrack& one : all)
    times.insert(one.source->weights.times_s.begin(), one.source->weights.times_s.end());
  WeightTrack track{Interpolation::linear, {times.begin(), times.end()}, {}, static_cast<std::uint32_t>(rest.size())};
  for (const float time_s : track.times_s) {
    std::vector<float> row(rest.begin(), rest.end());
    for (const FollowedTrack& one : all) {
      std::vector<float> weights(one.source->weights.target_count);
      sample_track<float>(one.source->weights, static_cast<double>(time_s), weights);
      for (std::size_t t = 0; t < row.size(); ++t)
        if (one.moved[t] != kNone) row[t] = weights[one.moved[t]];
    }
    track.values.insert(track.values.end(), row.begin(), row.end());
  }
  return track;
}

}  // namespace

WeightMap make_weight_map(const Scene& source, const Scene& target) {
  std::map<std::string, std::vector<NamedWeight>> by_name;
  for_each_weight(source, [&](std::size_t i, std::uint32_t w, std::string_view name) {
    by_name[key_of(name)].push_back({w, i});
  });
  by_name.erase("");
  WeightMap map{std::vector<std::uint32_t>(target.weight_count(), kNone), {}};
  std::set<std::string> found_names;
  for_each_weight(target, [&](std::size_t i, std::uint32_t w, std::string_view name) {
    const auto found = by_name.find(key_of(name));
    if (found == by_name.end()) return;
    const std::vector<NamedWeight>& all = found->second;
    const auto same_mesh = std::find_if(all.begin(), all.end(), [&](const NamedWeight& one) {
      return mesh_name(source, one.instance) == mesh_name(target, i);
    });
    map.source_of[w] = same_mesh != all.end() ? same_mesh->weight : all.front().weight;
    found_names.insert(found->first);
  });
  for_each_weight(source, [&](std::size_t, std::uint32_t, std::string_view name) {
    if (!name.empty() && found_names.insert(key_of(name)).second) map.not_found.emplace_back(name);
  });
  return map;
}

void retarget_weights(const WeightMap& map, std::span<const float> weights, std::span<float> out) noexcept {
  for (std::size_t w = 0; w < map.source_of.size(); ++w)
    if (map.source_of[w] != kNone) out[w] = weights[map.source_of[w]];
}

void retarget_weights(const WeightMap& map, const Animation& animation, const Scene& source, const Scene& target,
                      Animation& retargeted) {
  retargeted.weights.clear();
  for (std::uint32_t i = 0; i < target.instances.size(); ++i) {
    std::vector<std::uint32_t> weights;
    for (std::uint32_t w = target.first_weight[i]; w < target.first_weight[i + 1]; ++w) weights.push_back(w);
    const std::vector<FollowedTrack> followed = followed_tracks(map, animation, source, weights);
    if (followed.empty()) continue;
    const std::vector<float>& rest = target.instances[i].rest_weights;
    retargeted.weights.push_back(
        {i, followed.size() == 1 ? with_targets(followed[0], rest) : sampled_together(followed, rest)});
  }
}

}  // namespace sinew
