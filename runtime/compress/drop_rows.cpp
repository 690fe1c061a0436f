// SPDX-License-Identifier: MIT
#include "runtime/compress/drop_rows.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <utility>

#include "runtime/compress/clip_error.h"

namespace sinew {
namespace {

/// Parts of the budget that the rounds use.
constexpr double kRounds[] = {0.5, 0.75, 1.0};
/// Most joints that are evaluated, plus keys that are copied. It bounds the time for large animations to seconds.
constexpr std::uint64_t kMostWork = 10'000'000;

/// Tracks that keep the same keys of the same list.
struct RowList {
  const std::vector<float>* times_s = nullptr;  ///< all key times of the list
  std::vector<KeptKeys*> members;

  double time_of(std::uint32_t key) const { return static_cast<double>((*times_s)[key]); }
  bool is_at_jump(std::uint32_t key) const {
    return time_of(key - 1) == time_of(key) || time_of(key) == time_of(key + 1);
  }
};

std::vector<RowList> row_lists(const Animation& animation, std::vector<KeptKeys>& tracks) {
  std::map<std::pair<std::vector<float>, std::vector<std::uint32_t>>, std::size_t> known;
  std::vector<RowList> lists;
  for (KeptKeys& track : tracks) {
    if (track.rests) continue;
    const std::vector<float>& times_s = times_of(animation, track.track);
    const auto [at, is_new] = known.try_emplace({times_s, track.keys}, lists.size());
    if (is_new) lists.push_back({&times_s, {}});
    lists[at->second].members.push_back(&track);
  }
  return lists;
}

class RowDrop {
 public:
  RowDrop(const Animation& stored, const TruthSamples& samples, std::vector<KeptKeys>& tracks)
      : stored_(stored), meter_(samples), current_(stored) {
    for (const KeptKeys& track : tracks) set_keys(stored_, track, current_);
  }

  /// Leaves out each row of a list that the limit does not need.
  void run(const RowList& list, double limit_m) {
    const std::vector<std::uint32_t>& keys = list.members.front()->keys;
    for (std::size_t row = 1; row + 1 < keys.size() && work_ < kMostWork;)
      if (list.is_at_jump(keys[row]) || !try_without(list, row, limit_m)) ++row;
  }

 private:
  bool try_without(const RowList& list, std::size_t row, double limit_m) {
    const std::vector<std::uint32_t> before = list.members.front()->keys;
    std::vector<std::uint32_t> after = before;
    after.erase(after.begin() + static_cast<std::ptrdiff_t>(row));
    set(list, after);
    if (meter_.is_within(current_, list.time_of(before[row - 1]), list.time_of(before[row + 1]), limit_m, work_))
      return true;
    set(list, before);
    return false;
  }

  void set(const RowList& list, const std::vector<std::uint32_t>& keys) {
    for (KeptKeys* track : list.members) {
      track->keys = keys;
      set_keys(stored_, *track, current_);
      work_ += keys.size();
    }
  }

  const Animation& stored_;
  PartMeter meter_;
  Animation current_;
  std::uint64_t work_ = 0;
};

}  // namespace

void drop_rows(const Animation& stored, const TruthSamples& samples, double budget_m, std::vector<KeptKeys>& tracks) {
  const std::vector<RowList> lists = row_lists(stored, tracks);
  RowDrop drop(stored, samples, tracks);
  for (const double part : kRounds)
    for (const RowList& list : lists) drop.run(list, part * budget_m);
}

}  // namespace sinew
