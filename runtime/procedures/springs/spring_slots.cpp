// SPDX-License-Identifier: MIT
#include "runtime/procedures/springs/spring_slots.h"

#include <algorithm>

#include "runtime/procedures/springs/spring_inputs.h"
#include "runtime/procedures/springs/spring_records.h"

namespace sinew::springs {
namespace {

/// Numbers joints by their depth. Of the joints of a depth those with the longest chains below come first, and children
/// follow the order of their parents. So the joints of unbranched chains keep their lane from depth to depth.
void number_joints(const std::vector<SpringRecord>& records, SpringSlots& slots) {
  std::vector<std::uint32_t> below(records.size(), 0), level;
  std::vector<std::vector<std::uint32_t>> children(records.size());
  for (auto r = static_cast<std::uint32_t>(records.size()); r-- > 0;)
    if (const std::uint32_t parent = records[r].parent; parent != kNone)
      below[parent] = std::max(below[parent], below[r] + 1);
  for (std::uint32_t r = 0; r < records.size(); ++r)
    (records[r].parent == kNone ? level : children[records[r].parent]).push_back(r);
  const auto sort = [&](std::vector<std::uint32_t>& list) {
    std::ranges::stable_sort(list, [&](std::uint32_t a, std::uint32_t b) { return below[a] > below[b]; });
  };
  slots.slot.resize(records.size());
  slots.depths = {slots.first_joint};
  for (sort(level); !level.empty();) {
    std::vector<std::uint32_t> next;
    for (const std::uint32_t r : level) {
      slots.slot[r] = static_cast<std::uint32_t>(slots.first_joint + slots.record.size());
      slots.record.push_back(r);
      sort(children[r]);
      next.insert(next.end(), children[r].begin(), children[r].end());
    }
    slots.depths.push_back(slots.first_joint + slots.record.size());
    level = std::move(next);
  }
}

}  // namespace

void add_slots(const Skeleton& skeleton, SpringTables& tables) {
  SpringSlots& slots = tables.slots;
  slots.first_joint = tables.frames.size() + 1;
  number_joints(tables.records, slots);
  slots.stride = (slots.depths.back() + 2 * kSpringLanes - 1) / kSpringLanes * kSpringLanes;
  slots.parent.assign(slots.stride, 0);
  slots.frame.assign(slots.stride, 0);
  slots.center.assign(slots.stride, 0);
  slots.constants.assign(constant::count * slots.stride, 0.0);
  slots.rest_inputs.assign(input::count * slots.stride, 0.0);
  for (std::size_t r = 0; r < tables.records.size(); ++r) {
    const SpringRecord& record = tables.records[r];
    const std::size_t s = slots.slot[r];
    slots.parent[s] = record.parent == kNone ? record.frame : slots.slot[record.parent];
    slots.frame[s] = record.frame;
    slots.center[s] = static_cast<std::int64_t>(slots.identity());
    place(joint_input(record, skeleton.rest[record.joint]), slots.rest_inputs.data(), slots.stride, s);
    if (record.group == kNone) continue;
    const SpringGroupRecord& group = tables.groups[record.group];
    if (group.center != kNone) slots.center[s] = group.center;
    slots.has_centers |= group.center != kNone;
    slots.has_colliders |= group.collider_count > 0;
    slots.has_lagging |= record.lagging;
    const double all[constant::count] = {record.kept,
                                         record.pull,
                                         record.gravity.x,
                                         record.gravity.y,
                                         record.gravity.z,
                                         record.hit_radius,
                                         static_cast<double>(record.group),
                                         1.0,
                                         record.lagging ? 1.0 : 0.0};
    for (std::size_t p = 0; p < constant::count; ++p) slots.constants[p * slots.stride + s] = all[p];
  }
}

}  // namespace sinew::springs
