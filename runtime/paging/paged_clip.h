// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <optional>
#include <span>
#include <vector>

#include <tl/expected.hpp>

#include "runtime/base/api.h"
#include "runtime/base/result.h"
#include "runtime/clip/clip_file.h"
#include "runtime/paging/page_table.h"

namespace sinew {

/// The page of a PagedClip to sample at a time.
///
///     const PageSample at = paged.at(time_s);
///     const ClipLayer layer{.clip = number, .time_s = at.time_s, .page = &at.page};
///
/// owns  its page, so that a later load cannot destroy the keys. Keep it until the frame has run. If a layer is held
///       over several frames (lod/update_rate.h), keep it until the last of them has run.
struct PageSample {
  Clip page;                ///< the clip for ClipLayer::page or SampleClipJob::clip
  double time_s = 0.0;      ///< the time for ClipLayer::time_s
  bool is_missing = false;  ///< the page for this time is not loaded; here is the nearest loaded pose
};

/// A long clip with a bounded number of pages in memory: those around the playing time. The engine's loader asks for
/// the most urgent page, reads its bytes from wherever they are, and passes them in:
///
///     while (const auto page = paged.next_page()) paged.load_page(*page, bytes_of(*page));    // on any thread
///
/// One thread calls `at`. There may be several loader threads, and they may be late. A page that is loaded samples the
/// same bits as the whole clip.
class SINEW_API PagedClip {
 public:
  struct Options {
    std::size_t window = 4;  ///< most pages in memory, at least 2: the playing one and the next ones. A window of 3
                             ///< or more also has the previous one
    bool loops = true;       ///< the first page follows the last one
    std::vector<std::uint32_t> kept_joints = {};  ///< for a plan with a skeleton LOD, its kept_joints
                                                  ///< (plan/compile_plan.h); empty = all joints
  };

  /// Checks the numbers of a paged clip before it is constructed.
  /// err  unsupported: no pages, a page length that is not above 0, or a window of fewer than 2 pages. The constructor
  ///      breaks a contract for such numbers
  static ErrorCode check(double page_s, std::size_t page_count, const Options& options) noexcept;

  /// A paged clip without loaded pages.
  /// in   head        first_keys() of the clip, with all joints. Plans are compiled with it, and it is shown while no
  ///                  page is loaded
  ///      page_s, page_count   as in PageTable, page_count > 0
  PagedClip(Clip head, double page_s, std::size_t page_count, const Options& options);
  PagedClip(Clip head, double page_s, std::size_t page_count) : PagedClip(std::move(head), page_s, page_count, {}) {}

  /// The page for a time. Moves the window to this time.
  /// in   time_s     clip time, as PlaybackClock::time_s
  ///      backwards  the clip plays backwards, so the previous pages are needed next
  /// cost O(window), no allocation. Takes a lock that loaders hold for O(window), too
  PageSample at(double time_s, bool backwards = false) noexcept;

  /// The most urgent page of the window that is not loaded; nullopt if all are. Two loaders may get the same page.
  /// cost O(window^2)
  std::optional<std::size_t> next_page() const noexcept;

  /// Stores a page if it is still in the window. It takes the place of a page outside of the window.
  /// out  true if the page is in memory now
  /// err  ClipFileError: those of load_clips, and clip-page (the block holds a page of another number or another clip)
  /// cost O(bytes), allocates the page
  tl::expected<bool, ClipFileError> load_page(std::size_t page, std::span<const std::byte> bytes);

  std::size_t page_count() const noexcept { return page_count_; }
  std::size_t loaded_pages() const noexcept;
  std::size_t loaded_bytes() const noexcept;  ///< sum of their Clip::byte_size

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
  Clip shown_head_;  ///< head_ with the kept joints only
  double page_s_;
  std::size_t page_count_;
  Options options_;

  mutable std::mutex lock_;  ///< guards the members below
  std::vector<Slot> slots_;  ///< at most options_.window
  std::size_t playing_ = 0;  ///< page of the time that plays
  bool backwards_ = false;
};

}  // namespace sinew
