// SPDX-License-Identifier: BSD-3-Clause
#include "category/held_out.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "base/errors.h"
#include "category/learn.h"

namespace armature {
namespace {

double Angle(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

}  // namespace

ReconstructionError Reconstruct(const CategoryModel& model, const std::vector<Wireframe>& wireframes,
                                int modes) {
  ReconstructionError error;
  for (const Wireframe& truth : wireframes) {
    const Eigen::VectorXd coefficients = CoefficientsFromWireframe(model, truth).head(modes);
    const Wireframe estimate = WireframeFromCoefficients(model, coefficients);
    const double m = truth.edges();
    error.midpoint += (truth.midpoints - estimate.midpoints).colwise().norm().sum() / m;
    for (int i = 0; i < truth.edges(); ++i) {
      error.direction += Angle(truth.directions.col(i), estimate.directions.col(i)) / m;
    }
  }
  error.models = static_cast<int>(wireframes.size());
  const double count = std::max(1, error.models);
  error.midpoint /= count;
  error.direction /= count;
  return error;
}

std::vector<HeldOutRow> HeldOutErrors(const TrainingSpec& spec, const std::vector<Wireframe>& wireframes,
                                      int every, const std::vector<int>& modes) {
  if (every < 2)
    throw InputError(fmt::format("--held-out {}: must be at least 2, to keep models to learn from", every));
  std::vector<Wireframe> kept, left_out;
  for (size_t i = 0; i < wireframes.size(); ++i) {
    const bool held_out = (i + 1) % static_cast<size_t>(every) == 0;
    (held_out ? left_out : kept).push_back(wireframes[i]);
  }
  TrainingSpec wide = spec;
  wide.modes = modes.empty() ? 0 : *std::max_element(modes.begin(), modes.end());
  const CategoryModel model = LearnCategory(wide, kept, "");
  std::vector<HeldOutRow> rows;
  for (const int count : modes) {
    const int used = std::min(count, model.modes());
    if (!rows.empty() && rows.back().modes == used) break;  // the models span no more
    rows.push_back({used, static_cast<int>(kept.size()), Reconstruct(model, left_out, used)});
  }
  return rows;
}

}  // namespace armature
