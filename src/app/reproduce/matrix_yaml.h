// SPDX-License-Identifier: BSD-3-Clause
// The effective matrix, as text.
#pragma once

#include <filesystem>
#include <string>

#include "app/reproduce/matrix.h"

namespace armature {

// As ReadMatrix would read it again.
std::string MatrixYaml(const Matrix& matrix);

}  // namespace armature
