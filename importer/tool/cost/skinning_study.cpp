// SPDX-License-Identifier: MIT
#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>

#include <fmt/format.h>

#include "importer/tool/cost/limb.h"
#include "importer/tool/cost/studies.h"
#include "importer/tool/cost/words.h"
#include "importer/topology/centers_of_rotation.h"
#include "runtime/deform/skin_center_of_rotation.h"
#include "runtime/deform/skin_dual_quaternion.h"
#include "runtime/plan/needs.h"
#include "runtime/pose/hemisphere_pairs.h"

namespace sinew::cost {
namespace {

/// Skins one primitive with any of the three methods, and keeps the data that each method needs.
class Skinner {
 public:
  Skinner(const SkinnedPart& part, std::span<const glm::vec3> centers)
      : part_(part),
        centers_(centers.begin(), centers.end()),
        split_(part.skin->joints.size()),
        edges_(hemisphere_edges(*part.skeleton, *part.skin)),
        pairs_(joint_pairs_of_vertices(part.primitive->influences, split_.size())),
        out_(part.vertex_count()) {}

  /// Skins one pose. Splitting joint matrices is part of the rigid methods, and is done once per frame.
  void run(Skinning kind, const PosedSkin& pose) {
    const VertexInfluences* influences = &part_.primitive->influences;
    if (kind != Skinning::linear) sinew::run_unchecked(SplitPaletteJob{pose.palette, split_, &any_stretch_, edges_});
    switch (kind) {
      case Skinning::linear:
        sinew::run_unchecked(SkinLinearJob{influences, pose.palette, part_.in(), out_.out(), NormalRule::linear});
        break;
      case Skinning::dual_quaternion:
        sinew::run_unchecked(
            SkinDualQuaternionJob{influences, split_, any_stretch_, part_.in(), out_.out(), pairs_, pose.palette});
        break;
      case Skinning::center_of_rotation:
        sinew::run_unchecked(SkinCenterOfRotationJob{influences, pose.palette, split_, any_stretch_, centers_,
                                                     part_.in(), out_.out(), pairs_});
        break;
    }
  }

  std::span<const glm::vec3> positions() const { return out_.positions; }
  const SkinnedPart& part() const { return part_; }
  /// True if the pose that a rigid method ran last needed the stretch phase, which takes time.
  bool any_stretch() const { return any_stretch_; }

 private:
  SkinnedPart part_;
  std::vector<glm::vec3> centers_;
  std::vector<RigidStretch> split_;
  std::vector<JointPair> edges_, pairs_;
  bool any_stretch_ = false;
  DeformedVertices out_;
};

/// Percentage of its volume that the limb keeps in one pose.
double volume_kept(Skinner& limb, Skinning kind, const PosedSkin& pose) {
  const Primitive& primitive = *limb.part().primitive;
  limb.run(kind, pose);
  return 100.0 * volume_of(limb.positions(), primitive.indices) / volume_of(primitive.positions, primitive.indices);
}

/// Largest distance of a vertex from its linearly blended position, in mm.
double apart_from_linear_mm(Skinner& skinner, Skinning kind) {
  double largest_m = 0.0;
  for (const PosedSkin& pose : skinner.part().poses) {
    skinner.run(Skinning::linear, pose);
    const std::vector<glm::vec3> linear(skinner.positions().begin(), skinner.positions().end());
    skinner.run(kind, pose);
    largest_m = std::max(largest_m, largest_distance<glm::vec3, glm::vec3>(skinner.positions(), linear));
  }
  return 1e3 * largest_m;
}

struct Kind {
  const char* name;
  Skinning skinning;
  const char* note;
};

constexpr Kind kKinds[] = {
    {"linear", Skinning::linear, "blends matrices"},
    {"dual quaternion", Skinning::dual_quaternion, "blends rigid motions, stretch before them"},
    {"center of rotation", Skinning::center_of_rotation, "blends rotations about centers that are made once"},
};

std::vector<std::string> findings_of_skinning(const Group& group) {
  const Point& linear = default_of(group);
  std::vector<std::string> out{
      fmt::format("Linear blending takes {} and keeps {} % of the limb bent by 90 degrees, {} % of it twisted by 150.",
                  time_of(group, linear), number(linear.values[0].value), number(linear.values[1].value))};
  for (const Point& point : group.points)
    if (&point != &linear)
      out.push_back(sentence(
          fmt::format("{} skinning {} here, {} times as much; it keeps {} % bent and {} % twisted, and puts vertices "
                      "of this file up to {} elsewhere.",
                      point.name, time_beside(group, point, linear), number(point.time_ns / linear.time_ns),
                      number(point.values[0].value), number(point.values[1].value), length(point.values[2].value))));
  constexpr double kNoticeable = 2.0;  // percent of the volume
  if (const Point* best = cheapest_within(group, kNoticeable))
    out.push_back(
        fmt::format("Where limbs bend or twist far, use {}: the cheapest that changes a limb's volume by less than {} "
                    "%. Elsewhere linear blending will do.",
                    best->name, kNoticeable));
  return out;
}

}  // namespace

Study study_skinning(const Subject& subject) {
  Study study;
  Group& group = study.group;
  group.name = "skinning";
  group.title = "Skinning: kinds";
  group.question = "What do dual quaternions or centers of rotation cost me here, and what do I get?";
  group.error_name = "largest change of volume, bent or twisted";
  group.error_unit = "%";
  group.item = "vertex";
  const auto part = skinned_part(subject);
  if (!part) return left_out(std::move(study), "the file has no skinned vertices");
  const Limb limb;
  const auto begin = std::chrono::steady_clock::now();
  const std::vector<glm::vec3> centers = part->primitive->centers_of_rotation.empty()
                                             ? centers_of_rotation(*part->primitive)
                                             : part->primitive->centers_of_rotation;
  const std::chrono::duration<double> made_in = std::chrono::steady_clock::now() - begin;
  group.about = fmt::format(
      "Positions and normals of the largest primitive: {}. Times include the split of the joints' matrices where a "
      "kind needs it; centers of "
      "rotation were made beforehand, in {} s. Volume is that of a built-in round limb, its second joint bent by 90 "
      "and twisted by 150 degrees.",
      part->description, number(made_in.count()));
  Skinner limb_skinner(part_of(limb), limb.primitive.centers_of_rotation);
  const auto skinner = std::make_shared<Skinner>(*part, centers);
  for (const Kind& kind : kKinds) {
    const double bent = volume_kept(limb_skinner, kind.skinning, limb.bent),
                 twisted = volume_kept(limb_skinner, kind.skinning, limb.twisted);
    Point point;
    point.name = kind.name;
    point.note = kind.note;
    point.error = std::max(std::abs(bent - 100.0), std::abs(twisted - 100.0));
    point.is_default = kind.skinning == Skinning::linear;
    point.values = {{"volume kept, bent", bent, "%"},
                    {"volume kept, twisted", twisted, "%"},
                    {"apart from linear here", apart_from_linear_mm(*skinner, kind.skinning), "mm"}};
    study.add(std::move(point),
              {part->vertex_count(), [skinner, kind] { skinner->run(kind.skinning, skinner->part().poses.front()); }});
  }
  skinner->run(Skinning::dual_quaternion, part->poses.front());
  if (skinner->any_stretch())
    group.about +=
        " Joints of this file stretch: the rigid kinds run their first phase, which rigid joints spare them.";
  study.findings = findings_of_skinning;
  return study;
}

}  // namespace sinew::cost
