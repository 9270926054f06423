// SPDX-License-Identifier: BSD-3-Clause
#include "eval/visible_edges.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/rotation.h"

namespace armature {
namespace {

bool HasEdge(const Face& face, int edge) {
  return std::any_of(face.corners.begin(), face.corners.end(),
                     [&](const EdgeEnd& c) { return c.edge == edge; });
}

VisibleEdge Sampled(const Camera& camera, const ProjectedEdge& edge,
                    const std::vector<const ImageFace*>& hiding) {
  VisibleEdge visible;
  if (edge.length <= 0) return visible;
  visible.line = edge.line;
  visible.in_image = true;
  visible.pixels_per_metre = camera.fx * (edge.inverse_z1 + edge.inverse_z2) / 2;
  const int count = std::max(1, static_cast<int>(std::lround(edge.length)));
  for (int i = 0; i < count; ++i) {
    const double t = (i + 0.5) / count;
    const Eigen::Vector2d pixel = edge.line.p1 + t * (edge.line.p2 - edge.line.p1);
    const double inverse_z = edge.inverse_z1 + t * (edge.inverse_z2 - edge.inverse_z1);
    const bool hidden = std::any_of(hiding.begin(), hiding.end(),
                                    [&](const ImageFace* face) { return face->Hides(pixel, inverse_z); });
    if (!hidden) visible.samples.push_back(pixel);
  }
  return visible;
}

// Whether the point is beside the segment, within the distance.
bool IsBeside(const Eigen::Vector2d& point, const Segment& segment, double distance) {
  const Eigen::Vector2d d = segment.p2 - segment.p1;
  const double t = (point - segment.p1).dot(d) / d.squaredNorm();
  return t >= 0 && t <= 1 && std::abs(SignedDistanceToLine(segment, point)) <= distance;
}

}  // namespace

std::vector<VisibleEdge> VisibleEdges(const Camera& camera, const CategorySpec& spec,
                                      const Wireframe& wireframe, const Eigen::Isometry3d& T_camera_object,
                                      const std::vector<ImageFace>& occluders) {
  const Box image{-0.5, -0.5, static_cast<double>(camera.width), static_cast<double>(camera.height)};
  ProjectedWireframe projected;
  ProjectWireframe(camera, spec, wireframe, T_camera_object, image, {}, projected);
  std::vector<VisibleEdge> edges;
  for (int i = 0; i < wireframe.edges(); ++i) {
    std::vector<const ImageFace*> hiding;
    for (size_t f = 0; f < spec.faces.size(); ++f) {
      if (!HasEdge(spec.faces[f], i)) hiding.push_back(&projected.faces[f]);
    }
    for (const ImageFace& face : occluders) hiding.push_back(&face);
    edges.push_back(Sampled(camera, projected.edges[static_cast<size_t>(i)], hiding));
  }
  return edges;
}

double CoveredLength(const VisibleEdge& edge, const std::vector<Segment>& segments,
                     const EdgeTolerance& tolerance) {
  if (!edge.in_image) return 0;
  std::vector<const Segment*> parallel;
  for (const Segment& segment : segments) {
    if (AcuteAngle(segment, edge.line) <= tolerance.angle_deg * kDegree) parallel.push_back(&segment);
  }
  const auto covered = [&](const Eigen::Vector2d& sample) {
    return std::any_of(parallel.begin(), parallel.end(),
                       [&](const Segment* s) { return IsBeside(sample, *s, tolerance.distance); });
  };
  return static_cast<double>(std::count_if(edge.samples.begin(), edge.samples.end(), covered));
}

bool LiesOnEdge(const Segment& segment, const VisibleEdge& edge, const EdgeTolerance& tolerance) {
  if (!edge.in_image || AcuteAngle(segment, edge.line) > tolerance.angle_deg * kDegree) return false;
  const double distance = tolerance.distance + tolerance.metres * edge.pixels_per_metre;
  if (std::abs(SignedDistanceToLine(edge.line, segment.p1)) > distance) return false;
  if (std::abs(SignedDistanceToLine(edge.line, segment.p2)) > distance) return false;
  const Eigen::Vector2d along = (edge.line.p2 - edge.line.p1).normalized();
  const double s1 = along.dot(segment.p1 - edge.line.p1), s2 = along.dot(segment.p2 - edge.line.p1);
  return std::min(std::max(s1, s2), edge.line.length()) - std::max(std::min(s1, s2), 0.0) >= 1;
}

Eigen::Matrix3d TurnAboutY(int symmetry_order, int step) {
  return Eigen::AngleAxisd(2 * std::numbers::pi * step / symmetry_order, Eigen::Vector3d::UnitY())
      .toRotationMatrix();
}

std::vector<int> SymmetricCounterparts(const Wireframe& wireframe, int symmetry_order, int step) {
  std::vector<int> counterparts;
  const Eigen::Matrix3Xd turned = TurnAboutY(symmetry_order, step) * wireframe.midpoints;
  for (int i = 0; i < wireframe.edges(); ++i) {
    Eigen::Index nearest = 0;
    (wireframe.midpoints.colwise() - turned.col(i)).colwise().squaredNorm().minCoeff(&nearest);
    counterparts.push_back(static_cast<int>(nearest));
  }
  return counterparts;
}

int NearestSymmetryStep(const Eigen::Matrix3d& R_estimated, const Eigen::Matrix3d& R_true,
                        int symmetry_order) {
  int best = 0;
  double best_trace = -4;
  for (int step = 0; step < symmetry_order; ++step) {
    const double trace = (R_estimated.transpose() * R_true * TurnAboutY(symmetry_order, step)).trace();
    if (trace > best_trace + 1e-12) {
      best = step;
      best_trace = trace;
    }
  }
  return best;
}

}  // namespace armature
