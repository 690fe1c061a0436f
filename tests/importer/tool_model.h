// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace sinew::test {

/// A glTF file, made in memory, with every kind of content that a pose holds:
/// - node 0 "strip": a skinned mesh of four vertices, normals included, skin of the joints 1 and 2;
/// - node 1 "root" -> node 2 "tip", one metre above it; clip 0 "bend" turns the tip about z by 90 degrees within 1 s;
/// - node 3 "face", two metres to the right and scaled by (1, 2, 1): a triangle without normals, two morph targets,
///   mesh weights (0.25, 0). Clip 1 "talk" moves the weights from (0, 0) to (1, 0.5) within 2 s.
std::string tool_model();

/// The model written into a fresh folder that goes away with this object.
class ToolModelFile {
 public:
  ToolModelFile();
  ~ToolModelFile();
  ToolModelFile(const ToolModelFile&) = delete;
  ToolModelFile& operator=(const ToolModelFile&) = delete;

  std::string path() const { return (folder_ / "model.gltf").string(); }
  std::string beside(const std::string& name) const { return (folder_ / name).string(); }

 private:
  std::filesystem::path folder_;
};

/// The outcome of a command line: exit status and output.
struct CommandOutcome {
  int status = -1;
  std::string out, err;
};

/// Runs `sinew ARGUMENTS...` inside this process.
CommandOutcome run_tool(const std::vector<std::string>& arguments);

}  // namespace sinew::test
