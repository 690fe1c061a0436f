// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "runtime/threads/follow_place.h"

namespace sinew {

/// A place in the input of `follower` that follows a joint of `leader`. Both are indices of characters.
struct FollowLink {
  std::uint32_t follower = 0, leader = 0;
  std::uint32_t joint = 0;
  FollowPlace place;
};

/// Finds an order of characters in which leaders come before their followers. Characters that are linked by any number
/// of steps form a group and are consecutive.
class FollowOrder {
 public:
  struct Position {
    std::uint32_t index = 0;
    bool begins_group = false;
  };

  /// Afterwards sort() allocates nothing for indices below `count`.
  void reserve(std::size_t count);
  /// Groups come in the order of their first member in `indices`.
  /// in   indices  different, below the reserved count;   links  sorted by follower, without cycles
  /// out  valid until the next call
  /// cost O((indices + links) log indices), O(indices) without links
  std::span<const Position> sort(std::span<const std::uint32_t> indices, std::span<const FollowLink> links) noexcept;

 private:
  static constexpr std::uint32_t kEnd = ~std::uint32_t{0};
  struct Node {
    std::uint32_t parent = 0;                               // towards the representative of the group
    std::uint32_t first_member = kEnd, next_member = kEnd;  // list of the group, at its representative
    std::uint32_t next_link = 0, end_link = 0;              // leaders that were not visited yet
    bool is_visited = false;
  };

  std::uint32_t group_of(std::uint32_t index) noexcept;
  void append_behind_leaders(std::uint32_t index, std::span<const FollowLink> links) noexcept;

  std::vector<Node> nodes_;
  std::vector<std::uint32_t> path_;  // characters whose leaders are being visited
  std::vector<Position> order_;
};

/// True if `from` follows `to`, by any number of steps. Every character follows itself.
/// in   links  sorted by follower;   count  above all indices.     cost O(count + links log links), allocates
bool follows(std::span<const FollowLink> links, std::size_t count, std::uint32_t from, std::uint32_t to);

/// The links of one follower.
std::span<const FollowLink> links_of(std::span<const FollowLink> links, std::uint32_t follower) noexcept;

}  // namespace sinew
