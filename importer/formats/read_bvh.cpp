// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <optional>
#include <system_error>
#include <utility>

#include "importer/formats/bvh.h"
#include "importer/formats/text_scanner.h"
#include "importer/issue_log.h"

namespace sinew::formats {
namespace {

constexpr double kLargest = 1e30;          // so that sums and units stay within floats
constexpr std::size_t kLongestName = 255;  // end sites repeat the names of their parents

bool same_word(std::string_view word, std::string_view lower) noexcept {
  return std::equal(word.begin(), word.end(), lower.begin(), lower.end(),
                    [](char a, char b) { return static_cast<char>(std::tolower(static_cast<unsigned char>(a))) == b; });
}

/// A number in the notation of C, independent of the locale.
std::optional<double> number_of(std::string_view word) noexcept {
  if (word.starts_with('+')) word.remove_prefix(1);
  double value = 0.0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (word.empty() || end != word.data() + word.size()) return std::nullopt;
  if (error == std::errc()) return value;
  if (error != std::errc::result_out_of_range) return std::nullopt;
  return word.find("e-") != word.npos || word.find("E-") != word.npos ? 0.0 : HUGE_VAL;  // too small or too large
}

std::optional<BvhChannel> channel_of(std::string_view word) noexcept {
  constexpr std::string_view kNames[] = {"xposition", "yposition", "zposition", "xrotation", "yrotation", "zrotation"};
  const auto found =
      std::find_if(std::begin(kNames), std::end(kNames), [&](std::string_view name) { return same_word(word, name); });
  if (found == std::end(kNames)) return std::nullopt;
  const auto index = found - std::begin(kNames);
  return BvhChannel{index >= 3, static_cast<std::uint8_t>(index % 3)};
}

/// Reads the two sections of a file. Each step returns false after the first fault.
class BvhReader {
 public:
  explicit BvhReader(std::string_view text) : scanner_(text) {}

  bool read() { return read_hierarchy() && read_motion_head() && read_frames(); }

  Bvh out;
  ImportIssue fault;

 private:
  bool fail(const char* rule, std::string detail) {
    fault = {Severity::error, rule, place(), std::move(detail)};
    return false;
  }

  std::string place() const { return "line " + std::to_string(scanner_.line()); }

  bool expect(std::string_view lower, const char* rule, const char* expected) {
    const std::string_view word = scanner_.next();
    return same_word(word, lower) || fail(rule, std::string("expected ") + expected + ", found " + found(word));
  }

  static std::string found(std::string_view word) {
    return word.empty() ? std::string("the end of the file") : in_quotes(word);
  }

  bool read_number(double& value) {
    const std::string_view word = scanner_.next();
    const auto number = number_of(word);
    if (!number) return fail("bvh-number", "expected a number, found " + found(word));
    if (!(std::abs(*number) <= kLargest)) return fail("bvh-number", found(word) + " is not a number below 1e30");
    value = *number;
    return true;
  }

  /// Reads a count that fits into the rest of the text.
  bool read_count(std::size_t& count, const char* rule, const char* of) {
    const std::string_view word = scanner_.next();
    const auto number = number_of(word);
    if (!number || !(*number >= 0.0) || *number != std::floor(*number) || *number > 1e15)
      return fail(rule, std::string("expected the number of ") + of + ", found " + found(word));
    count = static_cast<std::size_t>(*number);
    return true;
  }

  bool read_hierarchy() {
    if (!expect("hierarchy", "bvh-hierarchy", "HIERARCHY")) return false;
    do {
      if (!expect("root", "bvh-hierarchy", "ROOT") || !read_tree()) return false;
    } while (same_word(scanner_.peek(), "root"));
    return true;
  }

  /// Reads a root with all joints below it. The word ROOT is read already.
  bool read_tree() {
    if (!open_joint(kNone, false)) return false;
    for (std::uint32_t joint = static_cast<std::uint32_t>(out.joints.size()) - 1; joint != kNone;) {
      const std::string_view word = scanner_.next();
      if (word == "}")
        joint = out.joints[joint].parent;
      else if (out.joints[joint].is_end_site)
        return fail("bvh-hierarchy", "expected } after the end site's OFFSET, found " + found(word));
      else if (same_word(word, "joint") || same_word(word, "end")) {
        if (!open_joint(joint, same_word(word, "end"))) return false;
        joint = static_cast<std::uint32_t>(out.joints.size()) - 1;
      } else
        return fail("bvh-hierarchy", "expected JOINT, End Site or }, found " + found(word));
    }
    return true;
  }

  /// Reads a joint from its name to the last of its channels.
  bool open_joint(std::uint32_t parent, bool is_end_site) {
    BvhJoint joint;
    joint.parent = parent;
    joint.is_end_site = is_end_site;
    joint.name = scanner_.rest_of_line();
    if (joint.name.size() > kLongestName)
      return fail("bvh-hierarchy", "the name " + found(joint.name) + " has more than 255 bytes");
    if (is_end_site) joint.name = out.joints[parent].name + "_end";
    if (!expect("{", "bvh-hierarchy", "{")) return false;
    if (!expect("offset", "bvh-hierarchy", "OFFSET")) return false;
    for (int axis = 0; axis < 3; ++axis)
      if (!read_number(joint.offset[axis])) return false;
    if (same_word(scanner_.peek(), "channels") && !read_channels(joint)) return false;
    out.joints.push_back(std::move(joint));
    return true;
  }

  bool read_channels(BvhJoint& joint) {
    scanner_.next();
    std::size_t count = 0;
    if (!read_count(count, "bvh-channels", "channels")) return false;
    joint.first_channel = out.channel_count;
    for (std::size_t i = 0; i < count; ++i) {
      const std::string_view word = scanner_.next();
      const auto channel = channel_of(word);
      if (!channel)
        return fail("bvh-channels", "CHANNELS promises " + std::to_string(count) + ", but number " +
                                        std::to_string(i + 1) + " is " + found(word) +
                                        "; a channel is Xposition, Zrotation or the like");
      if (!channel->rotates &&
          std::find(joint.channels.begin(), joint.channels.end(), *channel) != joint.channels.end())
        return fail("bvh-channels", found(word) + " is there twice for one joint");
      joint.channels.push_back(*channel);
    }
    out.channel_count += count;
    return true;
  }

  bool read_motion_head() {
    if (!expect("motion", "bvh-motion", "MOTION or ROOT")) return false;
    if (!expect("frames", "bvh-motion", "Frames:")) return false;
    skip_colon();
    if (!read_count(out.frame_count, "bvh-frames", "frames")) return false;
    if (!expect("frame", "bvh-motion", "Frame Time:") || !expect("time", "bvh-motion", "Frame Time:")) return false;
    skip_colon();
    if (!read_number(out.frame_time_s)) return false;
    if (out.frame_time_s < 0.0 || (out.frame_time_s == 0.0 && out.frame_count > 1))
      return fail("bvh-frame-time", "the time of a frame must be more than 0 s");
    return check_last_times();
  }

  void skip_colon() {
    if (scanner_.peek() == ":") scanner_.next();
  }

  /// Key times are floats: the last two must differ.
  bool check_last_times() {
    if (out.frame_count < 2) return true;
    const auto time = [&](std::size_t frame) {
      return static_cast<float>(static_cast<double>(frame) * out.frame_time_s);
    };
    const float last = time(out.frame_count - 1);
    if (std::isfinite(last) && time(out.frame_count - 2) < last) return true;
    return fail("bvh-frame-time", "so many frames of this time cannot be told apart in 32 bits");
  }

  bool read_frames() {
    if (out.channel_count == 0 && out.frame_count > 1)
      return fail("bvh-frames", "there are frames, but no joint has channels");
    const std::size_t fits = scanner_.most_words_left() / std::max<std::size_t>(out.channel_count, 1);
    out.values.reserve(std::min(out.frame_count, fits) * out.channel_count);
    for (std::size_t frame = 0; frame < out.frame_count; ++frame)
      for (std::size_t c = 0; c < out.channel_count; ++c) {
        if (scanner_.peek().empty())
          return fail("bvh-frames", "the file ends in frame " + std::to_string(frame + 1) + " of " +
                                        std::to_string(out.frame_count) + "; with `Frames: " + std::to_string(frame) +
                                        "` the whole ones before it can be imported");
        double value = 0.0;
        if (!read_number(value)) return false;
        out.values.push_back(value);
      }
    if (!scanner_.peek().empty())
      out.warnings.push_back({Severity::warning, "bvh-frames", place(),
                              "there is more behind the " + std::to_string(out.frame_count) +
                                  " frames that `Frames:` promises; it is left out"});
    return true;
  }

  TextScanner scanner_;
};

}  // namespace

tl::expected<Bvh, ImportIssue> read_bvh(std::string_view text) {
  BvhReader reader(text);
  if (!reader.read()) return tl::unexpected(std::move(reader.fault));
  return std::move(reader.out);
}

}  // namespace sinew::formats
