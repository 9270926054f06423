// SPDX-License-Identifier: BSD-3-Clause
#include "io/box_table.h"

#include <fmt/format.h>

#include <sstream>

#include "base/errors.h"

namespace armature {

TableBox ParseTableBox(const std::filesystem::path& file, const TextLine& line) {
  std::istringstream stream(line.text);
  TableBox box;
  Eigen::Matrix<double, 15, 1> v;
  stream >> box.ids[0] >> box.ids[1];
  for (double& value : v) stream >> value;
  if (!stream || !(stream >> std::ws).eof()) {
    throw InputError(fmt::format("{}:{}: a box is two ids and 15 numbers: centre, half size, axes",
                                 file.string(), line.number));
  }
  box.centre = v.head<3>();
  box.half_axes = v.tail<9>().reshaped(3, 3) * v.segment<3>(3).asDiagonal();
  return box;
}

}  // namespace armature
