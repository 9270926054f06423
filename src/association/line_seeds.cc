// SPDX-License-Identifier: BSD-3-Clause
#include "association/line_seeds.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "geometry/rotation.h"

namespace armature {
namespace {

constexpr double kNearest = 0.3, kFarthest = 15;  // metres, of an object's centre
// A bound on time; tuned on office_dev and redkitchen_a.
constexpr size_t kSeedSegments = 30;        // the longest, that are tried on every edge
constexpr size_t kSeedPairs = 20;           // pairs of edge and segment that are combined, two at a time
constexpr size_t kSeedTranslations = 16;    // kept for each rotation and shape
constexpr double kSeedAngle = 4 * kDegree;  // between the edge and the segment's plane, at most

// A segment that may be the image of an edge, whatever the translation.
struct Pair {
  int edge = 0;
  Segment segment;
  Eigen::Vector3d normal;  // of the segment's plane, unit, camera frame
  double offset = 0;       // N . T = offset
  double length = 0;       // pixels
};

std::vector<Pair> CompatiblePairs(const ObjectView& view, const Wireframe& wireframe,
                                  const Eigen::Matrix3d& R) {
  const double max_sine = std::sin(kSeedAngle);
  const size_t count = std::min(view.segments.size(), kSeedSegments);
  std::vector<Pair> pairs;
  for (size_t i = 0; i < count; ++i) {
    const Segment& segment = view.segments[i];
    const Eigen::Vector3d normal =
        view.camera->Ray(segment.p1).cross(view.camera->Ray(segment.p2)).normalized();
    const Eigen::RowVector3d in_object = normal.transpose() * R;
    for (int e = 0; e < wireframe.edges(); ++e) {
      const double along = std::abs(in_object.dot(wireframe.directions.col(e)));
      if (along > max_sine * wireframe.directions.col(e).norm()) continue;
      pairs.push_back({e, segment, normal, -in_object.dot(wireframe.midpoints.col(e)), segment.length()});
    }
  }
  return pairs;
}

// Whether the segment lies beside the edge's projection, not on its extension: at least half of it.
bool LiesOnEdge(const Camera& camera, const Wireframe& wireframe, const Eigen::Matrix3d& R,
                const Eigen::Vector3d& T, const Pair& pair) {
  Eigen::Vector3d a = R * wireframe.End(pair.edge, 0) + T, b = R * wireframe.End(pair.edge, 1) + T;
  const double near = 0.05;
  if (a.z() < near && b.z() < near) return false;
  if (a.z() < near) a = b + (b.z() - near) / (b.z() - a.z()) * (a - b);
  if (b.z() < near) b = a + (a.z() - near) / (a.z() - b.z()) * (b - a);
  const Eigen::Vector2d p = camera.Project(a), d = camera.Project(b) - p;
  double t1 = d.dot(pair.segment.p1 - p) / d.squaredNorm(), t2 = d.dot(pair.segment.p2 - p) / d.squaredNorm();
  if (t1 > t2) std::swap(t1, t2);
  return std::min(t2, 1.0) - std::max(t1, 0.0) > 0.5 * (t2 - t1);
}

bool IsNew(const std::vector<Eigen::Vector3d>& known, const Eigen::Vector3d& T) {
  return std::none_of(known.begin(), known.end(),
                      [&](const Eigen::Vector3d& other) { return (other - T).norm() < 0.03 * T.norm(); });
}

}  // namespace

bool NeedsLineSeeds(const ObjectView& view) {
  for (size_t side = 0; side < 4; ++side) {
    if (view.sides[side] == BoxSide::kOpen || view.hidden_probability[side] > 0.5) return true;
  }
  return false;
}

std::vector<Eigen::Vector3d> TranslationsFromLines(const ObjectView& view, const Wireframe& wireframe,
                                                   const Eigen::Matrix3d& R) {
  std::vector<Eigen::Vector3d> translations;
  if (!view.floor || !view.up_camera || !view.model->spec.stands_on_floor) return translations;
  const Eigen::Vector3d up_camera = *view.up_camera;
  const Eigen::RowVector3d up = up_camera.transpose();
  const double lowest =
      (up * R * wireframe.midpoints - (up * R * wireframe.directions).cwiseAbs() / 2).minCoeff();
  const double floor = -view.floor->camera_height - lowest;
  std::vector<Pair> pairs = CompatiblePairs(view, wireframe, R);
  std::stable_sort(pairs.begin(), pairs.end(),
                   [](const Pair& a, const Pair& b) { return a.length > b.length; });
  if (pairs.size() > kSeedPairs) pairs.resize(kSeedPairs);
  struct Found {
    double length;
    Eigen::Vector3d T;
  };
  std::vector<Found> found;
  for (size_t i = 0; i < pairs.size(); ++i) {
    for (size_t j = i + 1; j < pairs.size(); ++j) {
      if (pairs[i].edge == pairs[j].edge) continue;
      // Three planes meet in a point: N_i . T = offset_i, N_j . T = offset_j, up . T = floor.
      const Eigen::Vector3d along = pairs[i].normal.cross(pairs[j].normal);
      const double determinant = along.dot(up_camera);
      if (std::abs(determinant) < 0.05) continue;
      const Eigen::Vector3d T = (pairs[i].offset * pairs[j].normal.cross(up_camera) +
                                 pairs[j].offset * up_camera.cross(pairs[i].normal) + floor * along) /
                                determinant;
      if (T.z() < kNearest || T.norm() > kFarthest) continue;
      if (!LiesOnEdge(*view.camera, wireframe, R, T, pairs[i])) continue;
      if (!LiesOnEdge(*view.camera, wireframe, R, T, pairs[j])) continue;
      found.push_back({pairs[i].length + pairs[j].length, T});
    }
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const Found& a, const Found& b) { return a.length > b.length; });
  for (const Found& candidate : found) {
    if (translations.size() >= kSeedTranslations) break;
    if (IsNew(translations, candidate.T)) translations.push_back(candidate.T);
  }
  return translations;
}

}  // namespace armature
