// SPDX-License-Identifier: MIT
#include "runtime/paging/paged_clip.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "runtime/base/contract.h"
#include "runtime/clip/clip_layout.h"
#include "runtime/clip/keep_joints.h"
#include "runtime/paging/join_clips.h"

namespace sinew {
namespace {

tl::unexpected<ClipFileError> refuse(std::string detail) {
  return tl::unexpected(ClipFileError{"clip-page", kClipFileHead, std::move(detail)});
}

/// The page with the base values of the head, so that both share them in memory.
Clip sharing_rest(const Clip& page, const Clip& head) {
  ClipLayout layout = page.layout();
  layout.base_pose = head.layout().base_pose;
  layout.base_weights = head.layout().base_weights;
  layout.base_properties = head.layout().base_properties;
  return clip_of(std::move(layout));
}

Clip of_joints(const Clip& clip, std::span<const std::uint32_t> kept) {
  return kept.empty() || kept.size() == clip.joint_count() ? clip : keep_joints(clip, kept);
}

}  // namespace

ErrorCode PagedClip::check(double page_s, std::size_t page_count, const Options& options) noexcept {
  const bool is_usable = std::isfinite(page_s) && page_s > 0.0 && page_count > 0 && options.window >= 2;
  return is_usable ? ErrorCode::ok : ErrorCode::unsupported;
}

PagedClip::PagedClip(Clip head, double page_s, std::size_t page_count, const Options& options)
    : head_(std::move(head)),
      shown_head_(of_joints(head_, options.kept_joints)),
      page_s_(page_s),
      page_count_(page_count),
      options_(options) {
  CONTRACT(check(page_s, page_count, options) == ErrorCode::ok && "pages of a length and a window of at least 2");
  slots_.reserve(options_.window);
}

/// The page at a place of the window, in order of urgency: the playing page, those after it, last the one before it.
std::optional<std::size_t> PagedClip::page_of_window(std::size_t place) const noexcept {
  const auto count = static_cast<std::ptrdiff_t>(page_count_);
  const bool is_before = place > 1 && place + 1 == options_.window;
  const std::ptrdiff_t steps = is_before ? -1 : static_cast<std::ptrdiff_t>(place);
  const std::ptrdiff_t page = static_cast<std::ptrdiff_t>(playing_) + (backwards_ ? -steps : steps);
  if (page >= 0 && page < count) return static_cast<std::size_t>(page);
  if (!options_.loops) return std::nullopt;
  return static_cast<std::size_t>((page % count + count) % count);
}

bool PagedClip::is_in_window(std::size_t page) const noexcept {
  for (std::size_t place = 0; place < options_.window; ++place)
    if (page_of_window(place) == page) return true;
  return false;
}

const PagedClip::Slot* PagedClip::find(std::size_t page) const noexcept {
  const auto found = std::find_if(slots_.begin(), slots_.end(), [&](const Slot& s) { return s.page == page; });
  return found == slots_.end() ? nullptr : &*found;
}

/// The loaded page nearest to a time, or null.
const PagedClip::Slot* PagedClip::nearest(double time_s) const noexcept {
  const auto distance = [&](const Slot& slot) {
    return std::abs(times_of_page(slot.page, page_s_, page_count_).nearest(time_s) - time_s);
  };
  const auto found = std::min_element(slots_.begin(), slots_.end(),
                                      [&](const Slot& a, const Slot& b) { return distance(a) < distance(b); });
  return found == slots_.end() ? nullptr : &*found;
}

PageSample PagedClip::at(double time_s, bool backwards) noexcept {
  const std::scoped_lock held(lock_);
  playing_ = page_at(time_s, page_s_, page_count_);
  backwards_ = backwards;
  if (const Slot* slot = find(playing_)) return {slot->clip, time_s, false};
  const Slot* slot = nearest(time_s);
  if (slot == nullptr) return {shown_head_, 0.0, true};
  return {slot->clip, times_of_page(slot->page, page_s_, page_count_).nearest(time_s), true};
}

std::optional<std::size_t> PagedClip::next_page() const noexcept {
  const std::scoped_lock held(lock_);
  for (std::size_t place = 0; place < options_.window; ++place)
    if (const auto page = page_of_window(place); page && find(*page) == nullptr) return page;
  return std::nullopt;
}

/// If a page of the window is not loaded, there is a free slot or a slot with a page outside of the window.
tl::expected<bool, ClipFileError> PagedClip::load_page(std::size_t page, std::span<const std::byte> bytes) {
  CONTRACT(page < page_count_);
  auto clips = load_clips(bytes);
  if (!clips) return tl::unexpected(clips.error());
  const std::string name = name_of_page(head_.name(), page);
  if (clips->size() != 1 || clips->front().name() != name)
    return refuse("the block is not page \"" + name + "\"" +
                  (clips->empty() ? std::string() : ", but \"" + clips->front().name() + "\""));
  if (!moves_alike(head_, clips->front())) return refuse("page \"" + name + "\" does not move what its clip moves");
  Slot loaded{page, sharing_rest(of_joints(clips->front(), options_.kept_joints), shown_head_)};
  const std::scoped_lock held(lock_);
  if (!is_in_window(page)) return false;
  if (find(page) != nullptr) return true;
  if (slots_.size() < options_.window) {
    slots_.push_back(std::move(loaded));
    return true;
  }
  const auto left =
      std::find_if(slots_.begin(), slots_.end(), [&](const Slot& slot) { return !is_in_window(slot.page); });
  std::swap(*left, loaded);  // the old page is freed after the lock is released
  return true;
}

std::size_t PagedClip::loaded_pages() const noexcept {
  const std::scoped_lock held(lock_);
  return slots_.size();
}

std::size_t PagedClip::loaded_bytes() const noexcept {
  const std::scoped_lock held(lock_);
  std::size_t bytes = 0;
  for (const Slot& slot : slots_) bytes += slot.clip.byte_size();
  return bytes;
}

}  // namespace sinew
