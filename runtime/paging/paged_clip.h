// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <optional>
#include <span>
#include <vector>

#include <tl/expected.hpp>

#include "runtime/clip/clip_file.h"
#include "runtime/paging/page_table.h"

namespace sinew {

/// What a paged clip can show at a time.
///
///     const PageSample at = paged.at(time_s);
///     const ClipLayer layer{.clip = number, .time_s = at.time_s, .page = &at.page};
///
/// owns  the keys: they stay as long as this, whatever is loaded meanwhile. Keep it until the frame has run; where layers
///       are held over frames (lod/update_rate.h), as long as they are.
struct PageSample {
  Clip page;                ///< for ClipLayer::page or SampleClipJob::clip
  double time_s = 0.0;      ///< for ClipLayer::time_s
  bool is_missing = false;  ///< the page is not loaded: page and time_s are the nearest pose that is
};

/// A long clip of which a bounded number of pages is in memory: those around the time that plays. The engine's loader
/// asks which page is next, reads its bytes wherever they are, and hands them over:
///
///     while (const auto page = paged.next_page()) paged.load_page(*page, bytes_of(*page));    // on any thread
///
/// One thread plays; loaders may be several, and need not keep up. What `at` shows of a page that is there has the bits
/// of the whole clip.
class PagedClip {
 public:
  struct Options {
    std::size_t window = 4;  ///< most pages in memory, at least 2: the one that plays, the next ones, and behind them
                             ///< the one before, where there is room for it
    bool loops = true;       ///< the page after the last one is the first
    std::vector<std::uint32_t> kept_joints = {};  ///< kept_joints (plan/compile_plan.h) of a plan with a skeleton LOD,
                                                  ///< whose poses the pages are for; empty = all joints
  };

  /// in   head        first_keys of the clip: what is shown while no page is loaded, and what a plan is compiled with;
  ///                  of all joints, as pages are
  ///      page_s, page_count   as PageTable has them, page_count > 0
  PagedClip(Clip head, double page_s, std::size_t page_count, const Options& options);
  PagedClip(Clip head, double page_s, std::size_t page_count) : PagedClip(std::move(head), page_s, page_count, {}) {}

  /// The keys of a time, and where the window is from now on.
  /// in   time_s     seconds in the clip, as PlaybackClock::time_s
  ///      backwards  the pages before this one are needed next
  /// cost O(window), and a lock that loaders hold for as long;  allocates nothing
  PageSample at(double time_s, bool backwards = false) noexcept;

  /// The most urgent page of the window that is not loaded; nothing: all are. Two loaders that ask at once may be told
  /// the same page.      cost O(window^2)
  std::optional<std::size_t> next_page() const noexcept;

  /// Takes a page (PageTable), if the window still has it, in place of one that the window has left.
  /// out  whether it was taken
  /// err  ClipFileError: those of load_clips, and clip-page: the block is another page, or one of another clip
  /// cost O(bytes), allocates the page
  tl::expected<bool, ClipFileError> load_page(std::size_t page, std::span<const std::byte> bytes);

  std::size_t page_count() const noexcept { return page_count_; }
  std::size_t loaded_pages() const noexcept;
  std::size_t loaded_bytes() const noexcept;  ///< of their keys and tables (Clip::byte_size)

 private:
  struct Slot {
    std::size_t page;
    Clip clip;
  };

  std::optional<std::size_t> page_of_window(std::size_t place) const noexcept;
  bool is_in_window(std::size_t page) const noexcept;
  const Slot* find(std::size_t page) const noexcept;
  const Slot* nearest(double time_s) const noexcept;

  Clip head_;
  Clip shown_head_;  ///< of kept_joints
  double page_s_;
  std::size_t page_count_;
  Options options_;

  mutable std::mutex lock_;  ///< of all below
  std::vector<Slot> slots_;  ///< at most options_.window
  std::size_t playing_ = 0;  ///< page
  bool backwards_ = false;
};

}  // namespace sinew
