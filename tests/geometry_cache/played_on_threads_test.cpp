// SPDX-License-Identifier: MIT
// Characters play one cache on several threads, and another thread finishes reads. A separate program without the
// importer, so that the thread sanitizer can run it.
#include <gtest/gtest.h>

#include <atomic>
#include <deque>
#include <thread>
#include <vector>

#include "runtime/base/same_bits.h"
#include "runtime/geometry_cache/geometry_player.h"
#include "runtime/geometry_cache/scene_of_cache.h"
#include "runtime/threads/job_thread.h"
#include "tests/geometry_cache/disk.h"
#include "tests/golden/decoded_hash.h"

namespace sinew::test {
namespace {

/// The cloth of tests/golden; its first mesh plays.
class played_on_threads : public testing::Test {
 protected:
  played_on_threads() {
    needs_.in.cached_instances = {0};
    plan_ = compile_plan(lend(made_.scene), needs_);
    GeometryDecoder decoder(cache_);
    for (std::uint32_t f = 0; f < cache_.frame_count(); ++f) {
      EXPECT_EQ(decoder.decode(f, mapped_), GeometryStatus::ok);
      truth_.push_back(vertices(decoder));
    }
  }

  std::vector<glm::vec3> vertices(GeometryDecoder& decoder) const {
    std::vector<glm::vec3> out(cache_.meshes()[0].vertex_count);
    EXPECT_EQ(decoder.write_vertices(0, out), GeometryStatus::ok);
    return out;
  }
  double time_of(std::uint32_t frame) const { return cache_.start_s() + frame * cache_.frame_s(); }

  Disk disk_{bytes_of_file(SINEW_SOURCE_DIR "/tests/golden/cloth.sgeo")};
  GeometryCache cache_ = *GeometryCache::open(disk_.file);
  MappedFrames mapped_{cache_, disk_.file};
  CacheScene made_ = *scene_of(cache_, mapped_);
  std::vector<std::vector<glm::vec3>> truth_;  // [frames]
  Needs needs_;
  Plan plan_;
};

TEST_F(played_on_threads, reads_may_finish_on_another_thread) {
  disk_.at_once = false;
  GeometryDecoder decoder(cache_);
  FrameWindow window(cache_, disk_.reader(), 4);
  for (std::uint32_t shown = 0; shown < 20; ++shown) {
    const std::uint32_t frame = shown % cache_.frame_count();
    window.prefetch(decoder.next_for(frame));
    std::thread io([&] { disk_.deliver(100); });
    while (decoder.decode(frame, window) == GeometryStatus::not_loaded) std::this_thread::yield();
    io.join();
    ASSERT_EQ(decoder.frame(), frame);
    ASSERT_TRUE(same_bits<glm::vec3>(vertices(decoder), truth_[frame])) << frame;
  }
  disk_.deliver(100);
}

/// Characters at different frames, each with its own window, on a job thread that uses several threads.
class Troupe {
 public:
  static constexpr std::uint32_t kCharacters = 4;

  Troupe(const GeometryCache& cache, const CacheScene& made, const Plan& plan, Disk& disk) {
    for (std::uint32_t c = 0; c < kCharacters; ++c) {
      windows_.emplace_back(cache, disk.reader(), 3);
      players_.emplace_back(cache, windows_.back(), made.scene, std::vector{made.bindings[0]});
      jobs_.add_character(plan);
    }
  }

  void show(const std::vector<double>& times_s) {
    std::vector<GeometryInput> geometry;
    for (std::uint32_t c = 0; c < kCharacters; ++c) geometry.push_back(players_[c].at(times_s[c]));
    std::vector<FrameInput> inputs(kCharacters);
    for (std::uint32_t c = 0; c < kCharacters; ++c) inputs[c].geometry = {&geometry[c], 1};
    const auto ticket = jobs_.submit(inputs);
    ASSERT_TRUE(ticket.has_value());
    jobs_.wait(*ticket);
    ASSERT_EQ(jobs_.last_error(), ErrorCode::ok);
  }
  const FrameResult& shown(std::uint32_t c) { return *jobs_.latest(c); }

 private:
  std::deque<FrameWindow> windows_;
  std::deque<GeometryPlayer> players_;
  JobThread jobs_{{.inline_below_bytes = 0, .part_bytes = 1}};
};

TEST_F(played_on_threads, characters_share_one_reader) {
  Troupe troupe(cache_, made_, plan_, disk_);
  for (std::uint32_t step = 0; step < 30; ++step) {
    const auto frame = [&](std::uint32_t c) { return (step + 7 * c) % cache_.frame_count(); };
    std::vector<double> times_s;
    for (std::uint32_t c = 0; c < Troupe::kCharacters; ++c) times_s.push_back(time_of(frame(c)));
    troupe.show(times_s);
    for (std::uint32_t c = 0; c < Troupe::kCharacters; ++c)
      EXPECT_TRUE(same_bits<glm::vec3>(troupe.shown(c).primitives[0].positions, truth_[frame(c)])) << step << ' ' << c;
  }
}

TEST_F(played_on_threads, characters_show_what_is_there_while_another_thread_reads) {
  disk_.at_once = false;
  disk_.waiting.reserve(64);
  std::atomic<bool> ends = false;
  std::thread io([&] {
    while (!ends) {
      disk_.deliver(1);
      std::this_thread::yield();
    }
    disk_.deliver(100);
  });
  {
    Troupe troupe(cache_, made_, plan_, disk_);
    for (std::uint32_t frame = 0; frame < cache_.frame_count(); ++frame)
      for (bool all_there = false; !all_there;) {
        troupe.show(std::vector(Troupe::kCharacters, time_of(frame)));
        all_there = true;
        for (std::uint32_t c = 0; c < Troupe::kCharacters; ++c) {
          const FrameResult& shown = troupe.shown(c);
          const bool late = shown.instances[0].late;
          EXPECT_TRUE(late || same_bits<glm::vec3>(shown.primitives[0].positions, truth_[frame])) << frame << ' ' << c;
          all_there = all_there && !late;
        }
      }
    ends = true;
    io.join();
  }
}

}  // namespace
}  // namespace sinew::test
