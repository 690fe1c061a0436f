// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "importer/graph/program_document.h"
#include "runtime/model/scene.h"
#include "runtime/pose_program/pose_program.h"

namespace sinew::tool {

/// A program file, checked against the model whose clips it plays.
struct ProgramOfModel {
  ProgramDocument document;
  PoseProgram program;
  std::vector<std::vector<float>> masks;  ///< [masks, sorted by name][joints]
};

/// Reads a program file.
/// err  "FILE: POINTER: sentence": a fault of the text or the program, a clip or joint that the model lacks
tl::expected<ProgramOfModel, std::string> load_program(const std::string& file, const Scene& scene);

}  // namespace sinew::tool
