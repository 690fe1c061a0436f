// SPDX-License-Identifier: MIT
#include "viewer/app/cache/cache_playback.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <thread>

#include "runtime/plan/plan_stages.h"
#include "runtime/plan/run_plan.h"
#include "tests/viewer/cache_files.h"

namespace sinew::viewer {
namespace {

using testing::HasSubstr;
using Reads = CacheReader::Reads;

/// A cache without a glTF file, evaluated at any time.
class Played {
 public:
  Played(const CacheAlone& alone, Reads reads)
      : playback(*alone.cache, alone.scene, reads),
        plan_(compile_plan(lend(alone.scene), needs(alone))),
        frame_(plan_) {}

  const FrameResult& at(double time_s, float weight = 1.0f) {
    FrameInput input;
    input.geometry = playback.at(time_s, weight);
    EXPECT_EQ(run_plan(plan_, input, frame_), ErrorCode::ok);
    playback.watch(frame_.result());
    return frame_.result();
  }

  CachePlayback playback;

 private:
  static Needs needs(const CacheAlone& alone) {
    Needs needs;
    needs.in.cached_instances = alone.cache->instances();
    needs.out.stage_times = true;
    return needs;
  }
  Plan plan_;
  FrameBuffer frame_;
};

std::vector<glm::vec3> positions(const FrameResult& frame) {
  return {frame.primitives[0].positions.begin(), frame.primitives[0].positions.end()};
}

TEST(cache_playback, shows_the_frame_of_the_time) {
  const Bytes bytes = flag_bytes(20, 1.5);
  const CacheAlone alone = flag_alone(bytes);
  Played played(alone, Reads::blocking);
  GeometryDecoder decoder(alone.cache->file.cache);
  MappedFrames source{alone.cache->file.cache, bytes};
  std::vector<glm::vec3> expected(alone.cache->file.cache.meshes()[0].vertex_count);
  for (const std::uint32_t frame : {0u, 7u, 6u, 19u}) {
    ASSERT_EQ(decoder.decode(frame, source), GeometryStatus::ok);
    decoder.write_vertices(0, expected);
    EXPECT_EQ(positions(played.at(frame / 30.0)), expected) << frame;
  }
}

TEST(cache_playback, order_of_times_changes_nothing) {
  const Bytes bytes = flag_bytes();
  const CacheAlone alone = flag_alone(bytes);
  const std::vector<double> times = {0.0, 0.01, 0.2, 0.333, 0.5, 0.61, 0.633};
  std::vector<std::vector<glm::vec3>> forward;
  Played first(alone, Reads::blocking), second(alone, Reads::blocking), third(alone, Reads::on_thread);
  for (const double t : times) forward.push_back(positions(first.at(t)));
  for (std::size_t i = times.size(); i-- > 0;) EXPECT_EQ(positions(second.at(times[i])), forward[i]) << times[i];
  for (const std::size_t i : {3u, 0u, 6u, 1u, 5u, 2u, 4u}) {
    while (is_late(third.at(times[i]))) std::this_thread::yield();
    EXPECT_EQ(positions(third.at(times[i])), forward[i]) << times[i];
  }
}

TEST(cache_playback, plays_forward_and_backward_within_one_window_and_reads_each_frame_once) {
  const Bytes bytes = flag_bytes(16);
  const CacheAlone alone = flag_alone(bytes);
  Played played(alone, Reads::blocking);
  std::uint64_t frames = 0;
  for (const GeometryFrame& frame : alone.cache->file.cache.frames()) frames += frame.size;
  for (int f = 0; f < 16; ++f) played.at(f / 30.0);
  for (int f = 16; f-- > 0;) played.at(f / 30.0);
  EXPECT_EQ(played.playback.bytes_read(), frames) << "two segments fit";
}

TEST(cache_playback, tells_what_it_takes) {
  const Bytes bytes = flag_bytes();
  const CacheAlone alone = flag_alone(bytes);
  Played played(alone, Reads::blocking);
  EXPECT_FALSE(played.playback.facts().ns_per_vertex);
  for (int f = 0; f < 6; ++f) played.at(f / 30.0);
  const CacheFacts facts = played.playback.facts();
  EXPECT_EQ(facts.name, "flag");
  EXPECT_NEAR(facts.frame_s, 1.0 / 30.0, 1e-9);
  EXPECT_EQ(facts.frame_count, 20u);
  EXPECT_EQ(facts.vertex_count, 33u * 25u);
  EXPECT_EQ(facts.window_frames, 16u) << "a segment and what is read ahead";
  EXPECT_GT(facts.frames_loaded, 5u);
  EXPECT_LE(facts.frames_loaded, facts.window_frames);
  EXPECT_GT(facts.window_bytes, 0u);
  ASSERT_TRUE(facts.ns_per_vertex);
  EXPECT_GT(*facts.ns_per_vertex, 0.0);
  EXPECT_EQ(facts.late, 0u);
  const Bytes few = flag_bytes(10);
  const CacheAlone brief = flag_alone(few);
  EXPECT_EQ(CachePlayback(*brief.cache, brief.scene, Reads::blocking).facts().window_frames, 10u) << "all of it";
  EXPECT_EQ(describe_cost({.ns_per_vertex = 3.14, .late = 2}), "3.1 ns a decoded vertex, pictures late: 2");
  EXPECT_EQ(describe_window({.bytes_per_s = 18400.0, .frames_loaded = 3, .window_frames = 40, .window_bytes = 1234567}),
            "18 kB a second read, window 3 of 40 frames in 1.2 MB");
}

/// A frame result with decoded vertices and stage times.
struct Decoded {
  std::array<std::uint64_t, kStageCount> stage_ns{};
  FrameResult frame;

  Decoded(std::uint64_t number, std::uint64_t frames, std::uint64_t vertices, std::uint64_t ns) {
    stage_ns[static_cast<std::size_t>(Stage::geometry_cache)] = ns;
    frame.frame = number;
    frame.stage_ns = stage_ns;
    frame.work.cache_frames_decoded = frames;
    frame.work.vertices_from_cache = vertices;
  }
};

TEST(cache_playback, time_of_a_vertex_follows_the_frames_that_decode_and_each_frame_counts_once) {
  const Bytes bytes = flag_bytes();
  const CacheAlone alone = flag_alone(bytes);
  CachePlayback playback(*alone.cache, alone.scene, Reads::blocking);
  const auto watched = [&](const FrameResult& frame) {
    playback.watch(frame);
    return playback.facts().ns_per_vertex.value_or(-1.0);
  };
  Decoded untimed(1, 2, 100, 4000);
  untimed.frame.stage_ns = {};
  EXPECT_EQ(watched(untimed.frame), -1.0);
  EXPECT_EQ(watched(Decoded(2, 2, 100, 4000).frame), 20.0);
  EXPECT_EQ(watched(Decoded(3, 1, 100, 4000).frame), 20.0 + 0.1 * 20.0);
  EXPECT_EQ(watched(Decoded(3, 1, 100, 9000).frame), 22.0) << "the frame was there already";
  EXPECT_EQ(watched(Decoded(4, 0, 100, 70).frame), 22.0) << "what is held was not decoded";
  const InstanceResult instances[] = {{.late = true}, {}};
  for (const std::uint64_t number : {5u, 5u, 6u}) {
    Decoded late(number, 0, 0, 0);
    late.frame.instances = instances;
    playback.watch(late.frame);
  }
  EXPECT_EQ(playback.facts().late, 2u) << "one instance is late in two frames";
  EXPECT_FALSE(is_late(FrameResult{}));
}

TEST(cache_playback, bytes_a_second_are_those_of_the_last_half_second_or_longer) {
  const Bytes bytes = flag_bytes(40);
  const CacheAlone alone = flag_alone(bytes);
  Played played(alone, Reads::blocking);
  std::uint64_t number = 1000;
  const auto start = CachePlayback::Clock::now() + std::chrono::hours(1);
  const auto rate_after = [&](std::chrono::milliseconds time) {
    FrameResult frame;
    frame.frame = ++number;
    played.playback.watch(frame, start + time);
    return played.playback.facts().bytes_per_s;
  };
  using std::chrono::milliseconds;
  EXPECT_EQ(rate_after(milliseconds(0)), 0.0);
  played.at(0.0);
  const auto first = static_cast<double>(played.playback.bytes_read());
  ASSERT_GT(first, 0.0);
  EXPECT_EQ(rate_after(milliseconds(499)), 0.0) << "too soon to tell";
  EXPECT_EQ(rate_after(milliseconds(500)), first / 0.5);
  played.at(1.0);
  const double second = static_cast<double>(played.playback.bytes_read()) - first;
  ASSERT_GT(second, 0.0);
  EXPECT_EQ(rate_after(milliseconds(900)), first / 0.5);
  EXPECT_EQ(rate_after(milliseconds(2500)), second / 2.0) << "only what was read since";
  EXPECT_EQ(rate_after(milliseconds(3500)), 0.0);
}

TEST(cache_playback, first_picture_of_a_window_is_not_late) {
  const Bytes bytes = flag_bytes();
  const CacheAlone alone = flag_alone(bytes);
  Played played(alone, Reads::on_thread);
  EXPECT_FALSE(is_late(played.at(0.0)));
  EXPECT_EQ(played.playback.facts().late, 0u);
}

TEST(cache_playback, says_which_rule_a_damaged_frame_breaks_and_shows_the_pose) {
  const Bytes bytes = with_damage(flag_bytes(), 10);
  const CacheAlone alone = flag_alone(bytes);
  Played played(alone, Reads::blocking);
  EXPECT_TRUE(played.at(9 / 30.0).instances[0].from_cache);
  EXPECT_EQ(played.playback.fault(), "");
  const FrameResult& damaged = played.at(12 / 30.0);
  EXPECT_FALSE(damaged.instances[0].from_cache);
  EXPECT_THAT(played.playback.fault(), HasSubstr("flag: cache-checksum: "));
  EXPECT_TRUE(played.at(17 / 30.0).instances[0].from_cache) << "the next segment is whole";
  EXPECT_EQ(played.playback.fault(), "");
}

TEST(cache_playback, frames_that_cannot_be_read_are_late_and_for_pictures_a_fault) {
  const Bytes bytes = flag_bytes();
  CacheAlone alone = flag_alone(bytes);
  CacheOnScene gone = *alone.cache;
  gone.file.path = "/nothing/here.sgeo";
  alone.cache = std::make_shared<const CacheOnScene>(gone);
  Played pictures(alone, Reads::blocking), window(alone, Reads::on_thread);
  EXPECT_TRUE(is_late(pictures.at(0.1)));
  EXPECT_THAT(pictures.playback.fault(), HasSubstr("cache-size"));
  EXPECT_TRUE(is_late(window.at(0.1)));
  EXPECT_EQ(window.playback.fault(), "") << "it may come later";
  EXPECT_EQ(window.playback.facts().late, 1u);
}

TEST(cache_playback, without_weight_nothing_is_read) {
  const Bytes bytes = flag_bytes();
  const CacheAlone alone = flag_alone(bytes);
  Played played(alone, Reads::blocking);
  EXPECT_FALSE(played.at(0.3, 0.0f).instances[0].from_cache);
  EXPECT_EQ(played.playback.bytes_read(), 0u);
}

}  // namespace
}  // namespace sinew::viewer
