// SPDX-License-Identifier: BSD-3-Clause
// The cheapest one-to-one assignment.
#pragma once

#include <Eigen/Core>
#include <limits>
#include <vector>

namespace armature {

// The price of a row and a column that must not be paired.
inline constexpr double kForbidden = std::numeric_limits<double>::infinity();

// `costs(i, j)`: price of pairing row i with column j, at least 0, or kForbidden. Of all ways to pair rows
// and columns one-to-one those with the most pairs, of them one with the least sum. Returns each row's
// column, -1 where it has none. Throws std::invalid_argument for a negative price or one that is not a
// number.
std::vector<int> Assign(const Eigen::MatrixXd& costs);

}  // namespace armature
