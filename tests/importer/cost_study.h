// SPDX-License-Identifier: MIT
#pragma once
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "importer/tool/cost/studies.h"

// Short names for the tests of `sinew cost`.

namespace sinew::test {

using cost::Effort;
using cost::Group;
using cost::Point;
using cost::Study;
using cost::Subject;
using testing::ElementsAre;
using testing::HasSubstr;

}  // namespace sinew::test
