// SPDX-License-Identifier: MIT
#pragma once
#include "importer/geometry_cache/geometry_take.h"
#include "importer/tool/cost/study.h"
#include "importer/tool/cost/subject.h"

namespace sinew::cost {

/// Each function studies one choice of the runtime on the subject. It computes the errors; measure() finds the times. A
/// study that does not apply to the subject says why in Group::left_out. The subject must outlive the study.
Study study_rotation(const Subject& subject);
Study study_storage(const Subject& subject);
Study study_influences(const Subject& subject);
Study study_skinning(const Subject& subject);
Study study_skinned_normals(const Subject& subject);
Study study_morphing(const Subject& subject);
Study study_arithmetic(const Subject& subject);
Study study_retargeting(const Subject& subject);
Study study_geometry(const Subject& subject);
Study study_inverse_kinematics(const Subject& subject);
Study study_springs(const Subject& subject);

/// Studies the storage of the positions of a take, over as many frames as `effort` has key intervals.
/// in   budget_m  of the cache that other formats are compared with
Study study_geometry(GeometryTake take, double budget_m, const Effort& effort);

}  // namespace sinew::cost
