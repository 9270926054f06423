// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>

#include "association/hypotheses.h"
#include "geometry/rotation.h"
#include "geometry/viewpoint.h"

namespace armature {
namespace {

constexpr int kBins = 180;  // over a full turn
constexpr double kBin = 2 * M_PI / kBins;
constexpr double kDistinct = 6 * kDegree;  // peaks nearer than this are one

using Votes = std::array<double, kBins>;  // pixels of segment, by the offset from the prior's azimuth

double ComputeBinOffset(int bin) { return (bin + 0.5) * kBin - M_PI; }

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

// Each segment votes for the turns at which one of the category's horizontal edges runs along it.
Votes CollectVotes(const ObjectView& view, double prior_azimuth) {
  Votes votes{};
  const Eigen::Vector3d up = *view.up_camera;
  const Eigen::Matrix3d R0 = UprightRotation(0, up, view.camera->Ray(view.detection.box.center()));
  const std::vector<double> edge_angles = HorizontalEdgeAngles(*view.model);
  for (const Segment& segment : view.segments) {
    const Eigen::Vector3d n = view.camera->Ray(segment.p1).cross(view.camera->Ray(segment.p2)).normalized();
    const Eigen::Vector3d along = up.cross(n);
    // A plane that is itself nearly horizontal holds every direction; one that holds `up` may be of a
    // vertical edge.
    if (along.norm() < 0.15 || std::abs(n.dot(up)) < 0.05) continue;
    const Eigen::Vector3d in_object = R0.transpose() * along;
    const double angle = std::atan2(in_object.x(), in_object.z());
    // R = R0 Ry(-azimuth): an edge at angle a of the object appears at a - azimuth in R0's frame.
    for (const double edge_angle : edge_angles) {
      for (const double half_turn : {0.0, M_PI}) {
        const double offset = WrapAngle(edge_angle - angle + half_turn - prior_azimuth);
        votes[static_cast<size_t>(std::floor((offset + M_PI) / kBin)) % kBins] += segment.length();
      }
    }
  }
  return votes;
}

double Smoothed(const Votes& votes, int bin) {
  const auto at = [&](int i) { return votes[static_cast<size_t>((i + kBins) % kBins)]; };
  return at(bin - 1) + 2 * at(bin) + at(bin + 1);
}

}  // namespace

std::vector<double> FindHorizontalAzimuths(const ObjectView& view, double prior_azimuth, double spread,
                                           int max_peaks) {
  std::vector<double> peaks;
  if (!view.up_camera || max_peaks <= 0) return peaks;
  const Votes votes = CollectVotes(view, prior_azimuth);
  std::vector<std::pair<double, int>> ranked;  // negative votes, bin
  for (int bin = 0; bin < kBins; ++bin) {
    if (std::abs(ComputeBinOffset(bin)) <= spread) ranked.push_back({-Smoothed(votes, bin), bin});
  }
  std::sort(ranked.begin(), ranked.end());
  for (const auto& [negative_votes, bin] : ranked) {
    if (negative_votes == 0 || static_cast<int>(peaks.size()) >= max_peaks) break;
    const double azimuth = WrapAngle(prior_azimuth + ComputeBinOffset(bin));
    const bool is_new = std::none_of(peaks.begin(), peaks.end(), [&](double other) {
      return std::abs(WrapAngle(other - azimuth)) < kDistinct;
    });
    if (is_new) peaks.push_back(azimuth);
  }
  return peaks;
}

}  // namespace armature
