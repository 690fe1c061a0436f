// SPDX-License-Identifier: MIT
#include "importer/graph/compile_masks.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "importer/graph/json_path.h"

namespace sinew {
namespace {

constexpr std::size_t kMostDepth = 16, kMostEntries = kNoGraphIndex - 1;

std::uint32_t add_text(GraphTables& t, std::string_view text) {
  const auto offset = static_cast<std::uint32_t>(t.names.size());
  t.names.append(text).push_back('\0');
  return offset;
}

class MaskCompiler {
 public:
  MaskCompiler(const GraphDocument& document, GraphTables& tables) : masks_(document.masks), t_(tables) {}

  std::optional<GraphTextFault> fault;

  void compile() {
    for (const auto& [name, entries] : masks_) {
      const std::size_t first = t_.mask_joints.size();
      t_.masks.push_back({add_text(t_, name), static_cast<GraphIndex>(first), 0});
      add(name, entries, 1.0f);
      if (fault) return;
      t_.masks.back().joint_count = static_cast<GraphIndex>(t_.mask_joints.size() - first);
    }
  }

 private:
  using Entries = std::vector<GraphDocument::MaskJoint>;

  void add(const std::string& name, const Entries& entries, float share) {
    within_.push_back(name);
    const JsonPath root, all(&root, "masks"), here(&all, name);
    for (std::size_t i = 0; i < entries.size() && !fault; ++i) add(entries[i], share, {&here, std::to_string(i)});
    within_.pop_back();
  }

  void add(const GraphDocument::MaskJoint& entry, float share, const JsonPath& here) {
    // The limit holds for entries that name masks, too. Empty masks within masks would else take forever.
    if (++entries_ > kMostEntries) return fail(here, "there are more than 65534 entries of masks");
    if (entry.joint.empty() == entry.mask.empty()) return fail(here, "names either a joint or a mask");
    if (entry.mask.empty()) {
      t_.mask_joints.push_back({name_of(entry.joint), share * entry.weight, entry.below});
      return;
    }
    const auto found = masks_.find(entry.mask);
    if (found == masks_.end()) return fail({&here, "mask"}, "there is no mask \"" + entry.mask + "\"");
    if (!entry.below) return fail({&here, "below"}, "is not used by a mask within a mask");
    if (!(entry.weight >= 0.0f && entry.weight <= 1.0f)) return fail({&here, "weight"}, "lies in [0, 1]");
    if (std::find(within_.begin(), within_.end(), entry.mask) != within_.end())
      return fail({&here, "mask"}, "the mask lies within itself");
    if (within_.size() >= kMostDepth) return fail({&here, "mask"}, "it lies more than 16 deep");
    add(found->first, found->second, share * entry.weight);
  }

  /// Masks that lie within many others repeat no names.
  std::uint32_t name_of(const std::string& joint) {
    const auto [found, is_new] = names_.try_emplace(joint, 0);
    if (is_new) found->second = add_text(t_, joint);
    return found->second;
  }

  void fail(const JsonPath& path, std::string sentence) { fault = {path.text(), std::move(sentence)}; }

  const std::map<std::string, Entries>& masks_;
  GraphTables& t_;
  std::vector<std::string_view> within_;  // names of the masks around the current entry
  std::map<std::string_view, std::uint32_t> names_;
  std::size_t entries_ = 0;
};

}  // namespace

std::optional<GraphTextFault> compile_masks(const GraphDocument& document, GraphTables& tables) {
  MaskCompiler compiler(document, tables);
  compiler.compile();
  return compiler.fault;
}

}  // namespace sinew
