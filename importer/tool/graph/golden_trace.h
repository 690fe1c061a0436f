// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "importer/graph/trace_document.h"
#include "importer/tool/graph/graph_trace.h"
#include "runtime/model/scene.h"

namespace sinew::tool {

/// True if the file begins as a golden trace does.
bool is_golden_trace(const std::string& file);

/// The lines of a trace's frames, which the next function compares.
/// out  for example "0.5 s | body:walk 0.25 for 0.1 s | sample Walk at 0.1 x 0.25, ... | body enters walk at 0.4"
std::vector<std::string> trace_lines(const GraphOfModel& model, const Json& trace);

/// Differences of two frames' lines, in words; empty if they agree. Numbers agree within 2e-5 of the larger of their
/// size and 1.
std::string compare_trace_lines(const std::string& before, const std::string& now);

/// The text of a golden trace: JSON with a line for each frame, which reads well in a review.
std::string golden_trace_text(const TraceDocument& trace);

/// A golden trace, and what its graph does today.
struct TraceComparison {
  TraceDocument today;
  std::uint64_t compared = 0;            ///< frames
  std::vector<std::string> differences;  ///< a sentence for each frame that differs
};

/// Plays the graph of a golden trace again.
/// err  a sentence with file and place: the trace or its graph cannot be read, or does not fit the model
tl::expected<TraceComparison, std::string> compare_with_golden(const std::string& golden, const Scene& scene);

}  // namespace sinew::tool
