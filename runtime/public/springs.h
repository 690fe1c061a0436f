// SPDX-License-Identifier: MIT
#pragma once
/// Springs of hair, cloth and soft parts: setup, definition, job, and a step of pose programs.
#include "runtime/procedures/springs/spring_setup.h"
#include "runtime/procedures/springs/springs.h"
#include "runtime/procedures/springs/springs_job.h"
#include "runtime/procedures/springs/springs_procedure.h"
