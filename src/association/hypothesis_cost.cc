// SPDX-License-Identifier: BSD-3-Clause
#include "association/hypothesis_cost.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "geometry/rotation.h"
#include "geometry/viewpoint.h"

namespace armature {
namespace {

double GemanMcClure(double r, double scale) { return r * r / (1 + r * r / (scale * scale)); }

double BoxCost(const ObjectView& view, const BoxSides& sides, const ProjectedWireframe& projected,
               const BoxOptions& box_options, const CostOptions& options) {
  const Box& box = view.detection.box;
  const auto [sigma_x, sigma_y] = SideSigmas(box, box_options);
  const std::array<ExtremePoint, 4> extremes = Extremes(projected);
  const std::array<double, 4> at = {box.left(), box.top(), box.right(), box.bottom()};
  double cost = 0;
  for (size_t side = 0; side < 4; ++side) {
    const double sigma = side % 2 == 0 ? sigma_x : sigma_y;
    // Positive where the projection falls short of the side.
    const double padding = PaddingPixels(extremes[side], *view.camera, box_options);
    const double short_by = ((side < 2 ? 1 : -1) * (extremes[side].pixel - at[side]) - padding) / sigma;
    if (sides[side] == BoxSide::kSeen || short_by > 0) cost += GemanMcClure(short_by, options.box_loss_scale);
  }
  return cost;
}

// Of taking sides of the box to be hidden or not, where the image's border does not decide.
double HiddenCost(const ObjectView& view, const BoxSides& sides) {
  double cost = 0;
  for (size_t side = 0; side < 4; ++side) {
    const double p = view.hidden_probability[side];
    if (view.sides[side] == BoxSide::kOpen || p <= 0) continue;
    cost -= std::log(sides[side] == BoxSide::kOpen ? p : 1 - p);
  }
  return cost;
}

double AzimuthCost(const ObjectView& view, const Eigen::Isometry3d& T_camera_object, const CostOptions& options) {
  if (!view.detection.azimuth) return 0;
  const Viewpoint viewpoint = ViewpointFromRotation(T_camera_object.linear(), T_camera_object.translation());
  const double off = AzimuthDifference(viewpoint.azimuth, *view.detection.azimuth, view.model->spec.symmetry_order) /
                     (options.azimuth_sigma_deg * kDegree);
  return -std::log((1 - options.azimuth_outliers) * std::exp(-0.5 * off * off) + options.azimuth_outliers * 0.1);
}

double ShapeCost(const ObjectView& view, const Eigen::VectorXd& coefficients) {
  if (!view.memory) return coefficients.squaredNorm();
  return ((coefficients - view.memory->expected.coefficients) / view.memory->shape_sigma).squaredNorm();
}

double MemoryCost(const ObjectView& view, const Eigen::Isometry3d& T_camera_object, const CostOptions& options) {
  if (!view.memory) return 0;
  const ObjectMemory& memory = *view.memory;
  const Eigen::Vector3d off = T_camera_object.translation() - memory.expected.T_camera_object.translation();
  const double squared = off.dot(memory.position_covariance.llt().solve(off));
  const Eigen::Vector3d front = T_camera_object.linear().col(2);
  const double yaw = std::atan2(front.dot(memory.yaw_quarter), front.dot(memory.yaw_zero));
  return options.memory_weight * GemanMcClure(std::sqrt(squared), 3) +
         std::min(options.yaw_memory_cap, options.azimuth_weight * memory.yaw.At(yaw));
}

double FloorCost(const ObjectView& view, const PoseAndShape& estimate) {
  if (!view.floor || !view.up_camera || !view.model->spec.stands_on_floor) return 0;
  const Wireframe wireframe = WireframeFromCoefficients(*view.model, estimate.coefficients);
  const Eigen::RowVector3d up = view.up_camera->transpose() * estimate.T_camera_object.linear();
  const double lowest =
      (up * wireframe.midpoints - (up * wireframe.directions).cwiseAbs() / 2).minCoeff() +
      view.up_camera->dot(estimate.T_camera_object.translation());
  return GemanMcClure((lowest + view.floor->camera_height) / view.floor->sigma, 3);
}

}  // namespace

double YawBelief::At(double yaw) const {
  const double position = (WrapAngle(yaw) + M_PI) / (2 * M_PI) * kBins - 0.5;  // bin centres are at whole numbers
  const double floor = std::floor(position);
  const auto bin = [&](int offset) {
    return cost[static_cast<size_t>((static_cast<int>(floor) + offset + kBins) % kBins)];
  };
  const double share = position - floor;
  return (1 - share) * bin(0) + share * bin(1);
}

double PriorCost(const ObjectView& view, const PoseAndShape& estimate, const BoxSides& sides,
                 const ProjectedWireframe& projected, const BoxOptions& box_options, const CostOptions& options) {
  return options.box_weight * BoxCost(view, sides, projected, box_options, options) +
         options.azimuth_weight * AzimuthCost(view, estimate.T_camera_object, options) +
         options.shape_weight * ShapeCost(view, estimate.coefficients) +
         MemoryCost(view, estimate.T_camera_object, options) +
         options.floor_weight * FloorCost(view, estimate) + HiddenCost(view, sides);
}

double LineCost(const ObjectView& view, const ProjectedWireframe& projected, double covered_length,
                const CostOptions& options) {
  const double visible = projected.VisibleLength();
  if (visible <= 0) return options.coverage_weight;
  const double diagonal = std::hypot(view.detection.box.width, view.detection.box.height);
  return options.coverage_weight * (1 - covered_length / visible) - options.length_weight * covered_length / diagonal;
}

}  // namespace armature
