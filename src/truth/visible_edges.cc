// SPDX-License-Identifier: BSD-3-Clause
#include "truth/visible_edges.h"

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

// The middles of the pixels along a line, as shares of its length.
std::vector<double> PixelsAlong(double length) {
  const int count = std::max(1, static_cast<int>(std::lround(length)));
  std::vector<double> shares;
  shares.reserve(static_cast<size_t>(count));
  for (int i = 0; i < count; ++i) shares.push_back((i + 0.5) / count);
  return shares;
}

Eigen::Vector2d MakePoint(const Segment& line, double share) { return line.p1 + share * (line.p2 - line.p1); }

VisibleEdge Sampled(const Camera& camera, const ProjectedEdge& edge,
                    const std::vector<const ImageFace*>& hiding) {
  VisibleEdge visible;
  if (edge.length <= 0) return visible;
  visible.line = edge.line;
  visible.in_image = true;
  visible.pixels_per_metre = camera.fx * (edge.inverse_z1 + edge.inverse_z2) / 2;
  for (const double t : PixelsAlong(edge.length)) {
    const Eigen::Vector2d pixel = MakePoint(edge.line, t);
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

// Pixels.
double DistanceAllowed(const VisibleEdge& edge, const EdgeTolerance& tolerance) {
  return tolerance.distance + tolerance.metres * edge.pixels_per_metre;
}

}  // namespace

std::vector<VisibleEdge> VisibleEdges(const Camera& camera, const CategorySpec& spec,
                                      const Wireframe& wireframe, const Eigen::Isometry3d& T_camera_object,
                                      const std::vector<ImageFace>& occluders) {
  const Box image{-0.5, -0.5, static_cast<double>(camera.width), static_cast<double>(camera.height)};
  ProjectedWireframe projected;
  ProjectEdges(camera, wireframe, T_camera_object, image, projected);
  DetermineVisibility(camera, spec, wireframe, T_camera_object, {}, projected);
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

VisibleEdge EdgeSeenInPart(const Segment& line, double visible_share, double pixels_per_metre) {
  VisibleEdge edge;
  edge.line = line;
  edge.in_image = line.length() > 0;
  edge.visible_share = visible_share;
  edge.pixels_per_metre = pixels_per_metre;
  if (!edge.in_image) return edge;
  for (const double t : PixelsAlong(line.length())) edge.samples.push_back(MakePoint(line, t));
  return edge;
}

double CoveredLength(const VisibleEdge& edge, const std::vector<Segment>& segments,
                     const EdgeTolerance& tolerance) {
  if (!edge.in_image) return 0;
  const double distance = DistanceAllowed(edge, tolerance);
  std::vector<const Segment*> parallel;
  for (const Segment& segment : segments) {
    if (AcuteAngle(segment, edge.line) <= tolerance.angle_deg * kDegree) parallel.push_back(&segment);
  }
  const auto covered = [&](const Eigen::Vector2d& sample) {
    return std::any_of(parallel.begin(), parallel.end(),
                       [&](const Segment* s) { return IsBeside(sample, *s, distance); });
  };
  const auto count = std::count_if(edge.samples.begin(), edge.samples.end(), covered);
  return std::min(static_cast<double>(count), edge.visible_length());
}

double DistanceFromLine(const Segment& segment, const VisibleEdge& edge) {
  return std::max(std::abs(SignedDistanceToLine(edge.line, segment.p1)),
                  std::abs(SignedDistanceToLine(edge.line, segment.p2)));
}

bool LiesOnEdge(const Segment& segment, const VisibleEdge& edge, const EdgeTolerance& tolerance) {
  if (!edge.in_image || edge.visible_share <= 0) return false;
  if (AcuteAngle(segment, edge.line) > tolerance.angle_deg * kDegree) return false;
  if (DistanceFromLine(segment, edge) > DistanceAllowed(edge, tolerance)) return false;
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
