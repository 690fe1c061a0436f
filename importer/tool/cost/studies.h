// SPDX-License-Identifier: MIT
#pragma once
#include "importer/tool/cost/study.h"
#include "importer/tool/cost/subject.h"

namespace sinew::cost {

/// Each looks at one choice of the runtime on the subject: the errors are worked out at once, the times are for
/// measure() to find. A study that has nothing to say about the subject says why in Group::left_out. The subject must
/// outlive the study.
Study study_rotation(const Subject& subject);
Study study_storage(const Subject& subject);
Study study_influences(const Subject& subject);
Study study_skinning(const Subject& subject);
Study study_skinned_normals(const Subject& subject);
Study study_morphing(const Subject& subject);
Study study_arithmetic(const Subject& subject);

}  // namespace sinew::cost
