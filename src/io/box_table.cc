// SPDX-License-Identifier: BSD-3-Clause
#include "io/box_table.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/errors.h"
#include "base/text.h"

namespace armature {

TableBox ParseTableBox(const std::filesystem::path& file, const TextLine& line) {
  const std::string where = fmt::format("{}:{}", file.string(), line.number);
  const std::vector<std::string> words = SplitWords(line.text);
  TableBox box;
  Eigen::Matrix<double, 15, 1> v;
  if (words.size() != box.ids.size() + static_cast<size_t>(v.size()))
    throw InputError(where + ": a box is two ids and 15 numbers: centre, half size, axes");
  std::copy_n(words.begin(), box.ids.size(), box.ids.begin());
  for (Eigen::Index i = 0; i < v.size(); ++i)
    v[i] = ParseNumber(words[box.ids.size() + static_cast<size_t>(i)], where);
  box.centre = v.head<3>();
  box.half_axes = v.tail<9>().reshaped(3, 3) * v.segment<3>(3).asDiagonal();
  return box;
}

}  // namespace armature
