// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <memory>

#include <fmt/format.h>

#include "importer/tool/cost/skinned_part.h"
#include "importer/tool/cost/studies.h"
#include "importer/tool/cost/words.h"
#include "runtime/animation/track_sample.h"
#include "runtime/deform/morph_vertices.h"

namespace sinew::cost {
namespace {

using Weights = std::vector<float>;

/// The primitive with the most displacements, and the weights to test it with.
struct MorphedPart {
  const Primitive* primitive = nullptr;
  std::uint32_t instance = 0;
  std::vector<Weights> moments;
  bool animated = false;

  VertexInput in() const { return {primitive->positions, primitive->normals, {}}; }
};

std::size_t displacement_count(const Primitive& primitive) {
  std::size_t count = 0;
  for (const MorphTarget& target : primitive.morphs.targets)
    count += target.positions.vertices.size() + target.normals.vertices.size();
  return count;
}

/// Weights of an instance at times spread over the clip; empty if the clip does not animate them.
std::vector<Weights> animated_weights(const Subject& subject, std::uint32_t instance) {
  constexpr int kMoments = 16;
  std::vector<Weights> moments;
  if (subject.animation() == nullptr) return moments;
  for (const WeightAnimation& moved : subject.animation()->weights) {
    if (moved.instance != instance) continue;
    moments.resize(kMoments, subject.scene.instances[instance].rest_weights);
    for (int i = 0; i < kMoments; ++i)
      sample_track<float>(
          moved.weights, (i + 0.5) / kMoments * subject.animation()->duration_s,
          std::span(moments[static_cast<std::size_t>(i)]).subspan(moved.first_target, moved.weights.target_count));
  }
  return moments;
}

/// Weights for files whose clip animates none: one target in four at 0.5, one in four barely active.
Weights made_up_weights(std::size_t count) {
  Weights weights(count, 0.0f);
  for (std::size_t t = 0; t < count; ++t) weights[t] = t % 4 == 0 ? 0.5f : t % 4 == 1 ? 0.004f : 0.0f;
  return weights;
}

MorphedPart morphed_part(const Subject& subject) {
  MorphedPart part;
  std::size_t most = 0;
  for (std::uint32_t i = 0; i < subject.scene.instances.size(); ++i)
    for (const Primitive& primitive : subject.scene.meshes[subject.scene.instances[i].mesh].primitives)
      if (const std::size_t count = displacement_count(primitive); count > most) {
        most = count;
        part.primitive = &primitive;
        part.instance = i;
      }
  if (part.primitive == nullptr) return part;
  part.moments = animated_weights(subject, part.instance);
  part.animated = !part.moments.empty();
  if (!part.animated) part.moments.push_back(made_up_weights(part.primitive->morphs.targets.size()));
  return part;
}

/// Positions and unit normals in double precision.
PlainVertices<double> true_vertices(const Primitive& primitive, const Weights& weights) {
  PlainVertices<double> out;
  out.positions.assign(primitive.positions.begin(), primitive.positions.end());
  out.normals.assign(primitive.normals.begin(), primitive.normals.end());
  for (std::size_t t = 0; t < weights.size(); ++t) {
    const auto add = [&](const SparseDeltas<glm::vec3>& deltas, std::vector<Vec3<double>>& to) {
      for (std::size_t i = 0; i < deltas.vertices.size() && !to.empty(); ++i)
        to[deltas.vertices[i]] += static_cast<double>(weights[t]) * Vec3<double>(deltas.deltas[i]);
    };
    add(primitive.morphs.targets[t].positions, out.positions);
    add(primitive.morphs.targets[t].normals, out.normals);
  }
  for (auto& n : out.normals) n = normalised_or(n, Vec3<double>(0.0, 0.0, 1.0));
  return out;
}

struct MorphVariant {
  std::string name, note;
  std::function<float(float)> weight;  // replaces each weight
  bool normalise = true;
};

Weights changed(const Weights& weights, const MorphVariant& variant) {
  Weights out;
  for (const float w : weights) out.push_back(variant.weight(w));
  return out;
}

std::vector<MorphVariant> morph_variants() {
  // The smallest weight that the job does not treat as zero. It takes the full work and changes no digit of the sum.
  constexpr float kNothing = 2e-20f;
  const auto as_given = [](float w) { return w; };
  const auto from = [](float least) { return [least](float w) { return std::abs(w) < least ? 0.0f : w; }; };
  return {
      {"all targets", "also those of weight 0, as a shader with a fixed loop",
       [](float w) { return is_active_weight(w) ? w : kNothing; }},
      {"active targets", "those of weight 0 cost nothing", as_given},
      {"weights from 0.001", "smaller ones are left out", from(0.001f)},
      {"weights from 0.01", "smaller ones are left out", from(0.01f)},
      {"weights from 0.05", "smaller ones are left out", from(0.05f)},
      {"normals as summed", "active targets, normals not of length 1 again: for shaders that do it themselves",
       as_given, false},
  };
}

/// The largest distance of a vertex, and the largest difference of a normal. The latter is the angle of a chord of that
/// length, so that a wrong length counts too.
struct MorphError {
  double distance_mm = 0.0, normal_deg = 0.0;
};

double chord_deg(double chord) { return 2.0 * 57.29577951308232 * std::asin(std::min(1.0, 0.5 * chord)); }

MorphError error_of(const MorphedPart& part, const MorphVariant& variant) {
  const std::size_t count = part.primitive->vertex_count();
  DeformedVertices found(count);
  std::vector<glm::vec3> scratch(count);
  MorphError error;
  for (const Weights& weights : part.moments) {
    const PlainVertices<double> truth = true_vertices(*part.primitive, weights);
    const Weights used = changed(weights, variant);
    run_unchecked(MorphVerticesJob{&part.primitive->morphs, used, part.in(), found.out(), scratch, variant.normalise});
    error.distance_mm =
        std::max(error.distance_mm, 1e3 * largest_distance<glm::vec3, Vec3<double>>(found.positions, truth.positions));
    if (!truth.normals.empty())
      error.normal_deg = std::max(error.normal_deg,
                                  chord_deg(largest_distance<glm::vec3, Vec3<double>>(found.normals, truth.normals)));
  }
  return error;
}

void add_variant(Study& study, const MorphedPart& part, const MorphVariant& variant, bool by_normals) {
  struct Morphed {
    MorphedPart part;
    std::vector<Weights> moments;
    DeformedVertices out;
    std::vector<glm::vec3> scratch;
  };
  const std::size_t count = part.primitive->vertex_count();
  const MorphError error = error_of(part, variant);
  Point point;
  point.name = variant.name;
  point.note = variant.note;
  point.error = by_normals ? error.normal_deg : error.distance_mm;
  point.values = {{"vertices off by", error.distance_mm, "mm"}};
  const auto morphed =
      std::make_shared<Morphed>(Morphed{part, {}, DeformedVertices(count), std::vector<glm::vec3>(count)});
  for (const Weights& weights : part.moments) morphed->moments.push_back(changed(weights, variant));
  study.add(std::move(point),
            {count * part.moments.size(), [morphed, normalise = variant.normalise] {
               for (const Weights& weights : morphed->moments)
                 run_unchecked(MorphVerticesJob{&morphed->part.primitive->morphs, weights, morphed->part.in(),
                                                morphed->out.out(), morphed->scratch, normalise});
             }});
}

std::vector<std::string> findings_of_morphs(const Group& group) {
  const Point& active = default_of(group);
  std::vector<std::string> out{
      fmt::format("Adding only the targets whose weight is not zero takes {} and is within {} of the truth.",
                  time_of(group, active), cost::error_of(group, active))};
  for (const Point& point : group.points) {
    if (&point == &active) continue;
    const std::string normals =
        group.error_unit == "mm" ? "" : fmt::format(", normals up to {}", cost::error_of(group, point));
    out.push_back(sentence(fmt::format("{}: vertices are up to {} off{}; {}.", point.name,
                                       length(point.values[0].value), normals, time_beside(group, point, active))));
  }
  const Point& all = group.points.front();
  out.push_back(
      fmt::format("Leaving out targets of weight 0 loses nothing and {}; thresholds above 0 are for those who accept "
                  "the errors above.",
                  time_beside(group, active, all)));
  return out;
}

}  // namespace

Study study_morphing(const Subject& subject) {
  Study study;
  Group& group = study.group;
  group.name = "morphing";
  group.title = "Morph targets";
  group.question = "Which morph targets are worth adding, and may their normals be left as they come?";
  group.item = "vertex";
  const MorphedPart part = morphed_part(subject);
  const bool by_normals = part.primitive != nullptr &&
                          std::any_of(part.primitive->morphs.targets.begin(), part.primitive->morphs.targets.end(),
                                      [](const MorphTarget& t) { return !t.normals.empty(); });
  group.error_name = by_normals ? "largest difference of a normal" : "largest distance from the truth";
  group.error_unit = by_normals ? "degrees" : "mm";
  if (part.primitive == nullptr) return left_out(std::move(study), "the file has no morph targets");
  std::size_t active = 0;
  for (const Weights& weights : part.moments)
    active += static_cast<std::size_t>(std::count_if(weights.begin(), weights.end(), is_active_weight));
  group.about = fmt::format(
      "{} vertices with {} targets, {} of them active on average, {}. Truth is the sum of all targets in double "
      "precision.",
      part.primitive->vertex_count(), part.primitive->morphs.targets.size(),
      number(static_cast<double>(active) / static_cast<double>(part.moments.size())),
      part.animated ? fmt::format("at {} moments of {}", part.moments.size(), subject.clip_name())
                    : std::string("one in four at weight 0.5, for want of a clip that moves them"));
  for (const MorphVariant& variant : morph_variants()) add_variant(study, part, variant, by_normals);
  group.points[1].is_default = true;
  study.findings = findings_of_morphs;
  return study;
}

}  // namespace sinew::cost
