// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/box.h"

#include <algorithm>

namespace armature {

Box Intersection(const Box& a, const Box& b) {
  const double left = std::max(a.left(), b.left());
  const double top = std::max(a.top(), b.top());
  return {left, top, std::max(0.0, std::min(a.right(), b.right()) - left),
          std::max(0.0, std::min(a.bottom(), b.bottom()) - top)};
}

double IntersectionOverUnion(const Box& a, const Box& b) {
  const double shared = Intersection(a, b).area();
  const double all = a.area() + b.area() - shared;
  return all > 0 ? shared / all : 0;
}

}  // namespace armature
