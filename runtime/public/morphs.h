// SPDX-License-Identifier: MIT
#pragma once
/// Morph targets and the weights that drive them. A MorphSet displaces vertices by weights. A PoseCorrective adds to
/// such weights an amount that depends on joint rotations. solve_corrective fits it to sample poses; plans and the job
/// CorrectPoseJob (pose_jobs.h) evaluate it.
///
///     if (auto bulge = sinew::solve_corrective(std::move(samples))) scene.correctives.push_back(std::move(*bulge));
#include "runtime/model/morph_set.h"
#include "runtime/model/pose_corrective.h"
#include "runtime/model/pose_samples.h"
