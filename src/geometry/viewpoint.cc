// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/viewpoint.h"

#include <cmath>

#include "geometry/rotation.h"

namespace armature {
namespace {

const Eigen::Matrix3d kFlip =
    Eigen::Vector3d(1, -1, -1).asDiagonal();  // object y up, z front -> camera y down, z away

Eigen::Matrix3d AboutAxis(double angle, const Eigen::Vector3d& axis) {
  return Eigen::AngleAxisd(angle, axis).toRotationMatrix();
}

}  // namespace

Eigen::Matrix3d RotationFromViewpoint(const Viewpoint& viewpoint, const Eigen::Vector3d& ray) {
  return SmallestRotation(Eigen::Vector3d::UnitZ(), ray) *
         AboutAxis(viewpoint.tilt, Eigen::Vector3d::UnitZ()) *
         AboutAxis(viewpoint.elevation, Eigen::Vector3d::UnitX()) * kFlip *
         AboutAxis(-viewpoint.azimuth, Eigen::Vector3d::UnitY());
}

Viewpoint ViewpointFromRotation(const Eigen::Matrix3d& R_camera_object, const Eigen::Vector3d& ray) {
  Viewpoint viewpoint;
  const Eigen::Vector3d to_camera = -(R_camera_object.transpose() * ray).normalized();
  viewpoint.azimuth = std::atan2(to_camera.x(), to_camera.z());
  viewpoint.elevation = std::asin(std::clamp(to_camera.y(), -1.0, 1.0));
  const Eigen::Matrix3d rest = SmallestRotation(Eigen::Vector3d::UnitZ(), ray).transpose() * R_camera_object *
                               AboutAxis(viewpoint.azimuth, Eigen::Vector3d::UnitY()) * kFlip *
                               AboutAxis(-viewpoint.elevation, Eigen::Vector3d::UnitX());
  viewpoint.tilt = std::atan2(rest(1, 0), rest(0, 0));
  return viewpoint;
}

Eigen::Matrix3d UprightRotation(double azimuth, const Eigen::Vector3d& up_camera,
                                const Eigen::Vector3d& ray) {
  // The object's axes at azimuth 0: y is up, z (the front) points towards the camera in the horizontal plane.
  const Eigen::Vector3d to_camera = -ray.normalized();
  Eigen::Vector3d front = to_camera - to_camera.dot(up_camera) * up_camera;
  if (front.norm() < 1e-6) front = up_camera.unitOrthogonal();  // seen from exactly above: any front will do
  front.normalize();
  Eigen::Matrix3d R;
  R << up_camera.cross(front), up_camera, front;
  return R * AboutAxis(-azimuth, Eigen::Vector3d::UnitY());
}

double AzimuthDifference(double a, double b, int symmetry_order) {
  return WrapAngle((a - b) * symmetry_order) / symmetry_order;
}

}  // namespace armature
