// SPDX-License-Identifier: BSD-3-Clause
#include "association/hypothesis_cost.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "geometry/rotation.h"
#include "geometry/viewpoint.h"

namespace armature {
namespace {

// Tuned on office_dev and redkitchen_a, against the azimuth and depth of single views.
constexpr double kCoverageWeight = 12;  // of the share of the visible length that no segment explains
constexpr double kBoxLossScale = 3;     // standard deviations
constexpr double kShapeWeight = 0.15;   // of the squared coefficients
constexpr double kFloorWeight = 0.5;    // of the squared, robust floor residual
constexpr double kMemoryWeight = 0.3;   // of the squared, robust distance from what is remembered
constexpr double kMemoryLossScale = 4;  // standard deviations
constexpr double kYawMemoryCap = 6;     // the remembered viewpoint priors cost at most this

double GemanMcClure(double r, double scale) { return r * r / (1 + r * r / (scale * scale)); }

double BoxCost(const ObjectView& view, const Eigen::Matrix3d& R_camera_object, const BoxSides& sides,
               const ProjectedWireframe& projected, const BoxOptions& box_options) {
  const Box& box = view.detection.box;
  const auto [sigma_x, sigma_y] = SideSigmas(box, box_options);
  const std::array<ExtremePoint, 4> extremes = Extremes(projected);
  const Eigen::Vector2d reach = ImagePadding(view.model->spec, R_camera_object);
  const std::array<double, 4> at = {box.left(), box.top(), box.right(), box.bottom()};
  double cost = 0;
  for (size_t side = 0; side < 4; ++side) {
    const double sigma = side % 2 == 0 ? sigma_x : sigma_y;
    // Positive where the projection falls short of the side.
    const double padding =
        reach(static_cast<Eigen::Index>(side % 2)) * view.camera->fx * extremes[side].inverse_z;
    const double short_by = ((side < 2 ? 1 : -1) * (extremes[side].pixel - at[side]) - padding) / sigma;
    if (sides[side] == BoxSide::kSeen || short_by > 0) cost += GemanMcClure(short_by, kBoxLossScale);
  }
  return cost;
}

// Of taking sides of the box to be hidden or not, where the image's border does not decide. A box whose side
// is hidden may end anywhere along the object, one that is seen only where the object ends: by that ratio of
// densities a hidden side is less likely. Without it whatever is too near would fit every box.
double HiddenCost(const ObjectView& view, const BoxSides& sides, const BoxOptions& box_options) {
  const Box& box = view.detection.box;
  const auto [sigma_x, sigma_y] = SideSigmas(box, box_options);
  double cost = 0;
  for (size_t side = 0; side < 4; ++side) {
    const double p = view.hidden_probability[side];
    if (view.sides[side] == BoxSide::kOpen || p <= 0) continue;
    const double sigmas = side % 2 == 0 ? box.width / sigma_x : box.height / sigma_y;
    if (sides[side] == BoxSide::kOpen) {
      cost -= std::log(p) - std::max(0.0, std::log(sigmas / std::sqrt(2 * M_PI)));
    } else {
      cost -= std::log(1 - p);
    }
  }
  return cost;
}

double AzimuthCost(const ObjectView& view, const Eigen::Isometry3d& T_camera_object,
                   const CostOptions& options) {
  if (!view.detection.azimuth) return 0;
  const Viewpoint viewpoint = ViewpointFromRotation(T_camera_object.linear(), T_camera_object.translation());
  const double off =
      AzimuthDifference(viewpoint.azimuth, *view.detection.azimuth, view.model->spec.symmetry_order) /
      (options.azimuth_sigma_deg * kDegree);
  return -std::log((1 - options.azimuth_outliers) * std::exp(-0.5 * off * off) +
                   options.azimuth_outliers * 0.1);
}

double TrackPriorCost(const ObjectView& view, const PoseAndShape& at, const CostOptions& options) {
  const TrackPrior& prior = *view.track_prior;
  const Eigen::Matrix3d R = at.T_camera_object.linear();
  const TrackPriorVector difference = prior.Difference(R, at.T_camera_object.translation(), at.coefficients);
  const TrackPriorVector push = prior.information * difference;
  const double sigmas = std::sqrt(difference.dot(push));
  const double yaw = std::atan2(R.col(2).dot(prior.yaw_quarter), R.col(2).dot(prior.yaw_zero));
  return kMemoryWeight * GemanMcClure(sigmas, kMemoryLossScale) +
         std::min(kYawMemoryCap, options.azimuth_weight * prior.belief.At(yaw));
}

double ShapeCost(const PoseAndShape& at) { return kShapeWeight * at.coefficients.squaredNorm(); }

double FloorCost(const ObjectView& view, const Eigen::Isometry3d& T_camera_object,
                 const Wireframe& wireframe) {
  if (!view.floor || !view.up_camera || !view.model->spec.stands_on_floor) return 0;
  const Eigen::RowVector3d up = view.up_camera->transpose() * T_camera_object.linear();
  double lowest = 1e9;
  for (int e = 0; e < wireframe.edges(); ++e) {
    lowest = std::min(lowest,
                      up.dot(wireframe.midpoints.col(e)) - std::abs(up.dot(wireframe.directions.col(e))) / 2);
  }
  lowest += view.up_camera->dot(T_camera_object.translation());
  return GemanMcClure((lowest + view.floor->camera_height) / view.floor->sigma, 3);
}

}  // namespace

double PriorCost(const ObjectView& view, const PoseAndShape& estimate, const Wireframe& wireframe,
                 const BoxSides& sides, const ProjectedWireframe& projected, const BoxOptions& box_options,
                 const CostOptions& options) {
  return options.box_weight *
             BoxCost(view, estimate.T_camera_object.linear(), sides, projected, box_options) +
         options.azimuth_weight * AzimuthCost(view, estimate.T_camera_object, options) +
         (view.track_prior ? TrackPriorCost(view, estimate, options) : ShapeCost(estimate)) +
         kFloorWeight * FloorCost(view, estimate.T_camera_object, wireframe) +
         HiddenCost(view, sides, box_options);
}

double LineCost(const ProjectedWireframe& projected, double covered_length) {
  const double visible = projected.VisibleLength();
  if (visible <= 0) return kCoverageWeight;
  return kCoverageWeight * (1 - covered_length / visible);
}

}  // namespace armature
