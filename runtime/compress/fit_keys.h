// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/base/api.h"
#include "runtime/clip/clip.h"
#include "runtime/compress/virtual_vertices.h"

namespace sinew {

/// The keys of an animation that a file needs within an error budget. No virtual vertex, in model space, is farther
/// than `budget_m` from its place in `truth`, at keys and between them. Every kept key is a key of the file, with its
/// time, value and tangents. A track that hardly moves keeps one key, or is left out if the rest transform or the rest
/// weights may stand for it. If the file format rounds keys, the error includes that rounding (`stored`). Use
/// compile_clip_within() for clips of the runtime, which rounds in its own way.
///
/// The search goes from the roots of the skeleton to its tips. Each joint may use a share of the budget for itself and
/// all joints below it, and a tip may use everything that is left. Later rounds give larger shares to joints that need
/// many keys. The form with the fewest bytes (FileBytes) wins. Then tracks that share key times lose keys together, as
/// long as the whole pose stays within the budget. Morph weights have a share of the budget by how far they displace
/// vertices. Properties keep every key, as do squad tracks.
/// in   truth     of the scene
///      stored    the same tracks and times, with the values that a reader of the file will see
///      budget_m  in the file's units, >= 0; 0 keeps everything
/// out  some keys of `truth`, and an empty track for each that is left out; all keys where no smaller form is within
///      the budget
/// cost O(keys x longest step); allocates some hundred bytes for each joint and key, at most about 100 MB
SINEW_API Animation fit_keys(const Scene& scene, const Animation& truth, const Animation& stored,
                             const VirtualVertices& vertices, double budget_m);

/// Bytes of the keys of an animation in a glTF file. Equal key times are stored once.
struct FileBytes {
  static constexpr std::uint64_t kTimes = 130;  ///< the JSON that describes one list of key times
  static constexpr std::uint64_t kValues = 90;  ///< the JSON that describes one list of values
};
SINEW_API std::uint64_t bytes_in_file(const Animation& animation);

/// Measures the keys of a file as a reader plays them: in double, by the equations of glTF, at times_to_check(truth).
/// in   written  the keys of the file;   truth  all original keys;   asked_m  the budget, stored in the certificate
/// out  a certificate. Its bytes are those of bytes_in_file(). Keys that equal those of `truth` have an error of 0.
/// cost O(times x J), allocates
SINEW_API ClipCertificate measure_keys(const Scene& scene, const Animation& written, const Animation& truth,
                                       const VirtualVertices& vertices, double asked_m);

}  // namespace sinew
