// SPDX-License-Identifier: BSD-3-Clause
#include "association/projection.h"

#include <algorithm>
#include <array>

namespace armature {
namespace {

constexpr double kNear = 0.05;          // metres
constexpr double kBehindMargin = 1.02;  // a point is hidden when it is 2 % farther than the face
constexpr std::array<double, 4> kSamples = {0.125, 0.375, 0.625, 0.875};  // along an edge, for visibility

// Liang-Barsky against the box, as an interval [enter, leave] of the parameter along a -> b; false when
// outside.
bool ClipInterval(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Box& box, double& enter,
                  double& leave) {
  enter = 0;
  leave = 1;
  const auto inside = [&](const Eigen::Vector2d& p) {
    return p.x() >= box.left() && p.x() <= box.right() && p.y() >= box.top() && p.y() <= box.bottom();
  };
  if (inside(a) && inside(b)) return true;
  const Eigen::Vector2d d = b - a;
  const double step[4] = {-d.x(), d.x(), -d.y(), d.y()};
  const double room[4] = {a.x() - box.left(), box.right() - a.x(), a.y() - box.top(), box.bottom() - a.y()};
  for (int side = 0; side < 4; ++side) {
    if (step[side] < 0) {
      enter = std::max(enter, room[side] / step[side]);
    } else if (step[side] > 0) {
      leave = std::min(leave, room[side] / step[side]);
    } else if (room[side] < 0) {
      return false;
    }
  }
  return enter < leave;
}

ProjectedEdge ProjectEdge(const Camera& camera, const Eigen::Vector3d& end1, const Eigen::Vector3d& end2,
                          const Box& clip) {
  ProjectedEdge edge;
  double s1 = -0.5, s2 = 0.5;
  Eigen::Vector3d P1 = end1, P2 = end2;
  if (P1.z() < kNear && P2.z() < kNear) return edge;
  if (P1.z() < kNear || P2.z() < kNear) {
    const double s = (kNear - end1.z()) / (end2.z() - end1.z());
    (P1.z() < kNear ? P1 : P2) = end1 + s * (end2 - end1);
    (end1.z() < kNear ? s1 : s2) = s - 0.5;
  }
  const Eigen::Vector2d a = camera.Project(P1), b = camera.Project(P2);
  double enter = 0, leave = 1;
  if (!ClipInterval(a, b, clip, enter, leave)) return edge;
  const double q1 = 1 / P1.z(), q2 = 1 / P2.z();
  edge.line = {a + enter * (b - a), a + leave * (b - a)};
  edge.inverse_z1 = q1 + enter * (q2 - q1);
  edge.inverse_z2 = q1 + leave * (q2 - q1);
  // The image parameter t and the edge's s are related by s = s1 + (s2 - s1) t q2 / (q1 + t (q2 - q1)).
  edge.s1 = s1 + (s2 - s1) * enter * q2 / edge.inverse_z1;
  edge.s2 = s1 + (s2 - s1) * leave * q2 / edge.inverse_z2;
  const Eigen::Vector2d d = edge.line.p2 - edge.line.p1;
  edge.length = d.norm();
  if (edge.length > 1e-9) edge.direction = d / edge.length;
  return edge;
}

// The slab's edges at sides that face a camera above it.
std::vector<int> NearSides(const SlabOutline& slab, const Wireframe& wireframe,
                           const Eigen::Vector3d& camera_object) {
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const int i : slab.edges)
    middle += wireframe.midpoints.col(i) / static_cast<double>(slab.edges.size());
  std::vector<int> near;
  for (const int i : slab.edges) {
    const Eigen::Vector3d midpoint = wireframe.midpoints.col(i);
    Eigen::Vector3d outward = wireframe.directions.col(i).cross(Eigen::Vector3d::UnitY());
    if (outward.dot(midpoint - middle) < 0) outward = -outward;
    const Eigen::Vector3d to_camera = camera_object - midpoint;
    if (outward.dot(to_camera) > 0 && to_camera.y() > 0) near.push_back(i);
  }
  return near;
}

bool HasEdge(const Face& face, int edge) {
  return std::count_if(face.corners.begin(), face.corners.end(),
                       [&](const EdgeEnd& c) { return c.edge == edge; }) > 0;
}

double VisibleShare(const ProjectedEdge& edge, int index, const CategorySpec& spec,
                    const std::vector<ImageFace>& own, const std::vector<ImageFace>& occluders) {
  std::array<bool, kSamples.size()> hidden{};
  const auto hide = [&](const ImageFace& face) {
    for (size_t i = 0; i < kSamples.size(); ++i) {
      if (hidden[i]) continue;
      const Eigen::Vector2d pixel = edge.line.p1 + kSamples[i] * (edge.line.p2 - edge.line.p1);
      const double inverse_z = edge.inverse_z1 + kSamples[i] * (edge.inverse_z2 - edge.inverse_z1);
      hidden[i] = face.Hides(pixel, inverse_z);
    }
  };
  for (size_t f = 0; f < own.size(); ++f) {
    if (!HasEdge(spec.faces[f], index)) hide(own[f]);
  }
  for (const ImageFace& face : occluders) hide(face);
  return static_cast<double>(std::count(hidden.begin(), hidden.end(), false)) /
         static_cast<double>(kSamples.size());
}

// Corners in the camera frame; not on the heap.
using FaceCorners = Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::ColMajor, 3, kMaxFaceCorners>;

// Cut at the near plane. `face` keeps its memory.
void ProjectCorners(const Camera& camera, const Eigen::Ref<const Eigen::Matrix3Xd>& corners,
                    ImageFace& face) {
  face.corners.clear();
  const Eigen::Index n = corners.cols();
  for (Eigen::Index i = 0; i < n; ++i) {
    const Eigen::Vector3d a = corners.col(i), b = corners.col((i + 1) % n);
    if (a.z() >= kNear) face.corners.push_back(camera.Project(a));
    if ((a.z() >= kNear) != (b.z() >= kNear)) {
      face.corners.push_back(camera.Project(a + (kNear - a.z()) / (b.z() - a.z()) * (b - a)));
    }
  }
  // Plane n . P = d, P = z * ray: 1/z = n . ray / d, and the ray is affine in the pixel.
  const Eigen::Vector3d normal = (corners.col(1) - corners.col(0)).cross(corners.col(2) - corners.col(0));
  const double d = normal.dot(corners.col(0));
  if (std::abs(d) < 1e-9 * normal.norm()) face.corners.clear();  // seen edge-on: hides nothing
  if (face.corners.empty()) return;
  face.least = face.most = face.corners.front();
  for (const Eigen::Vector2d& corner : face.corners) {
    face.least = face.least.cwiseMin(corner);
    face.most = face.most.cwiseMax(corner);
  }
  const Eigen::Vector3d m = normal / d;
  face.inverse_depth = {m.x() / camera.fx, m.y() / camera.fy,
                        m.z() - m.x() * camera.cx / camera.fx - m.y() * camera.cy / camera.fy};
}

void ProjectAllFaces(const Camera& camera, const CategorySpec& spec, const Wireframe& wireframe,
                     const Eigen::Isometry3d& T_camera_object, std::vector<ImageFace>& faces) {
  faces.resize(spec.faces.size());
  for (size_t f = 0; f < spec.faces.size(); ++f) {
    const std::vector<EdgeEnd>& ends = spec.faces[f].corners;
    FaceCorners corners(3, static_cast<Eigen::Index>(ends.size()));
    for (Eigen::Index i = 0; i < corners.cols(); ++i) {
      const EdgeEnd& corner = ends[static_cast<size_t>(i)];
      corners.col(i) = T_camera_object * wireframe.End(corner.edge, corner.end);
    }
    ProjectCorners(camera, corners, faces[f]);
  }
}

}  // namespace

bool ImageFace::Hides(const Eigen::Vector2d& pixel, double inverse_z) const {
  if (corners.size() < 3) return false;
  if (pixel.x() < least.x() || pixel.x() > most.x() || pixel.y() < least.y() || pixel.y() > most.y()) {
    return false;
  }
  if (inverse_depth.dot(pixel.homogeneous()) < kBehindMargin * inverse_z) return false;
  // Even-odd rule: count the sides that a ray to the right crosses.
  bool inside = false;
  for (size_t i = 0, j = corners.size() - 1; i < corners.size(); j = i++) {
    const Eigen::Vector2d &a = corners[i], &b = corners[j];
    if ((a.y() > pixel.y()) == (b.y() > pixel.y())) continue;
    if (pixel.x() < a.x() + (pixel.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x())) inside = !inside;
  }
  return inside;
}

double ProjectedWireframe::VisibleLength() const {
  double sum = 0;
  for (const ProjectedEdge& edge : edges) sum += edge.length * edge.visible_share;
  return sum;
}

ImageFace ProjectFace(const Camera& camera, const Eigen::Matrix3Xd& corners_camera) {
  ImageFace face;
  ProjectCorners(camera, corners_camera, face);
  return face;
}

std::vector<ImageFace> ProjectFaces(const Camera& camera, const CategorySpec& spec,
                                    const Wireframe& wireframe, const Eigen::Isometry3d& T_camera_object) {
  std::vector<ImageFace> faces;
  ProjectAllFaces(camera, spec, wireframe, T_camera_object, faces);
  return faces;
}

void ProjectEdges(const Camera& camera, const Wireframe& wireframe, const Eigen::Isometry3d& T_camera_object,
                  const Box& clip, ProjectedWireframe& out) {
  const Eigen::Matrix3d R = T_camera_object.linear();
  const Eigen::Vector3d T = T_camera_object.translation();
  out.edges.clear();
  for (int i = 0; i < wireframe.edges(); ++i) {
    const Eigen::Vector3d end1 = R * wireframe.End(i, 0) + T, end2 = R * wireframe.End(i, 1) + T;
    out.edges.push_back(ProjectEdge(camera, end1, end2, clip));
  }
}

void ProjectSeenEdges(const Camera& camera, const CategorySpec& spec, const Wireframe& wireframe,
                      const Eigen::Isometry3d& T_camera_object, const Box& clip, ProjectedWireframe& out) {
  ProjectEdges(camera, wireframe, T_camera_object, clip, out);
  if (!spec.slab || spec.slab->drop <= 0) return;
  const Eigen::Vector3d camera_object = T_camera_object.inverse().translation();
  const Eigen::Vector3d down = T_camera_object.linear() * Eigen::Vector3d(0, -spec.slab->drop, 0);
  for (const int i : NearSides(*spec.slab, wireframe, camera_object)) {
    ProjectedEdge edge = ProjectEdge(camera, T_camera_object * wireframe.End(i, 0) + down,
                                     T_camera_object * wireframe.End(i, 1) + down, clip);
    edge.drop = spec.slab->drop;
    edge.slack = edge.drop * camera.fy * 0.5 * (edge.inverse_z1 + edge.inverse_z2);
    out.edges[static_cast<size_t>(i)] = edge;
  }
}

void DetermineVisibility(const Camera& camera, const CategorySpec& spec, const Wireframe& wireframe,
                         const Eigen::Isometry3d& T_camera_object, const std::vector<ImageFace>& occluders,
                         ProjectedWireframe& out) {
  ProjectAllFaces(camera, spec, wireframe, T_camera_object, out.faces);
  for (size_t i = 0; i < out.edges.size(); ++i) {
    ProjectedEdge& edge = out.edges[i];
    if (edge.length > 0)
      edge.visible_share = VisibleShare(edge, static_cast<int>(i), spec, out.faces, occluders);
  }
}

void ProjectWireframe(const Camera& camera, const CategorySpec& spec, const Wireframe& wireframe,
                      const Eigen::Isometry3d& T_camera_object, const Box& clip,
                      const std::vector<ImageFace>& occluders, ProjectedWireframe& out) {
  ProjectSeenEdges(camera, spec, wireframe, T_camera_object, clip, out);
  DetermineVisibility(camera, spec, wireframe, T_camera_object, occluders, out);
}

}  // namespace armature
