// SPDX-License-Identifier: BSD-3-Clause
// Tables of boxes that stand for CAD models: a line a box.
#pragma once

#include <Eigen/Core>
#include <array>
#include <filesystem>
#include <string>

#include "base/text.h"

namespace armature {

struct TableBox {
  std::array<std::string, 2> ids;
  Eigen::Vector3d centre{0, 0, 0};
  Eigen::Matrix3d half_axes =
      Eigen::Matrix3d::Zero();  // columns: from the centre to the middles of three faces
};

// "id id", centre 3, half size 3, axes 9 (row-major, a row an axis). Throws InputError naming file and line.
TableBox ParseTableBox(const std::filesystem::path& file, const TextLine& line);

}  // namespace armature
