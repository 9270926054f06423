// SPDX-License-Identifier: BSD-3-Clause
// Pose graphs whose true poses are known.
#pragma once

#include <cmath>
#include <random>

#include "mapping/pose_graph.h"

namespace armature::testing {

inline Vector6d RandomTangent(std::mt19937& random, double rotation, double translation) {
  std::normal_distribution<double> normal;
  Vector6d xi;
  for (int i = 0; i < 6; ++i) xi[i] = (i < 3 ? rotation : translation) * normal(random);
  return xi;
}

// A symmetric positive definite matrix that is far from diagonal.
inline Matrix6d RandomInformation(std::mt19937& random) {
  std::normal_distribution<double> normal;
  const Matrix6d A = Matrix6d::NullaryExpr([&] { return normal(random); });
  return A * A.transpose() + 0.1 * Matrix6d::Identity();
}

// A walk around a torus in `turns` turns of `steps` poses, with edges along the walk and from turn to turn,
// both closed. The poses are the true ones; the edges are off by `noise` (radians, metres).
inline PoseGraph TorusGraph(size_t turns, size_t steps, double noise, std::uint32_t seed = 1) {
  std::mt19937 random(seed);
  PoseGraph graph;
  const size_t count = turns * steps;
  for (size_t i = 0; i < count; ++i) {
    const double around = 2 * M_PI * static_cast<double>(i) / static_cast<double>(count);
    const double tube = 2 * M_PI * static_cast<double>(i) / static_cast<double>(steps);
    Eigen::Isometry3d T(Eigen::AngleAxisd(around, Eigen::Vector3d::UnitZ()));
    T.translate(Eigen::Vector3d(10 + 3 * std::cos(tube), 0, 3 * std::sin(tube)));
    T.rotate(Eigen::AngleAxisd(-tube, Eigen::Vector3d::UnitY()));
    graph.poses.push_back(T);
  }
  for (const size_t step : {size_t{1}, steps}) {
    for (size_t i = 0; i < count; ++i) {
      PoseGraphEdge edge{i, (i + step) % count, Eigen::Isometry3d::Identity(), Matrix6d::Identity()};
      edge.T_from_to = graph.poses[edge.from].inverse() * graph.poses[edge.to] *
                       ExpSE3(RandomTangent(random, noise, noise));
      if (noise > 0) edge.information /= noise * noise;
      graph.edges.push_back(edge);
    }
  }
  return graph;
}

// The worst that a file can give: poses anywhere.
inline std::vector<Eigen::Isometry3d> GarbagePoses(const PoseGraph& graph, std::uint32_t seed = 2) {
  std::mt19937 random(seed);
  std::vector<Eigen::Isometry3d> poses = graph.poses;
  for (size_t i = 1; i < poses.size(); ++i) poses[i] = ExpSE3(RandomTangent(random, 2, 20));
  return poses;
}

}  // namespace armature::testing
