// SPDX-License-Identifier: BSD-3-Clause
// Viewpoints: how an object is turned towards the camera, in the field's three angles.
//
// Azimuth and elevation are the direction of the camera seen from the object, in the object's frame (y up,
// front +z):
//   (cos e sin a, sin e, cos e cos a).
// Tilt is the rotation that remains in the image plane:
//   R_camera_object = R_ray * Rz(tilt) * Rx(elevation) * diag(1,-1,-1) * Ry(-azimuth)
// where R_ray is the smallest rotation taking the optical axis to the ray through the object.
#pragma once

#include <Eigen/Geometry>

namespace armature {

struct Viewpoint {
  double azimuth = 0;    // radians
  double elevation = 0;  // radians
  double tilt = 0;       // radians
};

// `ray`: any point on the ray through the object, in the camera frame.
Eigen::Matrix3d RotationFromViewpoint(const Viewpoint& viewpoint, const Eigen::Vector3d& ray);

// The inverse, seen along the ray through the object's centre.
Viewpoint ViewpointFromRotation(const Eigen::Matrix3d& R_camera_object, const Eigen::Vector3d& ray);

// The rotation of an object that stands upright (its y axis along `up_camera`, the unit up direction in the
// camera frame) and is seen from the azimuth along the ray.
Eigen::Matrix3d UprightRotation(double azimuth, const Eigen::Vector3d& up_camera, const Eigen::Vector3d& ray);

// The difference a - b of two azimuths, in [-pi/n, pi/n) for an object that looks the same after each n-th of
// a turn.
double AzimuthDifference(double a, double b, int symmetry_order);

}  // namespace armature
