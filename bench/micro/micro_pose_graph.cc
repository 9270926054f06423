// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <memory>

#include "bench/micro/micro_families.h"
#include "geometry/random.h"

namespace armature {
namespace {

constexpr double kRadius = 50;             // metres
constexpr double kRotationNoise = 0.02;    // radians, standard deviation of each component
constexpr double kTranslationNoise = 0.1;  // metres

std::vector<Eigen::Isometry3d> TruePoses(size_t count, size_t per_turn) {
  std::vector<Eigen::Isometry3d> poses;
  for (size_t i = 0; i < count; ++i) {
    const double around = 2 * M_PI * static_cast<double>(i) / static_cast<double>(per_turn);
    const double height = M_PI * ((static_cast<double>(i) + 0.5) / static_cast<double>(count) - 0.5);
    Eigen::Isometry3d T(Eigen::AngleAxisd(around, Eigen::Vector3d::UnitZ()));
    T.rotate(Eigen::AngleAxisd(-height, Eigen::Vector3d::UnitY()));
    T.translate(Eigen::Vector3d(kRadius, 0, 0));
    poses.push_back(T);
  }
  return poses;
}

PoseGraphEdge Measured(const std::vector<Eigen::Isometry3d>& poses, size_t from, size_t to, Random& random) {
  Vector6d noise, sigmas;
  sigmas << Eigen::Vector3d::Constant(kRotationNoise), Eigen::Vector3d::Constant(kTranslationNoise);
  for (int i = 0; i < 6; ++i) noise[i] = random.Normal(0, sigmas[i]);
  return {from, to, poses[from].inverse() * poses[to] * ExpSE3(noise),
          sigmas.cwiseAbs2().cwiseInverse().asDiagonal()};
}

Contender GraphContender(const std::string& name, size_t poses) {
  const auto graph = std::make_shared<const PoseGraph>(NoisySphere(poses));
  Contender contender = MicroContender(name, 1, [graph] { SolvePoseGraph(*graph, {}); });
  contender.every = 1 + poses / 500;  // a big one in every few turns is enough
  return contender;
}

}  // namespace

PoseGraph NoisySphere(size_t poses) {
  const auto per_turn = static_cast<size_t>(std::lround(std::sqrt(static_cast<double>(poses))));
  const std::vector<Eigen::Isometry3d> truth = TruePoses(poses, per_turn);
  Random random(1);
  PoseGraph graph;
  graph.poses.push_back(truth.front());
  for (size_t i = 1; i < poses; ++i) {
    graph.edges.push_back(Measured(truth, i - 1, i, random));
    graph.poses.push_back(graph.poses.back() * graph.edges.back().T_from_to);
  }
  for (size_t i = per_turn; i < poses; ++i) graph.edges.push_back(Measured(truth, i - per_turn, i, random));
  return graph;
}

std::vector<MicroBenchmark> PoseGraphBenchmarks(const MicroSetup& setup) {
  std::vector<MicroBenchmark> benchmarks;
  for (const size_t poses : setup.pose_graphs) {
    const std::string size = std::to_string(poses);
    benchmarks.push_back({"pose_graph", size,
                          "one pose graph of so many poses on a sphere, from noisy odometry to convergence, "
                          "choosing the start included",
                          [=] { return GraphContender("pose_graph:" + size, poses); }});
  }
  return benchmarks;
}

}  // namespace armature
