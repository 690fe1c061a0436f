// SPDX-License-Identifier: MIT
#include "runtime/retarget/detail_map.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "runtime/animation/truth_pose.h"
#include "runtime/math/decompose.h"
#include "runtime/math/interpolate.h"
#include "runtime/math/inverse.h"
#include "runtime/math/rotation_between.h"

namespace sinew {
namespace {

bool has_finite_numbers(const Affined& m) noexcept {
  double sum = 0.0;
  for (const auto& row : m.row) sum += 0.0 * (row.x + row.y + row.z + row.w);
  return sum == 0.0;  // 0 * infinity and 0 * NaN are NaN
}

std::vector<Affined> neutral_model(const Skeleton& skeleton, std::span<const Affined> given) {
  if (!given.empty()) return {given.begin(), given.end()};
  std::vector<Transformd> local;
  for (const Transform& t : skeleton.rest) local.push_back(in_double(t));
  std::vector<Affined> model(local.size());
  model_from_local(skeleton, local, model);
  return model;
}

std::vector<std::array<std::uint32_t, 2>> pairs_by_name(const Skeleton& coarse, const Skeleton& fine) {
  std::vector<std::array<std::uint32_t, 2>> pairs;
  for (std::uint32_t c = 0; c < coarse.joint_count(); ++c) {
    if (coarse.names[c].empty() || coarse.find(coarse.names[c]) != c) continue;
    if (const auto f = fine.find(coarse.names[c])) pairs.push_back({c, *f});
  }
  return pairs;
}

/// Chains above the mapped joints, in rising order of these. Joints that lie above several belong to the first one.
void add_chains(const Skeleton& fine, DetailMap& map) {
  map.chain_of_fine.assign(fine.joint_count(), kNone);
  for (const DetailMap::Pair& pair : map.pairs) {
    DetailMap::Chain chain{.start = kNone, .end = pair.fine, .joints = {}};
    std::uint32_t above = fine.parents[pair.fine];
    while (above != kNone && map.pair_of_fine[above] == kNone && map.chain_of_fine[above] == kNone) {
      chain.joints.push_back(above);
      above = fine.parents[above];
    }
    if (above == kNone || chain.joints.empty()) continue;  // nothing is placed above: the joints keep their pose
    chain.start = above;
    std::reverse(chain.joints.begin(), chain.joints.end());
    for (const std::uint32_t joint : chain.joints)
      map.chain_of_fine[joint] = static_cast<std::uint32_t>(map.chains.size());
    map.chains.push_back(std::move(chain));
  }
}

Quat<double> rotation_of(const Affined& m) noexcept { return decompose_trs(m).transform.rotation; }

/// The pose of the fine skeleton while it is moved. `before` has the model matrices of the animated pose, and `now`
/// those of the joints that are placed.
struct MovedPose {
  const DetailMap& map;
  const Skeleton& fine;
  std::span<const Affine> bodies;
  const PoseSpan& local;
  std::span<Affined> before, now;

  Affined parent(std::uint32_t joint) const noexcept {
    const std::uint32_t above = fine.parents[joint];
    return above == kNone ? Affined{} : now[above];
  }
  Affined own(std::uint32_t joint) const noexcept {
    const std::uint32_t matrix = fine.fixed_matrix_of[joint];
    return matrix == kNone ? affine_from_transform(in_double(local.get(joint)))
                           : affine_cast<double>(fine.fixed_matrices[matrix]);
  }
  Affined target(std::uint32_t joint) const noexcept {
    const DetailMap::Pair& pair = map.pairs[map.pair_of_fine[joint]];
    return affine_cast<double>(bodies[pair.coarse]) * pair.fine_in_coarse;
  }

  void place_mapped(std::uint32_t joint, BodyPlaces places) const noexcept {
    const auto back = inverse_of(parent(joint));
    if (!back) return;  // a parent that is scaled to nothing: no place below it can be reached
    const Transformd to = decompose_trs(*back * target(joint)).transform;
    Transform t = local.get(joint);
    t.rotation = quat_cast<float>(to.rotation);
    if (places == BodyPlaces::exact || !has_mapped_above(joint)) t.translation = glm::vec3(to.translation);
    local.set(joint, t);
  }
  bool has_mapped_above(std::uint32_t joint) const noexcept {
    for (std::uint32_t above = fine.parents[joint]; above != kNone; above = fine.parents[above])
      if (map.pair_of_fine[above] != kNone) return true;
    return false;
  }

  void place_chain(const DetailMap::Chain& chain) const noexcept {
    const auto back = inverse_of(before[chain.start]);
    if (!back) return;
    const Affined carry = now[chain.start] * *back;
    const Affined goal = target(chain.end);
    const Quat<double> lacking = rotation_of(goal) * quat_conjugate(rotation_of(carry * before[chain.end]));
    const auto count = static_cast<double>(chain.joints.size() + 1);
    // Model rotations with their shares, and the place to which they bring the end, seen from the first joint.
    Vec3<double> reach(0.0);
    for (std::size_t i = 0; i < chain.joints.size(); ++i) {
      const Quat<double> turn = share_of(lacking, static_cast<double>(i + 1) / count);
      const std::uint32_t next = i + 1 < chain.joints.size() ? chain.joints[i + 1] : chain.end;
      const Affined here = carry * before[chain.joints[i]], below = carry * before[next];
      reach += turn * (translation_of(below) - translation_of(here));
    }
    const Vec3<double> first = translation_of(carry * before[chain.joints.front()]);
    const Quat<double> swing = rotation_between(reach, translation_of(goal) - first);
    for (std::size_t i = 0; i < chain.joints.size(); ++i) {
      const std::uint32_t joint = chain.joints[i];
      const Quat<double> turn = share_of(lacking, static_cast<double>(i + 1) / count);
      const Quat<double> model = swing * turn * rotation_of(carry * before[joint]);
      const Quat<double> of_parent = rotation_of(parent(joint));
      local.set_rotation(joint, quat_cast<float>(normalised(quat_conjugate(of_parent) * model)));
      now[joint] = parent(joint) * own(joint);
    }
  }
  static Quat<double> share_of(const Quat<double>& turn, double share) noexcept {
    return slerp_short_arc(quat_identity<double>(), turn, share);
  }
};

}  // namespace

Result<DetailMap> make_detail_map(const Skeleton& coarse, const Skeleton& fine, const DetailMapOptions& options) {
  const auto fits = [](std::span<const Affined> given, const Skeleton& skeleton) {
    return given.empty() || given.size() == skeleton.joint_count();
  };
  if (!fits(options.coarse_neutral, coarse) || !fits(options.fine_neutral, fine))
    return tl::unexpected(ErrorCode::size_mismatch);
  const std::vector<Affined> of_coarse = neutral_model(coarse, options.coarse_neutral);
  const std::vector<Affined> of_fine = neutral_model(fine, options.fine_neutral);
  if (!std::all_of(of_coarse.begin(), of_coarse.end(), has_finite_numbers) ||
      !std::all_of(of_fine.begin(), of_fine.end(), has_finite_numbers))
    return tl::unexpected(ErrorCode::not_finite);
  DetailMap map;
  map.pair_of_fine.assign(fine.joint_count(), kNone);
  map.pair_of_coarse.assign(coarse.joint_count(), kNone);
  for (const auto& [c, f] : options.pairs.empty() ? pairs_by_name(coarse, fine) : options.pairs) {
    if (c >= coarse.joint_count() || f >= fine.joint_count()) return tl::unexpected(ErrorCode::index_out_of_range);
    const auto from_coarse = inverse_of(of_coarse[c]), from_fine = inverse_of(of_fine[f]);
    if (!from_coarse || !from_fine || fine.fixed_matrix_of[f] != kNone || map.pair_of_fine[f] != kNone ||
        map.pair_of_coarse[c] != kNone)
      return tl::unexpected(ErrorCode::unsupported);
    map.pair_of_fine[f] = map.pair_of_coarse[c] = 0;  // numbered below
    map.pairs.push_back({c, f, *from_coarse * of_fine[f], *from_fine * of_coarse[c]});
  }
  std::sort(map.pairs.begin(), map.pairs.end(), [](const auto& a, const auto& b) { return a.fine < b.fine; });
  for (std::uint32_t p = 0; p < map.pairs.size(); ++p)
    map.pair_of_fine[map.pairs[p].fine] = map.pair_of_coarse[map.pairs[p].coarse] = p;
  for (std::uint32_t c = 0; c < coarse.joint_count(); ++c) {
    const std::uint32_t above = coarse.parents[c];
    const auto back = above == kNone ? std::optional(Affined{}) : inverse_of(of_coarse[above]);
    map.coarse_rest.push_back(back.value_or(Affined{}) * of_coarse[c]);
  }
  add_chains(fine, map);
  return map;
}

ErrorCode coarse_from_fine(const DetailMap& map, const Skeleton& coarse, std::span<const Affine> fine_model,
                           std::span<Affine> coarse_model) noexcept {
  if (fine_model.size() != map.pair_of_fine.size() || coarse_model.size() != map.pair_of_coarse.size() ||
      coarse.joint_count() != coarse_model.size())
    return ErrorCode::size_mismatch;
  for (std::size_t c = 0; c < coarse_model.size(); ++c) {
    if (const std::uint32_t p = map.pair_of_coarse[c]; p != kNone) {
      const DetailMap::Pair& pair = map.pairs[p];
      coarse_model[c] = affine_cast<float>(affine_cast<double>(fine_model[pair.fine]) * pair.coarse_in_fine);
      continue;
    }
    const std::uint32_t above = coarse.parents[c];
    const Affined parent = above == kNone ? Affined{} : affine_cast<double>(coarse_model[above]);
    coarse_model[c] = affine_cast<float>(parent * map.coarse_rest[c]);
  }
  return ErrorCode::ok;
}

ErrorCode fine_from_coarse(const DetailMap& map, const Skeleton& fine, std::span<const Affine> coarse_model,
                           const PoseSpan& local, std::span<Affined> scratch, BodyPlaces places) noexcept {
  const std::size_t joints = map.pair_of_fine.size();
  if (coarse_model.size() != map.pair_of_coarse.size() || fine.joint_count() != joints || !is_pose_of(local, joints) ||
      scratch.size() < 2 * joints)
    return ErrorCode::size_mismatch;
  for (const DetailMap::Pair& pair : map.pairs)
    if (!has_finite_numbers(affine_cast<double>(coarse_model[pair.coarse]))) return ErrorCode::not_finite;
  const MovedPose pose{map, fine, coarse_model, local, scratch.first(joints), scratch.subspan(joints, joints)};
  for (std::uint32_t j = 0; j < joints; ++j) {
    const std::uint32_t above = fine.parents[j];
    pose.before[j] = (above == kNone ? Affined{} : pose.before[above]) * pose.own(j);
  }
  for (std::uint32_t j = 0; j < joints; ++j) {
    const std::uint32_t chain = map.chain_of_fine[j];
    if (map.pair_of_fine[j] != kNone)
      pose.place_mapped(j, places);
    else if (chain != kNone && map.chains[chain].joints.front() == j)
      pose.place_chain(map.chains[chain]);
    pose.now[j] = pose.parent(j) * pose.own(j);
  }
  return ErrorCode::ok;
}

}  // namespace sinew
