// SPDX-License-Identifier: MIT
#include "runtime/math/conventions.h"
int main() {}
