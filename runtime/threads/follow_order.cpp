// SPDX-License-Identifier: MIT
#include "runtime/threads/follow_order.h"

#include <algorithm>

#include "runtime/threads/make_room.h"

namespace sinew {

void FollowOrder::reserve(std::size_t count) {
  if (count > nodes_.size()) {
    make_room(nodes_, count);
    nodes_.resize(count);
  }
  make_room(path_, count);
  make_room(order_, count);
}

/// The representative of a character's group. Halves the path to it (Tarjan and van Leeuwen 1984).
std::uint32_t FollowOrder::group_of(std::uint32_t index) noexcept {
  while (nodes_[index].parent != index) {
    nodes_[index].parent = nodes_[nodes_[index].parent].parent;
    index = nodes_[index].parent;
  }
  return index;
}

void FollowOrder::append_behind_leaders(std::uint32_t index, std::span<const FollowLink> links) noexcept {
  const auto visit = [&](std::uint32_t next) {
    if (nodes_[next].is_visited) return;
    nodes_[next].is_visited = true;
    path_.push_back(next);
  };
  for (visit(index); !path_.empty();) {
    Node& last = nodes_[path_.back()];
    if (last.next_link < last.end_link) {
      visit(links[last.next_link++].leader);
    } else {
      order_.push_back({path_.back(), false});
      path_.pop_back();
    }
  }
}

std::span<const FollowOrder::Position> FollowOrder::sort(std::span<const std::uint32_t> indices,
                                                         std::span<const FollowLink> links) noexcept {
  order_.clear();
  for (const std::uint32_t index : indices) nodes_[index] = {.parent = index};
  for (std::uint32_t l = 0; l < links.size(); ++l) {
    Node& follower = nodes_[links[l].follower];
    if (follower.end_link == 0) follower.next_link = l;
    follower.end_link = l + 1;
    nodes_[group_of(links[l].follower)].parent = group_of(links[l].leader);
  }
  for (std::size_t i = indices.size(); i-- > 0;) {
    Node& group = nodes_[group_of(indices[i])];
    nodes_[indices[i]].next_member = group.first_member;
    group.first_member = indices[i];
  }
  for (const std::uint32_t index : indices) {
    if (nodes_[index].is_visited) continue;
    const std::size_t first = order_.size();
    for (std::uint32_t m = nodes_[group_of(index)].first_member; m != kEnd; m = nodes_[m].next_member)
      append_behind_leaders(m, links);
    order_[first].begins_group = true;
  }
  return order_;
}

std::span<const FollowLink> links_of(std::span<const FollowLink> links, std::uint32_t follower) noexcept {
  const auto before = [](const FollowLink& link, std::uint32_t index) { return link.follower < index; };
  const auto first = std::lower_bound(links.begin(), links.end(), follower, before);
  const auto end = std::lower_bound(first, links.end(), follower + 1, before);
  return {first, end};
}

bool follows(std::span<const FollowLink> links, std::size_t count, std::uint32_t from, std::uint32_t to) {
  std::vector<bool> is_seen(count, false);
  std::vector<std::uint32_t> seen{from};
  for (std::size_t i = 0; i < seen.size(); ++i) {
    if (seen[i] == to) return true;
    for (const FollowLink& link : links_of(links, seen[i])) {
      if (is_seen[link.leader]) continue;
      is_seen[link.leader] = true;
      seen.push_back(link.leader);
    }
  }
  return false;
}

}  // namespace sinew
