// SPDX-License-Identifier: BSD-3-Clause
#include "mapping/supports.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "geometry/rotation.h"

namespace armature {
namespace {

constexpr double kLevel = 20 * kDegree;  // of a face's normal from up
constexpr double kReach = 0.3;           // metres: what ends farther above or below does not stand there
constexpr double kOverhang = 0.15;       // metres: that an object's centre may be beside the face

// Corners of a face in the world, metres.
Eigen::Matrix3Xd Corners(const GraphObject& object, const Face& face) {
  const Wireframe wireframe = WireframeFromCoefficients(*object.model, object.coefficients);
  Eigen::Matrix3Xd corners(3, static_cast<Eigen::Index>(face.corners.size()));
  for (size_t k = 0; k < face.corners.size(); ++k) {
    corners.col(static_cast<Eigen::Index>(k)) =
        object.T_world_object *
        (std::exp(object.log_size) * wireframe.End(face.corners[k].edge, face.corners[k].end));
  }
  return corners;
}

Eigen::Vector3d Normal(const Eigen::Matrix3Xd& corners) {
  return (corners.col(1) - corners.col(0)).cross(corners.col(2) - corners.col(1)).normalized();
}

// Metres from the point to the face's outline, along the face; negative inside. The face is convex.
double Beside(const Eigen::Vector3d& point, const Eigen::Matrix3Xd& corners, const Eigen::Vector3d& normal) {
  double most = -1e9;
  const Eigen::Vector3d middle = corners.rowwise().mean();
  for (Eigen::Index k = 0; k < corners.cols(); ++k) {
    const Eigen::Vector3d from = corners.col(k), to = corners.col((k + 1) % corners.cols());
    Eigen::Vector3d outward = (to - from).cross(normal).normalized();
    if (outward.dot(middle - from) > 0) outward = -outward;
    most = std::max(most, outward.dot(point - from));
  }
  return most;
}

Eigen::Vector3d LowestPointOf(const GraphObject& object) {
  const ShapePoint lowest = LowestPoint(*object.model, object.coefficients);
  return object.T_world_object * (std::exp(object.log_size) * (lowest.X0 + lowest.G * object.coefficients));
}

}  // namespace

std::vector<Support> FindSupports(const MapGraph& graph) {
  std::vector<Support> supports;
  for (size_t a = 0; a < graph.objects.size(); ++a) {
    const GraphObject& object = graph.objects[a];
    if (object.model->spec.stands_on_floor) continue;
    const double foot = graph.up_world.dot(LowestPointOf(object));
    double nearest = kReach;
    Support support{static_cast<int>(a), -1, 0};
    for (size_t b = 0; b < graph.objects.size(); ++b) {
      const std::vector<Face>& faces = graph.objects[b].model->spec.faces;
      for (size_t f = 0; b != a && f < faces.size(); ++f) {
        const Eigen::Matrix3Xd corners = Corners(graph.objects[b], faces[f]);
        const Eigen::Vector3d normal = Normal(corners);
        const double height = graph.up_world.dot(Eigen::Vector3d(corners.rowwise().mean()));
        if (std::abs(normal.dot(graph.up_world)) < std::cos(kLevel) || std::abs(foot - height) >= nearest ||
            Beside(object.T_world_object.translation(), corners, normal) > kOverhang) {
          continue;
        }
        nearest = std::abs(foot - height);
        support.on = static_cast<int>(b);
        support.face = static_cast<int>(f);
      }
    }
    if (support.on >= 0) supports.push_back(support);
  }
  return supports;
}

ShapePoint FaceCentre(const CategoryModel& model, int face) {
  const std::vector<EdgeEnd>& corners = model.spec.faces[static_cast<size_t>(face)].corners;
  ShapePoint centre = PointOnEdge(model, corners.front().edge, corners.front().end - 0.5);
  for (size_t k = 1; k < corners.size(); ++k) {
    const ShapePoint corner = PointOnEdge(model, corners[k].edge, corners[k].end - 0.5);
    centre.X0 += corner.X0;
    centre.G += corner.G;
  }
  centre.X0 /= static_cast<double>(corners.size());
  centre.G /= static_cast<double>(corners.size());
  return centre;
}

}  // namespace armature
