// SPDX-License-Identifier: MIT
#include "runtime/clip/clip_file.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <utility>

#include "runtime/base/all_finite.h"
#include "runtime/base/checksum.h"
#include "runtime/base/same_bits.h"
#include "runtime/clip/annotation_bytes.h"
#include "runtime/clip/byte_stream.h"
#include "runtime/clip/clip_layout.h"

namespace sinew {
namespace {

constexpr char kMagic[8] = {'S', 'I', 'N', 'E', 'W', 'C', 'L', 'P'};
/// Tables that the loader computes (JointPlaces, base poses) may take kMadeBytes plus kMadeTimes the size of the
/// block.
constexpr std::uint64_t kMadeBytes = std::uint64_t{16} << 20, kMadeTimes = 64;

void write_certificate(const std::optional<ClipCertificate>& certificate, ByteWriter& out) {
  out.add(static_cast<std::uint8_t>(certificate.has_value()));
  if (!certificate) return;
  const ClipCertificate& c = *certificate;
  for (const double x : {c.asked_m, c.measured_m, c.weights_m, c.worst_time_s}) out.add(x);
  for (const std::uint32_t x : {c.worst_joint, c.times_checked, c.animated_joints}) out.add(x);
  for (const std::uint64_t x : {c.source_keys, c.kept_keys, c.source_bytes, c.bytes}) out.add(x);
}

template <class T>
void write_all(const std::vector<T>& numbers, ByteWriter& out) {
  out.add(std::span<const T>(numbers));
}

/// Tables are [component][lane]. A range is the two halves of `low` and, if the component takes bits, the upper half
/// of `step`. A derived component has no range.
void write_packed(const TrackBlock& block, std::size_t key_count, ByteWriter& out) {
  std::vector<PackedTrack> tracks;
  for (std::size_t lane = 0; lane < block.lane_count; ++lane)
    tracks.push_back(packed_range(block.packed, block.lane_count, lane));
  std::vector<std::uint8_t> widths, derived;
  std::vector<std::uint16_t> ranges;
  for (std::size_t c = 0; c < tracks.front().components; ++c)
    for (const PackedTrack& track : tracks) {
      widths.push_back(track.width[c]);
      if (c == track.derived) continue;
      const auto low = std::bit_cast<std::uint32_t>(track.low[c]);
      ranges.push_back(static_cast<std::uint16_t>(low >> 16));
      ranges.push_back(static_cast<std::uint16_t>(low));
      if (track.width[c] > 0)
        ranges.push_back(static_cast<std::uint16_t>(std::bit_cast<std::uint32_t>(track.step[c]) >> 16));
    }
  if (block.property == Property::rotation)
    for (const PackedTrack& track : tracks) derived.push_back(track.derived);
  write_all(widths, out);
  write_all(derived, out);
  write_all(ranges, out);
  write_all(in_lane_order(block.packed, block.lane_count, key_count), out);
}

void write_block(const TrackBlock& block, std::size_t key_count, ByteWriter& out) {
  out.add(static_cast<std::uint8_t>(block.property));
  out.add(static_cast<std::uint8_t>(block.interpolation));
  out.add(static_cast<std::uint8_t>(!block.packed.empty()));
  write_rising(block.targets, out);
  if (block.packed.empty()) return out.add(std::span(block.rows).first(block.rows.size() - kLanePadding));
  write_packed(block, key_count, out);
}

constexpr Property kOfJoints[] = {Property::translation, Property::rotation, Property::scale};

/// Joints whose property is not animated by any block, so that it comes from the base pose.
std::vector<std::uint32_t> resting_joints(const ClipLayout& clip, Property property) {
  std::vector<bool> moved(clip.joint_count, false);
  for (const TimeGroup& group : clip.groups)
    for (const TrackBlock& block : group.blocks)
      for (const std::uint32_t joint : block.targets)
        if (block.property == property) moved[joint] = true;
  std::vector<std::uint32_t> resting;
  for (std::uint32_t j = 0; j < moved.size(); ++j)
    if (!moved[j]) resting.push_back(j);
  return resting;
}

/// Calls `visit(value)` for each base value of a property of these joints.
template <class Base, class Visit>
void each_base(Base& base, Property property, const std::vector<std::uint32_t>& joints, const Visit& visit) {
  const std::size_t first = first_plane(property), count = property == Property::rotation ? 4 : 3;
  for (const std::uint32_t j : joints)
    for (std::size_t plane = first; plane < first + count; ++plane) visit(base.planes[plane * base.stride + j]);
}

/// Base values of a property of these joints.
std::vector<float> base_values(const BasePose& base, Property property, const std::vector<std::uint32_t>& joints) {
  std::vector<float> values;
  each_base(base, property, joints, [&](float x) { values.push_back(x); });
  return values;
}

void write_head(const ClipLayout& clip, ByteWriter& out) {
  out.add(std::span<const char>(clip.name));
  out.add(clip.duration_s);
  out.add(static_cast<std::uint64_t>(clip.joint_count));
  out.add(clip.counts.folded);
  write_certificate(clip.certificate, out);
  write_annotations(clip.annotations, out);
}

/// The tracks and base values of a clip, without its name and certificate.
void write_tracks(const ClipLayout& clip, ByteWriter& out) {
  write_all(clip.base_weights.all(), out);
  write_all(clip.base_properties.all(), out);
  out.add(static_cast<std::uint32_t>(clip.groups.size()));
  for (const TimeGroup& group : clip.groups) {
    write_times(group.times.times_s(), out);
    out.add(static_cast<std::uint32_t>(group.blocks.size()));
    for (const TrackBlock& block : group.blocks) write_block(block, group.times.key_count(), out);
  }
  const BasePose identity{std::vector<Transform>(clip.joint_count)};
  BasePose base = identity;
  clip.base_pose.copy_to(base.planes.data());
  for (const Property property : kOfJoints) {
    const std::vector<std::uint32_t> joints = resting_joints(clip, property);
    std::vector<float> values = base_values(base, property, joints);
    const std::vector<float> expected = base_values(identity, property, joints);
    if (same_bits<float>(values, expected)) values.clear();  // compares bits: -0 is stored
    out.add(static_cast<std::uint32_t>(values.size()));
    for (std::size_t i = 0; i < values.size(); ++i) write_near(values[i], expected[i], out);
  }
}

/// Reads clips, and keeps the first broken rule.
class Loader {
 public:
  explicit Loader(std::span<const std::byte> block)
      : in_(block, kClipFileHead), left_(kMadeBytes + kMadeTimes * block.size()) {}

  ClipLayout clip() {
    ClipLayout clip;
    const std::vector<char> name = in_.numbers<char>();
    clip.name.assign(name.begin(), name.end());
    clip.duration_s = in_.number<double>();
    clip.joint_count = in_.number<std::uint64_t>();
    clip.counts.folded = in_.number<std::uint32_t>();
    clip.certificate = certificate();
    require(std::isfinite(clip.duration_s) && clip.duration_s >= 0.0, "the duration is not a time");
    clip.annotations = read_annotations(in_);
    require(check(clip.annotations, clip.duration_s) == ErrorCode::ok, "an event or a curve breaks its rules");
    std::vector<float> weights = in_.numbers<float>(), properties = in_.numbers<float>();
    require(all_finite(weights) && all_finite(properties), "a base value is not finite");
    clip.base_weights = base(std::move(weights), weights_);
    clip.base_properties = base(std::move(properties), properties_);
    for (auto left = in_.number<std::uint32_t>(); left > 0 && ok(); --left) add_group(clip);
    clip.counts.time_groups = static_cast<std::uint32_t>(clip.groups.size());
    read_base(clip);
    return clip;
  }

  /// False once a rule is broken or bytes are missing; error() then has the first one.
  bool ok() {
    if (in_.ended() && error_.rule.empty()) error_ = {"clip-size", in_.offset(), "the block ends inside of a clip"};
    return error_.rule.empty();
  }
  std::uint32_t count() { return in_.number<std::uint32_t>(); }
  void require_end() {
    if (ok() && in_.left() > 0) error_ = {"clip-size", in_.offset(), "bytes follow the last clip"};
  }
  const ClipFileError& error() const noexcept { return error_; }

 private:
  void require(bool holds, const char* detail) {
    if (ok() && !holds) error_ = {"clip-value", in_.offset(), detail};
  }

  std::optional<ClipCertificate> certificate() {
    const auto present = in_.number<std::uint8_t>();
    require(present <= 1, "the certificate is neither there nor missing");
    if (present != 1) return std::nullopt;
    ClipCertificate c;
    for (double* x : {&c.asked_m, &c.measured_m, &c.weights_m, &c.worst_time_s}) {
      *x = in_.number<double>();
      require(std::isfinite(*x), "a length of the certificate is not finite");
    }
    for (std::uint32_t* x : {&c.worst_joint, &c.times_checked, &c.animated_joints}) *x = in_.number<std::uint32_t>();
    for (std::uint64_t* x : {&c.source_keys, &c.kept_keys, &c.source_bytes, &c.bytes}) *x = in_.number<std::uint64_t>();
    return c;
  }

  /// Takes bytes from the limit for computed tables, whose size a few bytes of the block decide.
  void take(std::uint64_t bytes) {
    require(bytes <= left_, "the clip has far more joints than its tracks account for");
    left_ -= std::min(left_, bytes);
  }

  void read_base(ClipLayout& clip) {
    require(clip.joint_count < kNone / 16, "too many joints");
    if (ok()) take(clip.joint_count * std::uint64_t{48} + 640);
    if (!ok()) return;
    BasePose pose{std::vector<Transform>(clip.joint_count)};
    for (const Property property : kOfJoints) {
      const std::vector<std::uint32_t> joints = resting_joints(clip, property);
      const auto count = in_.number<std::uint32_t>();
      require(count == 0 || count == joints.size() * (property == Property::rotation ? 4 : 3),
              "the base pose is not of the clip's size");
      if (!ok() || count == 0) continue;
      bool finite = true;
      each_base(pose, property, joints, [&](float& x) { finite = std::isfinite(x = read_near(x, in_)) && finite; });
      require(finite, "a base value is not finite");
    }
    clip.base_pose = base(std::move(pose.planes), pose_);
  }

  /// Values equal to those of the first clip of the block are shared.
  static BaseNumbers base(std::vector<float> numbers, RestNumbers& shared) {
    if (shared != nullptr && shared->size() == numbers.size()) return BaseNumbers::over(shared, numbers);
    shared = rest_numbers(std::move(numbers));
    return BaseNumbers(shared);
  }

  void add_group(ClipLayout& clip) {
    std::vector<float> times = read_times(in_);
    require(!times.empty() && all_finite(times) && std::is_sorted(times.begin(), times.end()),
            "key times are not finite, rising numbers");
    if (!ok()) return;
    TimeGroup group{KeyTimes(std::move(times)), {}};
    for (auto left = in_.number<std::uint32_t>(); left > 0 && ok(); --left)
      group.blocks.push_back(block(clip, group.times.key_count()));
    clip.groups.push_back(std::move(group));
  }

  TrackBlock block(ClipLayout& clip, std::size_t keys) {
    const auto property = in_.number<std::uint8_t>(), interpolation = in_.number<std::uint8_t>(),
               packed = in_.number<std::uint8_t>();
    std::vector<std::uint32_t> targets = read_rising(in_);
    require(property <= static_cast<std::uint8_t>(Property::number) &&
                interpolation <= static_cast<std::uint8_t>(Interpolation::squad) && packed <= 1,
            "a block of tracks is of no known kind");
    if (!ok()) return {};
    TrackBlock block =
        block_of(static_cast<Property>(property), static_cast<Interpolation>(interpolation), targets.size());
    block.targets = std::move(targets);
    require(block.interpolation != Interpolation::squad || block.property == Property::rotation,
            "squad is for rotations");
    add_targets(clip, block);
    if (!ok()) return {};
    if (packed == 1)
      read_packed(block, keys);
    else
      read_rows(block, keys);
    count_tracks(block, clip.counts);
    return block;
  }

  void add_targets(const ClipLayout& clip, TrackBlock& block) {
    const auto& t = block.targets;
    const bool joints = block.property < Property::weight;
    const std::size_t count = joints                               ? clip.joint_count
                              : block.property == Property::weight ? clip.base_weights.size()
                                                                   : clip.base_properties.size();
    const auto out_of_order = [&](std::uint32_t a, std::uint32_t b) { return joints ? b <= a : b != a + 1; };
    require(!t.empty() && t.back() < count && std::adjacent_find(t.begin(), t.end(), out_of_order) == t.end(),
            "the targets of a block are not rising numbers of the clip");
    if (!ok() || !joints) return;
    take((t.back() - t.front() + 32) * std::uint64_t{5});
    if (ok()) block.places = JointPlaces(t);
  }

  void read_rows(TrackBlock& block, std::size_t keys) {
    std::vector<float> rows = in_.numbers<float>(kLanePadding);
    const std::uint64_t size = rows.size() - kLanePadding, row = std::uint64_t{block.plane_count} * block.lane_count;
    require(size / row == keys && size % row == 0, "a block does not have a row for each key");
    require(all_finite(std::span<const float>(rows)), "a key is not finite");
    block.rows = SharedArray(std::move(rows));
  }

  void read_packed(TrackBlock& block, std::size_t keys) {
    const std::size_t lanes = block.lane_count,
                      components = block.property == Property::rotation ? 4 : block.plane_count;
    require(block.interpolation == Interpolation::step || block.interpolation == Interpolation::linear,
            "only step and linear keys are packed");
    const auto widths = in_.numbers<std::uint8_t>(), derived = in_.numbers<std::uint8_t>();
    const auto ranges = in_.numbers<std::uint16_t>();
    const auto bits = in_.numbers<std::uint8_t>();
    require(lanes <= kMostPackedLanes && widths.size() == lanes * components &&
                derived.size() == (components == 4 ? lanes : 0),
            "the tables of a packed block are not of its size");
    require(std::all_of(derived.begin(), derived.end(), [](std::uint8_t c) { return c <= PackedTrack::kNoneDerived; }),
            "no such component");
    require(std::all_of(widths.begin(), widths.end(), [](std::uint8_t w) { return w <= PackedTrack::kMostBits; }),
            "a packed number is too wide");
    if (!ok()) return;
    std::vector<PackedTrack> tracks(lanes);
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      tracks[lane].components = static_cast<std::uint32_t>(components);
      if (!derived.empty()) tracks[lane].derived = derived[lane];
      for (std::size_t c = 0; c < components; ++c) tracks[lane].width[c] = widths[c * lanes + lane];
      require(tracks[lane].bits_per_key() <= PackedTrack::kMostKeyBits, "a packed key is too wide");
    }
    read_ranges(tracks, ranges);
    require(bits.size() == keys * packed_row_bytes(tracks), "packed keys are not of their size");
    if (components == 4) take(keys);
    if (ok()) block.packed = packed_rows(tracks, bits, keys);
  }

  void read_ranges(std::vector<PackedTrack>& tracks, std::span<const std::uint16_t> ranges) {
    std::size_t expected = 0;
    for (const PackedTrack& track : tracks)
      for (std::size_t c = 0; c < track.components; ++c) {
        require(c != track.derived || track.width[c] == 0, "a component that is left out has bits");
        expected += c == track.derived ? 0 : track.width[c] > 0 ? 3 : 2;
      }
    require(ranges.size() == expected, "the ranges of packed keys are not as many as their components");
    if (!ok()) return;
    const std::uint16_t* next = ranges.data();
    for (std::size_t c = 0; c < tracks.front().components; ++c)
      for (PackedTrack& track : tracks) {
        if (c == track.derived) continue;
        const std::uint32_t upper = *next++, lower = *next++;
        track.low[c] = std::bit_cast<float>(upper << 16 | lower);
        if (track.width[c] > 0) track.step[c] = std::bit_cast<float>(std::uint32_t{*next++} << 16);
        require(std::isfinite(track.low[c]) && std::isfinite(track.step[c]), "a range of packed keys is not finite");
        require(track.width[c] == 0 || std::abs(track.step[c]) >= PackedTrack::kLeastStep,
                "a step of packed keys is too small");
      }
  }

  ByteReader in_;
  std::uint64_t left_;
  RestNumbers pose_, weights_, properties_;  ///< base values of the first clip
  ClipFileError error_;
};

}  // namespace

std::vector<std::byte> save_clips(std::span<const Clip* const> clips) {
  ByteWriter body;
  body.add(static_cast<std::uint32_t>(clips.size()));
  for (const Clip* clip : clips) {
    write_head(clip->layout(), body);
    write_tracks(clip->layout(), body);
  }
  ByteWriter out;
  for (const char c : kMagic) out.add(c);
  out.add(kClipFileVersion);
  out.add(std::uint32_t{0});
  out.add(static_cast<std::uint64_t>(kClipFileHead + body.bytes().size()));
  out.add(checksum(body.bytes()));
  out.bytes().insert(out.bytes().end(), body.bytes().begin(), body.bytes().end());
  return std::move(out.bytes());
}

std::size_t saved_bytes(const Clip& clip) {
  ByteWriter body;
  write_tracks(clip.layout(), body);
  return body.bytes().size();
}

bool looks_like_clips(std::span<const std::byte> block) noexcept {
  return block.size() >= sizeof(kMagic) && std::memcmp(block.data(), kMagic, sizeof(kMagic)) == 0;
}

tl::expected<std::vector<Clip>, ClipFileError> load_clips(std::span<const std::byte> block) {
  const auto refuse = [](const char* rule, std::uint64_t offset, const char* detail) {
    return tl::unexpected(ClipFileError{rule, offset, detail});
  };
  if (!looks_like_clips(block)) return refuse("clip-magic", 0, "these are no compiled clips");
  if (block.size() < kClipFileHead) return refuse("clip-size", block.size(), "the block ends inside of its head");
  ByteReader head(block, sizeof(kMagic));
  if (const auto version = head.number<std::uint32_t>(); version != kClipFileVersion)
    return refuse("clip-version", 8,
                  version < kClipFileVersion ? "compiled by an older version of the library: compile the clips again"
                                             : "compiled by a newer version of the library: compile the clips again");
  if (head.number<std::uint32_t>() != 0) return refuse("clip-value", 12, "reserved bytes are not 0");
  if (head.number<std::uint64_t>() != block.size())
    return refuse("clip-size", 16, "the block is longer or shorter than it says");
  if (head.number<std::uint64_t>() != checksum(block.subspan(kClipFileHead)))
    return refuse("clip-checksum", 24, "the block has changed since it was written");
  Loader loader(block);
  std::vector<Clip> clips;
  for (std::uint32_t left = loader.count(); left > 0 && loader.ok(); --left) {
    ClipLayout layout = loader.clip();
    if (loader.ok()) clips.push_back(clip_of(std::move(layout)));
  }
  loader.require_end();
  if (!loader.ok()) return tl::unexpected(loader.error());
  return clips;
}

}  // namespace sinew
