// SPDX-License-Identifier: MIT
// Makes every field of a block of compiled clips wrong. Each check of load_clips has a case that no other check
// refuses.
#include "tests/clip/clip_fields.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "runtime/pose/sample_clip.h"
#include "tests/support/tiny_assets.h"

namespace sinew {
namespace {

using test::ClipFields;
using Tracks = ClipFields::Tracks;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr std::uint8_t kTranslation = 0, kRotation = 1, kScale = 2, kWeight = 3, kNumber = 4;
constexpr std::uint8_t kStep = 0, kLinear = 1, kSquad = 3;

std::vector<float> steps(std::size_t count) {
  std::vector<float> numbers;
  for (std::size_t i = 0; i < count; ++i) numbers.push_back(0.125f * static_cast<float>(i % 7) + 0.125f);
  return numbers;
}

Tracks full(std::uint8_t property, std::uint8_t interpolation, std::vector<std::uint8_t> gaps, std::size_t numbers) {
  const auto count = static_cast<std::uint32_t>(gaps.size());
  return {property, interpolation, 0, count, std::move(gaps), steps(numbers), {}, {}, {}, {}};
}

/// Adds the halves of `low`, and the upper half of `step` if the component takes bits.
void add_range(std::vector<std::uint16_t>& ranges, std::uint8_t width) {
  ranges.insert(ranges.end(), {0x3e00, 0x0000});  // 0.125
  if (width > 0) ranges.push_back(0x3c00);        // 0.0078125
}

/// The bits of `keys` equal rows.
std::vector<std::uint8_t> rows(std::size_t keys, const std::vector<std::uint8_t>& row) {
  std::vector<std::uint8_t> bits;
  for (std::size_t k = 0; k < keys; ++k) bits.insert(bits.end(), row.begin(), row.end());
  return bits;
}

/// Two rotations, one of them with w as derived component. They take 9 and 8 bits, so a key takes three bytes.
Tracks packed_rotations(std::size_t keys) {
  Tracks t{kRotation, kLinear, 1, 2, {0, 3}, {}, {3, 2, 3, 2, 3, 2, 0, 2}, {3, 4}, {}, rows(keys, {0x5a, 0x5a, 0x01})};
  for (std::size_t at = 0; at < 8; ++at)
    if (at != 6) add_range(t.ranges, t.width[at]);
  return t;
}

Tracks packed_vectors(std::size_t keys) {
  Tracks t{kTranslation, kStep, 1, 1, {1}, {}, {5, 0, 4}, {}, {}, rows(keys, {0x33, 0x01})};
  for (const std::uint8_t width : t.width) add_range(t.ranges, width);
  return t;
}

/// A clip with a block of each kind, and one joint at rest in each property.
ClipFields valid() {
  ClipFields f;
  f.groups = {{{0.0f, 1.0f, 2.0f},
               {full(kTranslation, kLinear, {0, 2}, 3 * 3 * 2), full(kRotation, kSquad, {1}, 3 * 13),
                full(kWeight, kLinear, {1, 1}, 3 * 2)}},
              {{0.0f, 0.5f}, {packed_rotations(2), packed_vectors(2), full(kNumber, kStep, {0, 1}, 2 * 2)}}};
  f.translations = steps(3);
  f.rotations = {0, 0, 1, 0};
  f.scales = steps(12);
  return f;
}

TEST(clip_fields, that_are_all_right_make_a_clip) {
  const auto loaded = load_clips(valid().block());
  ASSERT_TRUE(loaded) << loaded.error().detail;
  ASSERT_EQ(loaded->size(), 1u);
  const Clip& clip = loaded->front();
  EXPECT_EQ(clip.counts().translations, 3u);
  EXPECT_EQ(clip.counts().rotations, 3u);
  EXPECT_EQ(clip.counts().weights, 2u);
  EXPECT_EQ(clip.counts().properties, 2u);
  EXPECT_EQ(clip.certificate()->bytes, 400u);
  EXPECT_EQ(clip.annotations().event_names, (std::vector<std::string>{"step", "step"}));
  EXPECT_EQ(clip.annotations().curves.at(0).keys_of<float>()[0].value, 3.0f);
  const Clip* const one = &clip;
  EXPECT_EQ(save_clips({&one, 1}), valid().block()) << "the form is the one that clips are saved in";
  test::PoseBuffer pose(4);
  std::vector<float> weights(3), numbers(2);
  EXPECT_EQ(
      run(SampleClipJob{.clip = &clip, .time_s = 0.0, .pose = pose.span(), .weights = weights, .properties = numbers}),
      ErrorCode::ok);
  EXPECT_EQ(pose.span().get(3).translation, glm::vec3(0.125f, 0.25f, 0.375f));  // rest value
  EXPECT_EQ(pose.span().get(1).translation,
            glm::vec3(0.125f + 19 * 0.0078125f, 0.125f, 0.125f + 9 * 0.0078125f));  // 0x3333: 10011 and 1001
  EXPECT_EQ(weights, (std::vector<float>{0.1f, 0.125f, 0.25f}));
}

struct Damage {
  const char* what;
  const char* detail;
  std::function<void(ClipFields&)> make;
};

Tracks& tracks(ClipFields& f, std::size_t group, std::size_t block) { return f.groups[group].blocks[block]; }
/// The upper half of a NaN, for `ranges`.
constexpr std::uint16_t kNoNumber = 0x7fc0;

const Damage kDamages[] = {
    {"duration, no number", "the duration is not a time",
     [](ClipFields& f) { f.duration_s = std::numeric_limits<double>::quiet_NaN(); }},
    {"duration, endless", "the duration is not a time",
     [](ClipFields& f) { f.duration_s = std::numeric_limits<double>::infinity(); }},
    {"duration, negative", "the duration is not a time", [](ClipFields& f) { f.duration_s = -0.5; }},
    {"certificate, neither", "the certificate is neither there nor missing", [](ClipFields& f) { f.certificate = 2; }},
    {"certificate, asked", "a length of the certificate is not finite",
     [](ClipFields& f) { f.lengths[0] = std::numeric_limits<double>::infinity(); }},
    {"certificate, worst time", "a length of the certificate is not finite",
     [](ClipFields& f) { f.lengths[3] = std::numeric_limits<double>::quiet_NaN(); }},
    {"event, late", "an event or a curve breaks its rules", [](ClipFields& f) { f.event_times_s[1] = 2.5; }},
    {"event, no number", "an event or a curve breaks its rules", [](ClipFields& f) { f.event_times_s[0] = kNan; }},
    {"curve, rule", "an event or a curve breaks its rules", [](ClipFields& f) { f.curve_blend = 3; }},
    {"curve, step", "an event or a curve breaks its rules", [](ClipFields& f) { f.curve_step = 9; }},
    {"curve, value", "an event or a curve breaks its rules", [](ClipFields& f) { f.curve_value = kNan; }},
    {"weights", "a base value is not finite", [](ClipFields& f) { f.weights[2] = kNan; }},
    {"properties", "a base value is not finite",
     [](ClipFields& f) { f.properties[0] = std::numeric_limits<float>::infinity(); }},
    {"joint count, most", "too many joints", [](ClipFields& f) { f.joint_count = kNone; }},
    {"joint count, of which bytes overflow", "too many joints",
     [](ClipFields& f) { f.joint_count = std::uint64_t{1} << 60; }},
    {"joint count, of no tracks", "the clip has far more joints than its tracks account for",
     [](ClipFields& f) { f.joint_count = 1'000'000; }},
    {"no key times", "key times are not finite, rising numbers", [](ClipFields& f) { f.groups[0].times_s.clear(); }},
    {"key times, no number", "key times are not finite, rising numbers",
     [](ClipFields& f) { f.groups[0].times_s[2] = kNan; }},
    {"key times, endless", "key times are not finite, rising numbers",
     [](ClipFields& f) { f.groups[0].times_s[2] = std::numeric_limits<float>::infinity(); }},
    {"key times, falling", "key times are not finite, rising numbers",
     [](ClipFields& f) { f.groups[0].times_s[1] = 2.5f; }},
    {"property", "a block of tracks is of no known kind", [](ClipFields& f) { tracks(f, 0, 0).property = 5; }},
    {"interpolation", "a block of tracks is of no known kind",
     [](ClipFields& f) { tracks(f, 0, 0).interpolation = 4; }},
    {"packing", "a block of tracks is of no known kind", [](ClipFields& f) { tracks(f, 1, 0).packed = 2; }},
    {"squad of vectors", "squad is for rotations", [](ClipFields& f) { tracks(f, 0, 0).interpolation = kSquad; }},
    {"no targets", "the targets of a block are not rising numbers of the clip",
     [](ClipFields& f) {
       tracks(f, 0, 2).target_count = 0;
       tracks(f, 0, 2).target_gaps.clear();
       tracks(f, 0, 2).rows.clear();
     }},
    {"joint, none such", "the targets of a block are not rising numbers of the clip",
     [](ClipFields& f) { tracks(f, 0, 0).target_gaps[1] = 4; }},
    {"joint, twice", "the targets of a block are not rising numbers of the clip",
     [](ClipFields& f) { tracks(f, 0, 0).target_gaps[1] = 0; }},
    {"weight, none such", "the targets of a block are not rising numbers of the clip",
     [](ClipFields& f) { tracks(f, 0, 2).target_gaps[0] = 2; }},
    {"weights, not side by side", "the targets of a block are not rising numbers of the clip",
     [](ClipFields& f) {
       tracks(f, 0, 2).target_gaps[0] = 0;
       tracks(f, 0, 2).target_gaps[1] = 2;
     }},
    {"number, none such", "the targets of a block are not rising numbers of the clip",
     [](ClipFields& f) { tracks(f, 1, 2).target_gaps[0] = 1; }},
    {"rows, a key too few", "a block does not have a row for each key",
     [](ClipFields& f) { tracks(f, 0, 0).rows.resize(2 * 3 * 2); }},
    {"rows, a number too many", "a block does not have a row for each key",
     [](ClipFields& f) { tracks(f, 0, 0).rows.push_back(0.0f); }},
    {"rows, a number too few", "a block does not have a row for each key",
     [](ClipFields& f) { tracks(f, 0, 1).rows.pop_back(); }},
    {"a key", "a key is not finite", [](ClipFields& f) { tracks(f, 0, 0).rows[17] = kNan; }},
    {"a packed curve", "only step and linear keys are packed",
     [](ClipFields& f) { tracks(f, 1, 0).interpolation = kSquad; }},
    {"widths, one too many", "the tables of a packed block are not of its size",
     [](ClipFields& f) { tracks(f, 1, 0).width.push_back(0); }},
    {"widths, one too few", "the tables of a packed block are not of its size",
     [](ClipFields& f) { tracks(f, 1, 1).width.pop_back(); }},
    {"left-out components, one too few", "the tables of a packed block are not of its size",
     [](ClipFields& f) { tracks(f, 1, 0).derived.pop_back(); }},
    {"left-out components of vectors", "the tables of a packed block are not of its size",
     [](ClipFields& f) { tracks(f, 1, 1).derived.push_back(0); }},
    {"left-out component, none such", "no such component", [](ClipFields& f) { tracks(f, 1, 0).derived[1] = 5; }},
    {"a width", "a packed number is too wide", [](ClipFields& f) { tracks(f, 1, 1).width[0] = 25; }},
    {"widths of a key", "a packed key is too wide",
     [](ClipFields& f) {
       tracks(f, 1, 1).width = {19, 19, 19};
     }},
    {"bits of a left-out component", "a component that is left out has bits",
     [](ClipFields& f) { tracks(f, 1, 0).width[6] = 1; }},
    {"a step that lanes cannot divide", "a step of packed keys is too small",
     [](ClipFields& f) { tracks(f, 1, 1).ranges[2] = 0x0080; }},
    {"a lowest value", "a range of packed keys is not finite",
     [](ClipFields& f) { tracks(f, 1, 1).ranges[0] = kNoNumber; }},
    {"a step", "a range of packed keys is not finite", [](ClipFields& f) { tracks(f, 1, 1).ranges[2] = kNoNumber; }},
    {"ranges, one too many", "the ranges of packed keys are not as many as their components",
     [](ClipFields& f) { tracks(f, 1, 1).ranges.push_back(0); }},
    {"ranges, one too few", "the ranges of packed keys are not as many as their components",
     [](ClipFields& f) { tracks(f, 1, 0).ranges.pop_back(); }},
    {"bits, a byte too few", "packed keys are not of their size",
     [](ClipFields& f) { tracks(f, 1, 0).bits.pop_back(); }},
    {"bits, a byte too many", "packed keys are not of their size",
     [](ClipFields& f) { tracks(f, 1, 1).bits.push_back(0); }},
    {"base pose, too small", "the base pose is not of the clip's size",
     [](ClipFields& f) { f.translations.pop_back(); }},
    {"base pose, rotations of three numbers", "the base pose is not of the clip's size",
     [](ClipFields& f) { f.rotations.resize(3); }},
    {"base pose, too large", "the base pose is not of the clip's size",
     [](ClipFields& f) { f.scales.push_back(1.0f); }},
    {"base pose", "a base value is not finite", [](ClipFields& f) { f.scales[5] = kNan; }},
};

TEST(clip_fields, each_wrong_number_is_refused_for_what_it_is) {
  for (const Damage& damage : kDamages) {
    ClipFields f = valid();
    damage.make(f);
    const auto loaded = load_clips(f.block());
    ASSERT_FALSE(loaded) << damage.what;
    EXPECT_EQ(loaded.error().rule, "clip-value") << damage.what;
    EXPECT_EQ(loaded.error().detail, damage.detail) << damage.what;
  }
}

TEST(clip_fields, a_block_of_more_lanes_than_bits_can_be_counted_for_is_refused) {
  for (const std::uint32_t lanes : {1024u, 1025u}) {
    ClipFields f = valid();
    f.joint_count = 2000;
    f.groups.erase(f.groups.begin());
    Tracks& t = tracks(f, 0, 1);
    t = {kScale,
         kStep,
         1,
         lanes,
         std::vector<std::uint8_t>(lanes, 1),
         {},
         std::vector<std::uint8_t>(3 * lanes, 0),
         {},
         std::vector<std::uint16_t>(6 * lanes, 0),
         {}};
    f.translations.clear();
    f.rotations.clear();
    f.scales.clear();
    const auto loaded = load_clips(f.block());
    EXPECT_EQ(loaded ? "" : loaded.error().detail,
              lanes == 1024 ? "" : "the tables of a packed block are not of its size");
  }
}

TEST(clip_fields, few_bytes_make_little_memory) {
  // Tracks of joint 0 and of a joint far away need JointPlaces for all joints between. This is refused before it
  // allocates.
  ClipFields far = valid();
  far.joint_count = 1u << 29;
  far.name = "";
  tracks(far, 0, 0).target_gaps = {0, 0x80, 0x80, 0x80, 0x80, 0x01};
  tracks(far, 0, 0).target_count = 2;
  const auto loaded = load_clips(far.block());
  ASSERT_FALSE(loaded);
  EXPECT_EQ(loaded.error().detail, "the clip has far more joints than its tracks account for");
  ClipFields without = far;
  without.groups.clear();
  without.translations.clear();
  without.rotations.clear();
  without.scales.clear();
  EXPECT_LT(loaded.error().offset, without.block().size() + 48) << "before the rows of the block are read";

  // The limit of memory counts all blocks together.
  for (const std::size_t blocks : {std::size_t{1}, std::size_t{24}}) {
    ClipFields many;
    many.joint_count = 200'000;
    many.groups.push_back({{0.0f}, {}});
    for (std::size_t i = 0; i < blocks; ++i)
      many.groups[0].blocks.push_back(full(kTranslation, kStep, {0, 0x80, 0x80, 0x0c}, 3 * 2));
    for (Tracks& t : many.groups[0].blocks) t.target_count = 2;
    EXPECT_EQ(load_clips(many.block()).has_value(), blocks == 1) << blocks;
  }
}

TEST(clip_fields, packed_rotations_that_take_no_bits_count_for_each_key) {
  for (const std::size_t blocks : {std::size_t{1}, std::size_t{200}}) {
    ClipFields still;
    still.groups.push_back({{}, {}});
    for (int k = 0; k < 200'000; ++k) still.groups[0].times_s.push_back(static_cast<float>(k));
    const std::vector<std::uint16_t> ranges(6, 0);
    const Tracks t = {kRotation, kLinear, 1, 1, {0}, {}, {0, 0, 0, 0}, {3}, ranges, {}};
    still.groups[0].blocks.assign(blocks, t);
    const auto loaded = load_clips(still.block());
    EXPECT_EQ(loaded ? "" : loaded.error().detail,
              blocks == 1 ? "" : "the clip has far more joints than its tracks account for");
  }
}

}  // namespace
}  // namespace sinew
