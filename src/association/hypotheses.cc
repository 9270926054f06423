// SPDX-License-Identifier: BSD-3-Clause
#include "association/hypotheses.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/rotation.h"
#include "geometry/viewpoint.h"

namespace armature {
namespace {

constexpr double kAllRoundStep = 15 * kDegree;  // without a prior

Eigen::Vector3d BoxRay(const ObjectView& view) { return view.camera->Ray(view.detection.box.center()); }

// -spread, -spread + step, ... 0 ... spread
std::vector<double> Offsets(double spread, double step) {
  std::vector<double> offsets = {0};
  for (double offset = step; step > 0 && offset <= spread + 1e-9; offset += step) {
    offsets.push_back(offset);
    offsets.push_back(-offset);
  }
  return offsets;
}

// Turns about y, modulo half a turn, at which the category's mean has horizontal edges.
std::vector<double> HorizontalEdgeAngles(const CategoryModel& model) {
  std::vector<double> angles;
  const Wireframe mean = WireframeFromVector(model.mean);
  for (int e = 0; e < mean.edges(); ++e) {
    const Eigen::Vector3d D = mean.directions.col(e);
    if (std::abs(D.y()) > 0.2 * D.norm()) continue;
    const double angle = std::atan2(D.x(), D.z());
    const bool known = std::any_of(angles.begin(), angles.end(), [&](double other) {
      return std::abs(AzimuthDifference(angle, other, 2)) < 10 * kDegree;
    });
    if (!known) angles.push_back(angle);
  }
  return angles;
}

std::vector<Eigen::Matrix3d> Rotations(const ObjectView& view, double azimuth,
                                       const HypothesisOptions& options) {
  const Eigen::Vector3d ray = BoxRay(view);
  if (view.up_camera) return {UprightRotation(azimuth, *view.up_camera, ray)};
  std::vector<Eigen::Matrix3d> rotations;
  for (const double elevation :
       Offsets(options.elevation_spread_deg * kDegree, options.angle_step_deg * kDegree)) {
    for (const double tilt : Offsets(options.tilt_spread_deg * kDegree, options.angle_step_deg * kDegree)) {
      const Viewpoint viewpoint{azimuth, view.detection.elevation.value_or(0) + elevation,
                                view.detection.tilt.value_or(0) + tilt};
      rotations.push_back(RotationFromViewpoint(viewpoint, ray));
    }
  }
  return rotations;
}

// The box as it is, with its bottom hidden, with each other side hidden that may be, and with all of those.
std::vector<BoxSides> SideVariants(const ObjectView& view, const HypothesisOptions& options) {
  std::vector<BoxSides> variants = {view.sides};
  if (!options.hidden_sides) return variants;
  BoxSides all = view.sides;
  for (size_t side = 0; side < 4; ++side) {
    if (view.sides[side] == BoxSide::kOpen || view.hidden_probability[side] <= 0) continue;
    variants.push_back(view.sides);
    variants.back()[side] = all[side] = BoxSide::kOpen;
  }
  if (variants.size() > 2) variants.push_back(all);
  return variants;
}

// The sides that the wireframe's ends leave behind by far are taken to be hidden, if they may be.
BoxSides SidesFor(const ObjectView& view, const Wireframe& wireframe, const Eigen::Isometry3d& T,
                  const BoxOptions& options) {
  ProjectedWireframe projected;
  const Box image{0, 0, view.camera->width - 1.0, view.camera->height - 1.0};
  ProjectWireframe(*view.camera, view.model->spec, wireframe, T, image, {}, projected);
  const std::array<ExtremePoint, 4> extremes = Extremes(projected);
  const Box& box = view.detection.box;
  const auto [sigma_x, sigma_y] = SideSigmas(box, options);
  const std::array<double, 4> beyond = {
      (box.left() - extremes[0].pixel) / sigma_x, (box.top() - extremes[1].pixel) / sigma_y,
      (extremes[2].pixel - box.right()) / sigma_x, (extremes[3].pixel - box.bottom()) / sigma_y};
  BoxSides sides = view.sides;
  for (size_t side = 0; side < 4; ++side) {
    if (beyond[side] > 2 && view.hidden_probability[side] > 0) sides[side] = BoxSide::kOpen;
  }
  return sides;
}

void AddLineSeeds(const ObjectView& view, double azimuth, const Eigen::Matrix3d& R,
                  const Wireframe& wireframe, const Eigen::VectorXd& coefficients,
                  const BoxOptions& box_options, const HypothesisOptions& options,
                  std::vector<Hypothesis>& hypotheses) {
  for (const Eigen::Vector3d& translation : TranslationsFromLines(view, wireframe, R, options.line_seeds)) {
    Hypothesis hypothesis{{Eigen::Isometry3d::Identity(), coefficients}, view.sides, azimuth};
    hypothesis.start.T_camera_object.linear() = R;
    hypothesis.start.T_camera_object.translation() = translation;
    hypothesis.sides = SidesFor(view, wireframe, hypothesis.start.T_camera_object, box_options);
    hypotheses.push_back(std::move(hypothesis));
  }
}

std::vector<double> DepthFactors(const HypothesisOptions& options) {
  if (options.depth_factor == 1) return {1.0};
  return {1.0, 1 / options.depth_factor, options.depth_factor};
}

}  // namespace

std::vector<double> AzimuthsOfHorizontalSegments(const ObjectView& view, double prior_azimuth, double spread,
                                                 int max_peaks) {
  if (!view.up_camera || max_peaks <= 0) return {};
  constexpr int kBins = 90;  // of 2 degrees, over half a turn about the prior... a full turn has 180
  constexpr double kBin = 2 * kDegree;
  std::array<double, 2 * kBins> votes{};
  const Eigen::Vector3d up = *view.up_camera;
  const Eigen::Matrix3d R0 = UprightRotation(0, up, BoxRay(view));
  const std::vector<double> edge_angles = HorizontalEdgeAngles(*view.model);
  for (const Segment& segment : view.segments) {
    const Eigen::Vector3d n = view.camera->Ray(segment.p1).cross(view.camera->Ray(segment.p2)).normalized();
    const Eigen::Vector3d along = up.cross(n);
    // A plane that is itself nearly horizontal holds every direction; one that holds `up` may be a vertical
    // edge.
    if (along.norm() < 0.15 || std::abs(n.dot(up)) < 0.05) continue;
    const Eigen::Vector3d in_object = R0.transpose() * along;
    const double angle = std::atan2(in_object.x(), in_object.z());
    // R = R0 Ry(-azimuth): an edge at angle a of the object appears at a - azimuth in R0's frame.
    for (const double edge_angle : edge_angles) {
      for (const double half_turn : {0.0, M_PI}) {
        const double offset = WrapAngle(edge_angle - angle + half_turn - prior_azimuth);
        const int bin = static_cast<int>(std::floor((offset + M_PI) / kBin)) % (2 * kBins);
        votes[static_cast<size_t>(bin)] += segment.length();
      }
    }
  }
  std::vector<double> peaks;
  const auto smoothed = [&](int bin) {
    double sum = 0;
    for (int d = -1; d <= 1; ++d) sum += votes[static_cast<size_t>((bin + d + 2 * kBins) % (2 * kBins))];
    return sum + votes[static_cast<size_t>(bin)];
  };
  std::vector<std::pair<double, int>> ranked;
  for (int bin = 0; bin < 2 * kBins; ++bin) {
    const double offset = (bin + 0.5) * kBin - M_PI;
    if (std::abs(offset) <= spread) ranked.push_back({-smoothed(bin), bin});
  }
  std::sort(ranked.begin(), ranked.end());
  for (const auto& [negative_votes, bin] : ranked) {
    if (negative_votes == 0 || static_cast<int>(peaks.size()) >= max_peaks) break;
    const double azimuth = WrapAngle(prior_azimuth + (bin + 0.5) * kBin - M_PI);
    const bool near_other = std::any_of(peaks.begin(), peaks.end(), [&](double other) {
      return std::abs(WrapAngle(other - azimuth)) < 6 * kDegree;
    });
    if (!near_other) peaks.push_back(azimuth);
  }
  return peaks;
}

std::vector<double> CandidateAzimuths(const ObjectView& view, const HypothesisOptions& options) {
  std::vector<double> azimuths;
  if (!view.detection.azimuth) {
    const double all_round = 2 * M_PI / view.model->spec.symmetry_order;
    for (double azimuth = 0; azimuth < all_round - 1e-9; azimuth += kAllRoundStep)
      azimuths.push_back(azimuth);
    return azimuths;
  }
  const double prior = *view.detection.azimuth, spread = options.azimuth_spread_deg * kDegree;
  for (const double offset : Offsets(spread, options.azimuth_step_deg * kDegree))
    azimuths.push_back(prior + offset);
  for (const double azimuth : AzimuthsOfHorizontalSegments(view, prior, spread, options.horizontal_peaks)) {
    azimuths.push_back(azimuth);
  }
  return azimuths;
}

std::vector<Hypothesis> MakeHypotheses(const ObjectView& view, const BoxOptions& box_options,
                                       const HypothesisOptions& options) {
  std::vector<Hypothesis> hypotheses;
  const std::vector<BoxSides> variants = SideVariants(view, options);
  const std::vector<double> depth_factors = DepthFactors(options);
  const bool seeds_from_lines = options.line_seeds.enabled && NeedsLineSeeds(view);
  std::vector<Wireframe> wireframes;
  for (const Eigen::VectorXd& c : view.model->dictionary)
    wireframes.push_back(WireframeFromCoefficients(*view.model, c));
  for (const double azimuth : CandidateAzimuths(view, options)) {
    for (const Eigen::Matrix3d& R : Rotations(view, azimuth, options)) {
      for (size_t d = 0; d < wireframes.size(); ++d) {
        if (seeds_from_lines) {
          AddLineSeeds(view, azimuth, R, wireframes[d], view.model->dictionary[d], box_options, options,
                       hypotheses);
        }
        for (const BoxSides& sides : variants) {
          const Eigen::Vector3d T = options.printed_translation
                                        ? PrintedTranslation(view, wireframes[d], R)
                                        : TranslationFromBox(view, sides, wireframes[d], R);
          for (const double factor : depth_factors) {
            Hypothesis hypothesis{{Eigen::Isometry3d::Identity(), view.model->dictionary[d]}, sides, azimuth};
            hypothesis.start.T_camera_object.linear() = R;
            hypothesis.start.T_camera_object.translation() = factor * T;
            hypotheses.push_back(std::move(hypothesis));
          }
        }
      }
    }
  }
  if (view.memory) {
    const PoseAndShape& expected = view.memory->expected;
    const Eigen::Isometry3d& T = expected.T_camera_object;
    const double azimuth = ViewpointFromRotation(T.linear(), T.translation()).azimuth;
    for (const BoxSides& sides : variants) hypotheses.push_back({expected, sides, azimuth});
  }
  return hypotheses;
}

}  // namespace armature
