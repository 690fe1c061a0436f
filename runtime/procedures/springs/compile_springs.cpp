// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "runtime/pose/pose.h"
#include "runtime/procedures/springs/spring_memory.h"
#include "runtime/procedures/springs/springs.h"

namespace sinew {
namespace {

constexpr double kLargest = 1e15;  ///< Squares and products of numbers up to this one do not overflow.

/// Returns the error of a number: not_finite, or too_large if products could overflow; else ok.
ErrorCode check_number(double value) noexcept {
  if (!std::isfinite(value)) return ErrorCode::not_finite;
  return std::abs(value) > kLargest ? ErrorCode::too_large : ErrorCode::ok;
}

ErrorCode check_vector(const Vec3<double>& v) noexcept {
  for (int i = 0; i < 3; ++i)
    if (const ErrorCode code = check_number(v[i]); code != ErrorCode::ok) return code;
  return ErrorCode::ok;
}

ErrorCode check_length(double value) noexcept {
  const ErrorCode code = check_number(value);
  return code == ErrorCode::ok && value < 0.0 ? ErrorCode::negative_weight : code;
}

struct NamedCode {
  ErrorCode code;
  const char* rule;
};

/// The first entry that is not ok; ok if there is none.
NamedCode first_of(std::initializer_list<NamedCode> codes) {
  for (const NamedCode& named : codes)
    if (named.code != ErrorCode::ok) return named;
  return {ErrorCode::ok, ""};
}

}  // namespace

class SpringsCompiler {
 public:
  SpringsCompiler(const Skeleton& skeleton, const SpringSetup& setup, const SpringSettings& settings)
      : skeleton_(skeleton), setup_(setup), out_(made_.tables_) {
    made_.settings_ = settings;
    made_.joint_count_ = setup.joints.size();
    made_.skeleton_joints_ = skeleton.joint_count();
  }

  tl::expected<Springs, SpringsFault> compile() {
    check_settings();
    check_groups();
    check_colliders();
    check_joints();
    if (fault_.code != ErrorCode::ok) return tl::unexpected(std::move(fault_));
    add_records();
    add_groups();
    add_ancestors();
    add_runs();
    springs::add_slots(skeleton_, out_);
    return std::move(made_);
  }

 private:
  void refuse(std::string place, NamedCode named) {
    if (named.code == ErrorCode::ok || fault_.code != ErrorCode::ok) return;
    fault_ = {named.code, std::move(place) + ": " + named.rule};
  }
  static std::string entry(const char* list, std::size_t index) {
    return std::string(list) + '[' + std::to_string(index) + ']';
  }
  static ErrorCode in_range(std::size_t index, std::size_t count) {
    return index < count ? ErrorCode::ok : ErrorCode::index_out_of_range;
  }

  void check_settings() {
    const SpringSettings& s = made_.settings_;
    const ErrorCode tick = check_length(s.tick_s);
    refuse(
        "settings",
        first_of({{tick == ErrorCode::ok && s.tick_s < 1e-6 ? ErrorCode::unsupported : tick,
                   "a tick takes a millionth of a second or more"},
                  {check_length(s.sleep_rad_per_s), "the speed of sleep is 0 or more"},
                  {s.max_ticks == 0 ? ErrorCode::unsupported : ErrorCode::ok, "a frame may take one tick or more"}}));
  }

  void check_groups() {
    for (std::size_t g = 0; g < setup_.groups.size(); ++g) {
      const SpringGroup& group = setup_.groups[g];
      if (group.center != kNone)
        refuse(entry("groups", g),
               {in_range(group.center, skeleton_.joint_count()), "the skeleton has no such centre"});
      for (const std::uint32_t c : group.colliders)
        refuse(entry("groups", g), {in_range(c, setup_.colliders.size()), "there is no such collider"});
    }
  }

  void check_colliders() {
    for (std::size_t c = 0; c < setup_.colliders.size(); ++c) {
      const SpringCollider& shape = setup_.colliders[c];
      refuse(entry("colliders", c),
             first_of({{in_range(shape.joint, skeleton_.joint_count()), "the skeleton has no such joint"},
                       {check_vector(shape.offset), "its offset is no usable position"},
                       {check_vector(shape.tail), "its tail is no usable position"},
                       {check_vector(shape.normal), "its normal is no usable direction"},
                       {check_length(shape.radius_m), "its radius is no length"}}));
    }
  }

  void check_joints() {
    std::vector<bool> taken(skeleton_.joint_count(), false);
    for (std::size_t j = 0; j < setup_.joints.size() && fault_.code == ErrorCode::ok; ++j) {
      const SpringJoint& joint = setup_.joints[j];
      const std::string place = entry("joints", j);
      refuse(place, first_of({{in_range(joint.joint, skeleton_.joint_count()), "the skeleton has no such joint"},
                              {in_range(joint.group, setup_.groups.size()), "there is no such group"},
                              {check_vector(joint.tail_m), "its tail is no usable position"},
                              {check_number(joint.stiffness), "its stiffness is no usable number"},
                              {check_vector(joint.gravity_m_s), "its gravity is no usable vector"},
                              {check_length(joint.hit_radius_m), "its hit radius is no length"},
                              {joint.drag >= 0.0 && joint.drag <= 1.0 ? ErrorCode::ok : ErrorCode::not_a_fraction,
                               "its drag is not between 0 and 1"}}));
      if (fault_.code != ErrorCode::ok) return;
      if (skeleton_.fixed_matrix_of[joint.joint] != kNone)
        refuse(place, {ErrorCode::unsupported, "it has a fixed matrix, so its rotation cannot change"});
      if (taken[joint.joint]) refuse(place, {ErrorCode::index_out_of_range, "another entry has the same joint"});
      taken[joint.joint] = true;
    }
  }

  /// Finds the joints of the setup and the joints between them, and lists them in the order of the skeleton.
  void add_records() {
    std::vector<std::uint32_t> setup_of(skeleton_.joint_count(), kNone);
    for (std::size_t j = 0; j < setup_.joints.size(); ++j)
      setup_of[setup_.joints[j].joint] = static_cast<std::uint32_t>(j);
    std::vector<bool> below(skeleton_.joint_count(), false), listed(skeleton_.joint_count(), false);
    for (std::size_t j = 0; j < below.size(); ++j) {
      const std::uint32_t parent = skeleton_.parents[j];
      below[j] = parent != kNone && (below[parent] || setup_of[parent] != kNone);
    }
    for (const SpringJoint& joint : setup_.joints)
      for (std::uint32_t j = joint.joint; !listed[j]; j = skeleton_.parents[j]) {
        listed[j] = true;
        if (!below[j]) break;
      }
    record_of_.assign(skeleton_.joint_count(), kNone);
    for (std::uint32_t j = 0; j < listed.size(); ++j) {
      if (!listed[j]) continue;
      record_of_[j] = static_cast<std::uint32_t>(out_.records.size());
      out_.records.push_back(record_for(j, setup_of[j]));
      out_.is_rest_uniform &= springs::scales_evenly(skeleton_.rest[j]);
    }
  }

  SpringRecord record_for(std::uint32_t joint, std::uint32_t setup) {
    SpringRecord record;
    record.joint = joint;
    const std::uint32_t parent = skeleton_.parents[joint];
    if (parent != kNone) record.parent = record_of_[parent];
    record.frame = record.parent == kNone ? frame_for(parent) : out_.records[record.parent].frame;
    record.setup = setup;
    if (setup == kNone) return record;
    const SpringJoint& given = setup_.joints[setup];
    const double tick_s = made_.settings_.tick_s, kept = 1.0 - given.drag;
    const bool is_usual = std::abs(tick_s * 60.0 - 1.0) < 1e-9;
    record.goal = setup_.groups[given.group].goal;
    record.rest = normalised(quat_cast<double>(skeleton_.rest[joint].rotation));
    record.tail = given.tail_m;
    record.length = safe_length(given.tail_m);
    record.axis = normalised_or(given.tail_m, Vec3<double>(0.0, 1.0, 0.0));
    if (record.length > 1e-9) record.group = given.group;
    // At the usual rate of 60 ticks per second the file's numbers are used unchanged. A pull adds to the velocity in
    // each tick, so at other rates it scales with the square of the tick's length.
    const double ticks = is_usual ? 1.0 : tick_s * 60.0;
    record.kept = is_usual ? kept : std::pow(kept, ticks);
    record.pull = given.stiffness * tick_s * ticks;
    record.gravity = given.gravity_m_s * tick_s * ticks;
    record.hit_radius = given.hit_radius_m;
    record.lagging = given.lagging_length;
    return record;
  }

  void add_groups() {
    std::vector<std::uint32_t> collider_of(setup_.colliders.size(), kNone);
    for (const SpringGroup& group : setup_.groups) {
      SpringGroupRecord& record = out_.groups.emplace_back();
      if (group.center != kNone) record.center = frame_for(group.center);
      record.first_collider = static_cast<std::uint32_t>(out_.collider_lists.size());
      record.collider_count = static_cast<std::uint32_t>(group.colliders.size());
      for (const std::uint32_t c : group.colliders) {
        if (collider_of[c] == kNone) {
          collider_of[c] = static_cast<std::uint32_t>(out_.colliders.size());
          out_.colliders.push_back({setup_.colliders[c], frame_for(setup_.colliders[c].joint)});
        }
        out_.collider_lists.push_back(collider_of[c]);
      }
    }
  }

  /// Index of the input frame of a joint, or of the root for kNone. Adds the frame if it is new.
  std::uint32_t frame_for(std::uint32_t joint) {
    const auto [at, is_new] = frame_of_.try_emplace(joint, static_cast<std::uint32_t>(out_.frames.size()));
    if (is_new) out_.frames.emplace_back();
    return at->second;
  }

  /// Lists all joints above frames, in the order of the skeleton.
  void add_ancestors() {
    std::vector<bool> above(skeleton_.joint_count(), false);
    for (const auto& [joint, frame] : frame_of_)
      for (std::uint32_t j = joint; j != kNone && !above[j]; j = skeleton_.parents[j]) above[j] = true;
    std::vector<std::uint32_t> ancestor_of(skeleton_.joint_count(), kNone);
    for (std::uint32_t j = 0; j < above.size(); ++j) {
      if (!above[j]) continue;
      ancestor_of[j] = static_cast<std::uint32_t>(out_.ancestors.size());
      const std::uint32_t parent = skeleton_.parents[j];
      out_.ancestors.push_back({j, parent == kNone ? kNone : ancestor_of[parent]});
    }
    for (const auto& [joint, frame] : frame_of_)
      if (joint != kNone) out_.frames[frame].ancestor = ancestor_of[joint];
  }

  /// Finds runs of joints, and their rest transforms as a pose stores them.
  void add_runs() {
    const std::size_t count = out_.records.size();
    out_.rest.resize(PoseSpan::plane_count * count);
    const PoseSpan rest{out_.rest.data(), count, count};
    for (std::size_t r = 0; r < count; ++r) {
      const SpringRecord& record = out_.records[r];
      rest.set(r, skeleton_.rest[record.joint]);
      const bool reads = record.goal == SpringGoal::pose, writes = record.setup != kNone;
      if (out_.runs.empty() || out_.runs.back().joint + out_.runs.back().count != record.joint ||
          out_.runs.back().reads_rotations != reads || out_.runs.back().writes_rotations != writes)
        out_.runs.push_back({record.joint, r, 0, reads, writes});
      ++out_.runs.back().count;
    }
  }

  const Skeleton& skeleton_;
  const SpringSetup& setup_;
  Springs made_;
  SpringTables& out_;
  SpringsFault fault_;
  std::vector<std::uint32_t> record_of_;             ///< [joints of the skeleton] kNone = not computed by springs
  std::map<std::uint32_t, std::uint32_t> frame_of_;  ///< frame of each joint, in increasing order
};

std::size_t Springs::state_bytes() const noexcept { return SpringMemory::state_bytes(tables_); }
std::size_t Springs::scratch_bytes() const noexcept { return SpringMemory::scratch_bytes(tables_); }

tl::expected<Springs, SpringsFault> compile_springs(const Skeleton& skeleton, const SpringSetup& setup,
                                                    const SpringSettings& settings) {
  return SpringsCompiler(skeleton, setup, settings).compile();
}

void add_chain_below(const Skeleton& skeleton, std::uint32_t root, const SpringJoint& like, double end_m,
                     SpringSetup& setup) {
  std::vector<std::uint32_t> first_child(skeleton.joint_count(), kNone), sibling(skeleton.joint_count(), kNone);
  for (auto j = static_cast<std::uint32_t>(skeleton.joint_count()); j-- > 0;)
    if (const std::uint32_t parent = skeleton.parents[j]; parent != kNone)
      sibling[j] = std::exchange(first_child[parent], j);
  for (std::vector<std::uint32_t> open{root}; !open.empty();) {
    const std::uint32_t j = open.back(), child = first_child[j];
    open.pop_back();
    if (j != root && sibling[j] != kNone) open.push_back(sibling[j]);
    if (skeleton.fixed_matrix_of[j] != kNone) continue;
    if (child != kNone) open.push_back(child);
    SpringJoint& joint = setup.joints.emplace_back(like);
    joint.joint = j;
    joint.lagging_length = like.lagging_length && child != kNone;
    const Vec3<double> from_parent(skeleton.rest[j].translation);
    joint.tail_m = child != kNone ? Vec3<double>(skeleton.rest[child].translation)
                                  : normalised_or(from_parent, Vec3<double>(0.0, 1.0, 0.0)) * end_m;
  }
}

}  // namespace sinew
