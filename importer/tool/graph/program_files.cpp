// SPDX-License-Identifier: MIT
#include "importer/tool/graph/program_files.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <optional>
#include <utility>

#include "importer/graph/graph_files.h"
#include "importer/graph/json_path.h"
#include "importer/graph/program_text.h"
#include "importer/tool/clip_choice.h"
#include "importer/tool/messages.h"

namespace sinew::tool {
namespace {

/// Fills operations from their document. Keeps the first fault.
class ProgramCompiler {
 public:
  ProgramCompiler(const ProgramDocument& document, const Scene& scene) : document_(document), scene_(scene) {}

  std::optional<GraphTextFault> fault;

  PoseOp compile(const ProgramDocument::Operation& given, const JsonPath& here) {
    PoseOp op{.weight = given.weight, .mask = mask_of(given.mask, here), .kind = given.op};
    switch (given.op) {
      case PoseOpKind::sample:
      case PoseOpKind::sample_mirrored:
        op.index = clip_of(given.clip, here);
        op.time_s = given.time_s;
        break;
      case PoseOpKind::mean:
        op.index = index_of(given.operands, {&here, "operands"});
        op.time_s = given.threshold;
        break;
      case PoseOpKind::add:
      case PoseOpKind::add_to_rest: op.index = static_cast<std::uint16_t>(given.frame); break;
      case PoseOpKind::external: op.index = index_of(given.index, {&here, "index"}); break;
      case PoseOpKind::override_joints:
      case PoseOpKind::procedure:
        op.index = index_of(given.index, {&here, "index"});
        op.time_s = given.share;
        break;
      case PoseOpKind::inertialize:
      case PoseOpKind::dead_blend:
        op.index = index_of(given.steps, {&here, "steps"});
        op.time_s = given.progress;
        break;
      default: break;
    }
    return op;
  }

 private:
  void fail(const JsonPath& path, std::string sentence) {
    if (!fault) fault = GraphTextFault{path.text(), std::move(sentence)};
  }
  std::uint16_t index_of(std::int32_t number, const JsonPath& path) {
    if (number < 0 || number >= 0xFFFF) fail(path, "lies outside of [0, 65534]");
    return static_cast<std::uint16_t>(number);
  }
  std::uint16_t clip_of(const std::string& name, const JsonPath& here) {
    const auto chosen = choose_clips(scene_, name);
    if (chosen && chosen->size() == 1 && chosen->front() < kMostClipsOfPrograms)
      return static_cast<std::uint16_t>(chosen->front());
    fail({&here, "clip"}, "the model has no clip " + in_quotes(name) + "; " + list_of_clips(scene_));
    return 0;
  }
  std::uint8_t mask_of(const std::string& name, const JsonPath& here) {
    if (name.empty()) return PoseOp::kNoMask;
    const auto found = document_.masks.find(name);
    if (found == document_.masks.end()) fail({&here, "mask"}, "there is no mask " + in_quotes(name));
    const auto index = std::distance(document_.masks.begin(), found);
    if (index >= PoseOp::kNoMask) fail({&here, "mask"}, "only 255 masks can be named");
    return static_cast<std::uint8_t>(index);
  }

  const ProgramDocument& document_;
  const Scene& scene_;
};

/// in   joints  of the skeleton
std::vector<float> mask_below(const Skeleton& skeleton, const std::vector<std::string>& joints) {
  std::vector<float> mask(skeleton.joint_count(), 0.0f);
  for (const std::string& joint : joints) {
    const std::vector<float> below = sinew::mask_below(skeleton, *skeleton.find(joint));
    std::transform(mask.begin(), mask.end(), below.begin(), mask.begin(),
                   [](float a, float b) { return std::max(a, b); });
  }
  return mask;
}

}  // namespace

tl::expected<ProgramOfModel, std::string> load_program(const std::string& file, const Scene& scene) {
  const auto refused = [&](const GraphTextFault& fault) { return tl::unexpected(fault_text(file, fault)); };
  const auto text = read_json_file(file);
  if (!text) return tl::unexpected(text.error());
  auto document = read_program(*text);
  if (!document) return refused(document.error());
  if (const auto fault = find_mask_fault(document->masks, scene.skeleton)) return refused(*fault);

  ProgramOfModel loaded{std::move(*document), {}, {}};
  ProgramCompiler compiler(loaded.document, scene);
  const JsonPath root, operations(&root, "operations");
  for (std::size_t i = 0; i < loaded.document.operations.size(); ++i)
    loaded.program.push(compiler.compile(loaded.document.operations[i], {&operations, std::to_string(i)}));
  if (compiler.fault) return refused(*compiler.fault);
  if (!loaded.program.is_complete()) return refused({operations.text(), "has more than 255 operations"});
  constexpr std::size_t kAny = 0x10000;  // tables of the caller
  const PoseProgramFault fault = find_fault(loaded.program.ops(), {.clips = scene.clips.size(),
                                                                   .externals = kAny,
                                                                   .masks = loaded.document.masks.size(),
                                                                   .overrides = kAny,
                                                                   .procedures = kAny,
                                                                   .mirror = true,
                                                                   .slots = kMostPoseOps,
                                                                   .kept = kMostPoseOps});
  if (fault.code != ErrorCode::ok)
    return refused({fault.op < loaded.program.ops().size() ? JsonPath(&operations, std::to_string(fault.op)).text()
                                                           : operations.text(),
                    fault.rule});
  for (const auto& [name, joints] : loaded.document.masks) loaded.masks.push_back(mask_below(scene.skeleton, joints));
  return loaded;
}

}  // namespace sinew::tool
