// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <span>
#include <string>

#include "runtime/clip/clip.h"

namespace sinew::tool {

/// A clip of a file or of the runtime, with its measured errors.
struct CertifiedClip {
  std::size_t number = 0;  ///< shown in front of the name
  std::string name;
  double duration_s = 0.0;
  ClipCertificate certificate;
};

/// True if a clip is within its budget. A clip with a budget of 0 is within it if it has every key. The measured error
/// of a compiled clip is then only the rounding of float arithmetic.
bool keeps_promise(const ClipCertificate& certificate);

/// A table of certificates, one row per clip: budget, measured error and its place, keys, bytes. Nothing in it depends
/// on the machine, so texts of two runs can be compared. An infinite budget is shown as none.
/// in    joint_names   of the skeleton; may be empty, then joints are shown as numbers
std::string certified_clips_table(std::span<const CertifiedClip> clips, std::span<const std::string> joint_names);

/// Same, for compiled clips. Clips without a certificate are left out.
std::string certificate_table(std::span<const Clip> clips, std::span<const std::string> joint_names);

}  // namespace sinew::tool
