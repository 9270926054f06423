// SPDX-License-Identifier: BSD-3-Clause
#include "mapping/object_factors.h"

#include <Eigen/Dense>
#include <cmath>

#include "geometry/rotation.h"

namespace armature {
namespace {

// 1/2 d^T H d + g^T d
struct Quadratic {
  Eigen::MatrixXd H;
  Eigen::VectorXd g;
};

// The noise's covariance in the evidence's coordinates: rotation and translation along the camera's axes.
Eigen::MatrixXd NoiseCovariance(const FactorNoise& noise, const Eigen::Vector3d& t, Eigen::Index size) {
  const double distance = t.norm();
  const Eigen::Vector3d ray = t / distance;
  Eigen::MatrixXd N = Eigen::MatrixXd::Zero(size, size);
  N.diagonal().head<3>().setConstant(std::pow(noise.rotation_sigma_deg * kDegree, 2));
  N.diagonal().segment<3>(3).setConstant(std::pow(noise.lateral_sigma * distance, 2));
  N.block<3, 3>(3, 3) += std::pow(noise.depth_sigma * distance, 2) * ray * ray.transpose();
  N.diagonal().tail(size - 6).setConstant(noise.shape_sigma * noise.shape_sigma);
  return N;
}

// The minimum over n, n ~ N(0, P^-1), of the quadratic at d + n:
//   H' = H - H (H + P)^-1 H = P (H + P)^-1 H,   g' = P (H + P)^-1 g.
// Needs no inverse of H, which one image leaves nearly singular.
Quadratic WithNoise(const Quadratic& quadratic, const Eigen::MatrixXd& noise_covariance) {
  const Eigen::Index size = quadratic.g.size();
  const Eigen::MatrixXd P = noise_covariance.llt().solve(Eigen::MatrixXd::Identity(size, size));
  const Eigen::LLT<Eigen::MatrixXd> sum(quadratic.H + P);
  const Eigen::MatrixXd H = P * sum.solve(quadratic.H);
  return {0.5 * (H + H.transpose()), P * sum.solve(quadratic.g)};
}

// A^T A = H and A^T b = g: with H = L L^T, A = L^T and b = L^-1 g. Directions that the image says nothing of
// get next to no weight.
void Factorise(const Quadratic& quadratic, ObjectFactor& factor) {
  Eigen::MatrixXd H = quadratic.H;
  H.diagonal().array() += 1e-9 * (1 + H.diagonal().maxCoeff());
  const Eigen::LLT<Eigen::MatrixXd> cholesky(H);
  factor.A = cholesky.matrixU();
  factor.b = cholesky.matrixL().solve(quadratic.g);
}

}  // namespace

ObjectFactor MakeObjectFactor(const ImageEvidence& evidence, const PoseAndShape& at, double turn,
                              const FactorNoise& noise) {
  const Eigen::Index size = evidence.gradient.size();
  const double weight = 1 / (noise.measurement_scale * noise.measurement_scale);
  Quadratic quadratic = WithNoise({weight * evidence.information, weight * evidence.gradient},
                                  NoiseCovariance(noise, at.T_camera_object.translation(), size));
  ObjectFactor factor;
  factor.at = at;
  factor.at.T_camera_object.rotate(Eigen::AngleAxisd(turn, Eigen::Vector3d::UnitY()));
  // exp(w) R = R exp(R^T w) and T + v = T + R (R^T v): the camera's axes to the object's.
  Eigen::MatrixXd G = Eigen::MatrixXd::Identity(size, size);
  G.topLeftCorner<3, 3>() = G.block<3, 3>(3, 3) = factor.at.T_camera_object.linear();
  Factorise({G.transpose() * quadratic.H * G, G.transpose() * quadratic.g}, factor);
  return factor;
}

void MarginalizeRotation(ObjectFactor& factor) {
  const Eigen::MatrixXd H = factor.A.transpose() * factor.A;
  const Eigen::VectorXd g = factor.A.transpose() * factor.b;
  const Eigen::Index rest = g.size() - 3;
  const Eigen::MatrixXd W =
      (H.topLeftCorner<3, 3>() + 1e-9 * Eigen::Matrix3d::Identity()).inverse() * H.topRightCorner(3, rest);
  Quadratic marginal{Eigen::MatrixXd::Zero(g.size(), g.size()), Eigen::VectorXd::Zero(g.size())};
  marginal.H.bottomRightCorner(rest, rest) =
      H.bottomRightCorner(rest, rest) - H.bottomLeftCorner(rest, 3) * W;
  marginal.g.tail(rest) = g.tail(rest) - W.transpose() * g.head<3>();
  Factorise(marginal, factor);
}

Eigen::VectorXd Residual(const ObjectFactor& factor, const PoseAndShape& seen) {
  Eigen::VectorXd d(factor.b.size());
  d << LogSE3(factor.at.T_camera_object.inverse() * seen.T_camera_object),
      seen.coefficients - factor.at.coefficients;
  return factor.A * d + factor.b;
}

void Turn(double angle, ObjectFactor& factor) {
  const Eigen::AngleAxisd turn(angle, Eigen::Vector3d::UnitY());
  factor.at.T_camera_object.rotate(turn);
  const Eigen::Matrix3d R = turn.toRotationMatrix();
  factor.A.leftCols<3>() *= R;
  factor.A.middleCols<3>(3) *= R;
}

// A camera that is off by a small step sees the object off by it, at the object's distance.
ObjectFactor WithDrift(const ObjectFactor& factor, const DriftNoise& drift) {
  if (drift.translation_sigma <= 0 && drift.rotation_sigma <= 0) return factor;
  const double distance = factor.at.T_camera_object.translation().norm();
  Eigen::MatrixXd N = 1e-12 * Eigen::MatrixXd::Identity(factor.b.size(), factor.b.size());
  N.diagonal().head<3>().array() += std::pow(drift.rotation_sigma, 2);
  N.diagonal().segment<3>(3).array() +=
      std::pow(drift.translation_sigma, 2) + std::pow(drift.rotation_sigma * distance, 2);
  ObjectFactor result = factor;
  Factorise(WithNoise({factor.A.transpose() * factor.A, factor.A.transpose() * factor.b}, N), result);
  return result;
}

}  // namespace armature
