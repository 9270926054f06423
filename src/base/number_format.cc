// SPDX-License-Identifier: BSD-3-Clause
#include "base/number_format.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace armature {

std::string Fixed(double value, int digits) {
  if (!std::isfinite(value)) return "";
  std::string text = fmt::format("{:.{}f}", value, digits);
  if (text[0] == '-' && text.find_first_not_of("-0.") == std::string::npos) text.erase(0, 1);
  return text;
}

Eigen::Quaterniond CanonicalQuaternion(const Eigen::Matrix3d& rotation) {
  Eigen::Quaterniond q(rotation);
  q.normalize();
  for (const double part : {q.w(), q.x(), q.y(), q.z()}) {
    if (part == 0) continue;
    if (part < 0) q.coeffs() = -q.coeffs();
    break;
  }
  return q;
}

}  // namespace armature
