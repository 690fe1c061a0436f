// SPDX-License-Identifier: MIT
#include "importer/tool/graph/program_rows.h"

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <optional>
#include <span>

#include <fmt/core.h>

#include "importer/tool/messages.h"
#include "importer/tool/text_table.h"
#include "runtime/model/mirror_scene.h"
#include "runtime/pose/pose_memory.h"
#include "runtime/pose_program/op_shares.h"
#include "runtime/pose_program/run_pose_program.h"

namespace sinew::tool {
namespace {

/// The operation that takes each pose, and the pose's place among its operands.
struct Taker {
  std::size_t op = kMostPoseOps;  ///< kMostPoseOps: none, it is the final pose
  std::size_t place = 0;
  std::size_t topmost = 0;  ///< the topmost operand
};

std::vector<Taker> find_takers(PoseProgramSpan program) {
  std::vector<Taker> takers(program.size());
  std::vector<std::size_t> stack;
  for (std::size_t i = 0; i < program.size(); ++i) {
    const std::size_t count = operands_of(program[i]), first = stack.size() - count;
    for (std::size_t k = 0; k < count; ++k) takers[stack[first + k]] = {i, k, stack.back()};
    stack.resize(first);
    stack.push_back(i);
  }
  return takers;
}

bool is_overlay(PoseOpKind kind) { return kind == PoseOpKind::overlay || kind == PoseOpKind::overlay_model; }

/// True if the operation that takes a pose weighs it.
bool weighs(PoseOpKind kind, std::size_t place) {
  return kind == PoseOpKind::mean ||
         (place == 1 && (is_overlay(kind) || kind == PoseOpKind::add_to_rest || kind == PoseOpKind::add));
}

bool has_share_0(const PoseOp& op) {
  return (op.kind == PoseOpKind::override_joints || op.kind == PoseOpKind::procedure) && op.time_s == 0.0;
}

/// Why the operation that takes the pose does not use it.
std::optional<std::string> why_unused(PoseProgramSpan program, std::size_t i, const Taker& taker) {
  const PoseOp& op = program[i];
  if (taker.op == kMostPoseOps) return std::nullopt;
  const PoseOp& by = program[taker.op];
  if (weighs(by.kind, taker.place) && op.weight == 0.0f) return "its weight is 0";
  const PoseOp& upper = program[taker.topmost];
  if (is_overlay(by.kind) && taker.place == 0 && upper.weight >= 1.0f && upper.mask == PoseOp::kNoMask)
    return fmt::format("operation {} covers it in full", taker.topmost);
  return std::nullopt;
}

std::string words_for(const PoseOp& op, const Scene& scene, const ProgramDocument& document) {
  std::string words = name_of(op.kind);
  switch (op.kind) {
    case PoseOpKind::sample:
    case PoseOpKind::sample_mirrored:
      words += fmt::format(" {} at {:g} s", in_quotes(scene.animations[op.index].name), op.time_s);
      break;
    case PoseOpKind::mean: words += fmt::format(" of {}", op.index); break;
    case PoseOpKind::external: words += fmt::format(" {}", op.index); break;
    case PoseOpKind::override_joints:
    case PoseOpKind::procedure: words += fmt::format(" {} by {:g}", op.index, op.time_s); break;
    case PoseOpKind::inertialize:
    case PoseOpKind::dead_blend: words += fmt::format(" at {:g}", op.time_s); break;
    default: break;
  }
  if (op.weight != 1.0f) words += fmt::format(", weight {:g}", op.weight);
  if (op.mask != PoseOp::kNoMask) {
    const auto mask = std::next(document.masks.begin(), op.mask);
    words += ", mask " + in_quotes(mask->first);
  }
  return words;
}

/// A scene and memory to run a program in.
class ProgramRun {
 public:
  ProgramRun(const Scene& scene, std::span<const ClipTracks> tracks, const ProgramOfModel& loaded)
      : program_(loaded.program.ops()),
        room_(room_of(program_)),
        rest_(scene.skeleton.joint_count()),
        pose_(scene.skeleton.joint_count()),
        rest_weights_(rest_weights_of(scene)),
        weights_(rest_weights_.size()),
        properties_(scene.properties.rest.size()),
        masks_(loaded.masks.begin(), loaded.masks.end()) {
    for (std::size_t j = 0; j < scene.skeleton.joint_count(); ++j) rest_.span().set(j, scene.skeleton.rest[j]);
    assets_ = {.skeleton = &scene.skeleton,
               .clips = scene.clips,
               .rest = rest_.span(),
               .rest_weights = rest_weights_,
               .rest_properties = scene.properties.rest,
               .masks = masks_,
               .clip_tracks = tracks};
    const bool mirrors = std::any_of(program_.begin(), program_.end(), [](const PoseOp& op) {
      return op.kind == PoseOpKind::sample_mirrored || op.kind == PoseOpKind::rest_mirrored;
    });
    if (mirrors) {
      map_ = make_mirror_map(scene);
      mirror_ = make_mirror_tables(map_.joints);
      assets_.mirror = &mirror_;
      assets_.mirrored_weight_source = map_.weight_source;
    }
    externals_.assign(room_.externals, {rest_.span(), {}, {}, 1});
    overrides_.resize(room_.overrides);
    procedures_.assign(room_.procedures, {[](void*, const ProcedurePose&) {}, nullptr, 1});
    memory_.resize(pose_program_bytes(assets_, room_) / sizeof(Line));
  }

  /// Runs one operation after those before it.
  /// out  its work
  PoseProgramWork run_operation(std::size_t op) {
    PoseProgramWork work;
    const PoseProgramJob job{.program = program_,
                             .assets = &assets_,
                             .inputs = {.externals = externals_, .overrides = overrides_, .procedures = procedures_},
                             .memory = std::as_writable_bytes(std::span(memory_)),
                             .pose = pose_.span(),
                             .weights = weights_,
                             .properties = properties_,
                             .work = &work,
                             .first = op,
                             .end = op + 1};
    run_unchecked(job);
    return work;
  }

 private:
  struct alignas(64) Line {
    std::byte bytes[64];
  };

  PoseProgramSpan program_;
  PoseProgramRoom room_;
  PoseMemory rest_, pose_;
  std::vector<float> rest_weights_, weights_, properties_;
  std::vector<std::span<const float>> masks_;
  PoseProgramAssets assets_;
  MirrorMap map_;
  MirrorTables mirror_;
  std::vector<ExternalPose> externals_;
  std::vector<JointOverrides> overrides_;
  std::vector<PoseProcedure> procedures_;
  std::vector<Line> memory_;
};

std::uint64_t count_of(const PoseProgramWork& work) {
  return work.tracks_sampled + work.properties_sampled + work.poses_copied + work.poses_blended + work.poses_overlaid +
         work.poses_added + work.joints_overridden + work.procedures_run + work.poses_in_transition;
}

/// Median time of each operation, in microseconds.
void measure_rows(ProgramRun& run, std::vector<ProgramRow>& rows) {
  constexpr std::size_t kRuns = 101;
  std::vector<std::vector<double>> times(rows.size());
  for (std::size_t r = 0; r < kRuns; ++r)
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const auto start = std::chrono::steady_clock::now();
      run.run_operation(i);
      times[i].push_back(std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start).count());
    }
  for (std::size_t i = 0; i < rows.size(); ++i) {
    std::nth_element(times[i].begin(), times[i].begin() + kRuns / 2, times[i].end());
    rows[i].microseconds = times[i][kRuns / 2];
  }
}

}  // namespace

void add_program(const ProgramOfModel& loaded, const Scene& scene, Needs& needs) {
  const PoseProgramSpan ops = loaded.program.ops();
  needs.in.masks = loaded.masks;
  needs.in.program = room_of(ops);
  const bool mirrors = std::any_of(ops.begin(), ops.end(), [](const PoseOp& op) {
    return op.kind == PoseOpKind::sample_mirrored || op.kind == PoseOpKind::rest_mirrored;
  });
  if (mirrors) needs.in.mirror = std::make_shared<const MirrorMap>(make_mirror_map(scene));
}

std::vector<ProgramRow> program_rows(const Plan& plan, const ProgramOfModel& loaded, bool measure) {
  const Scene& scene = plan.scene();
  const PoseProgramSpan program = loaded.program.ops();
  const std::vector<Taker> takers = find_takers(program);
  std::vector<float> shares(program.size());
  find_op_shares(program, shares);
  ProgramRun run(scene, plan.clip_tracks(), loaded);
  std::vector<ProgramRow> rows(program.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i].operation = words_for(program[i], scene, loaded.document);
    rows[i].share = shares[i];
    rows[i].count = count_of(run.run_operation(i));
  }
  std::vector<bool> used(rows.size());  // some operation, or the frame, uses the pose
  for (std::size_t i = rows.size(); i-- > 0;) {
    const Taker& taker = takers[i];
    const bool is_last = taker.op == kMostPoseOps;
    std::optional<std::string> why = why_unused(program, i, taker);
    if (!why && !is_last && !used[taker.op]) why = fmt::format("operation {} is not needed", taker.op);
    used[i] = !why;
    if (!why && has_share_0(program[i])) why = "its share is 0";
    rows[i].needed = !why;
    if (why)
      rows[i].reason = *why;
    else if (is_last)
      rows[i].reason = "the pose of the frame";
    else
      rows[i].reason = fmt::format("for operation {} ({})", taker.op, name_of(program[taker.op].kind));
  }
  if (measure) measure_rows(run, rows);
  return rows;
}

Json program_json(const std::vector<ProgramRow>& rows, bool measured) {
  Json list = Json::array();
  for (const ProgramRow& row : rows) {
    Json one = {{"operation", row.operation},
                {"needed", row.needed},
                {"reason", row.reason},
                {"share", static_cast<double>(row.share)},
                {"count", row.count}};
    if (measured) one["microseconds"] = row.microseconds;
    list.push_back(one);
  }
  return list;
}

std::string program_text(const std::vector<ProgramRow>& rows, bool measured) {
  TextTable table({"", "operation", "", "share", "count", measured ? "us" : "", "reason"});
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const ProgramRow& row = rows[i];
    table.add({std::to_string(i), row.operation, row.needed ? "runs" : "leave out", fmt::format("{:.3f}", row.share),
               std::to_string(row.count), measured ? fmt::format("{:.2f}", row.microseconds) : "", row.reason});
  }
  return "operations of the program:\n" + table.text();
}

}  // namespace sinew::tool
