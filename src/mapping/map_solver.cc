// SPDX-License-Identifier: BSD-3-Clause
#include "mapping/map_solver.h"

#include <ceres/ceres.h>
#include <ceres/normal_prior.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "geometry/rotation.h"
#include "mapping/map_factors.h"
#include "mapping/one_thread.h"
#include "mapping/pose_block.h"

namespace armature {
namespace {

// The mean height along up of what the objects stand on, metres.
double FloorBelow(const MapGraph& graph) {
  double sum = 0, count = 0;
  for (const GraphObject& object : graph.objects) {
    if (!object.model->spec.stands_on_floor) continue;
    const ShapePoint lowest = LowestPoint(object);
    sum += graph.up_world.dot(object.T_world_object * (lowest.X0 + lowest.G * object.coefficients));
    ++count;
  }
  return count > 0 ? sum / count : 0;
}

// The unknowns as Ceres sees them. In one piece of memory: its covariance orders blocks by address, and so
// rounds alike in every run.
class Blocks {
 public:
  std::vector<double*> cameras, objects, shapes, log_scale;
  double* up = nullptr;
  double* floor = nullptr;  // metres, along up

  explicit Blocks(const MapGraph& graph) {
    size_t size = 7 * graph.T_world_camera.size() + graph.log_scale.size() + 3 + 1;
    for (const GraphObject& object : graph.objects)
      size += 7 + static_cast<size_t>(object.coefficients.size());
    values_.reserve(size);
    for (const Eigen::Isometry3d& pose : graph.T_world_camera) cameras.push_back(Append(ToBlock(pose)));
    for (const GraphObject& object : graph.objects) {
      objects.push_back(Append(ToBlock(object.T_world_object)));
      shapes.push_back(Append(object.coefficients));
    }
    for (const double value : graph.log_scale)
      log_scale.push_back(Append(Eigen::Matrix<double, 1, 1>(value)));
    up = Append(graph.up_world);
    floor = Append(Eigen::Matrix<double, 1, 1>(FloorBelow(graph)));
  }
  Blocks(const Blocks&) = delete;
  Blocks& operator=(const Blocks&) = delete;

 private:
  double* Append(const Eigen::VectorXd& block) {
    values_.insert(values_.end(), block.begin(), block.end());
    return values_.data() + values_.size() - block.size();
  }

  std::vector<double> values_;  // never grows beyond what was reserved
};

void AddOdometry(const MapGraph& graph, const MapSolverOptions& options, Blocks& blocks,
                 ceres::Problem& problem) {
  for (const OdometryFactor& factor : graph.odometry) {
    const auto knot = static_cast<size_t>(factor.knot);
    problem.AddResidualBlock(
        new OdometryCost(factor), nullptr, blocks.cameras[static_cast<size_t>(factor.from)],
        blocks.cameras[static_cast<size_t>(factor.to)], blocks.log_scale[knot], blocks.log_scale[knot + 1]);
  }
  for (double* camera : blocks.cameras) problem.AddParameterBlock(camera, 7, new PoseManifold);
  problem.SetParameterBlockConstant(blocks.cameras.front());
  if (graph.cameras_are_held) {
    for (double* camera : blocks.cameras) problem.SetParameterBlockConstant(camera);
  }
  for (double* value : blocks.log_scale) {
    problem.AddParameterBlock(value, 1);
    if (graph.scale_is_held) problem.SetParameterBlockConstant(value);
  }
  for (size_t k = 0; k < blocks.log_scale.size(); ++k) {
    // Together, the knots' priors weigh as one.
    const double sigma = std::max(graph.expected_scale.sigma, options.min_scale_sigma) *
                         std::sqrt(static_cast<double>(blocks.log_scale.size()));
    const Eigen::Matrix<double, 1, 1> weight(1 / sigma), mean(std::log(graph.expected_scale.scale));
    problem.AddResidualBlock(new ceres::NormalPrior(weight, mean), nullptr, blocks.log_scale[k]);
    if (k > 0) {
      problem.AddResidualBlock(new RandomWalkCost(options.scale_drift_sigma), nullptr,
                               blocks.log_scale[k - 1], blocks.log_scale[k]);
    }
  }
}

void AddObjects(const MapGraph& graph, const MapSolverOptions& options, Blocks& blocks,
                ceres::Problem& problem) {
  const Eigen::Matrix3d up_weight = Eigen::Matrix3d::Identity() / graph.up_sigma;
  problem.AddParameterBlock(blocks.up, 3, new ceres::SphereManifold<3>);
  problem.AddResidualBlock(new ceres::NormalPrior(up_weight, graph.up_world), nullptr, blocks.up);
  for (size_t o = 0; o < blocks.objects.size(); ++o) {
    double *pose = blocks.objects[o], *shape = blocks.shapes[o];
    const Eigen::Index modes = graph.objects[o].coefficients.size();
    problem.AddParameterBlock(pose, 7, new PoseManifold);
    const Eigen::MatrixXd shape_weight = options.shape_weight * Eigen::MatrixXd::Identity(modes, modes);
    problem.AddResidualBlock(new ceres::NormalPrior(shape_weight, Eigen::VectorXd::Zero(modes)), nullptr,
                             shape);
    if (options.upright_sigma_deg > 0) {
      problem.AddResidualBlock(new UprightCost(options.upright_sigma_deg * kDegree), nullptr, pose,
                               blocks.up);
    }
    if (options.floor_sigma > 0 && graph.objects[o].model->spec.stands_on_floor) {
      problem.AddResidualBlock(new FloorCost(graph.objects[o], options.floor_sigma), nullptr, pose, shape,
                               blocks.up, blocks.floor);
    }
  }
}

void AddObservations(const MapGraph& graph, const MapSolverOptions& options, Blocks& blocks,
                     ceres::Problem& problem) {
  for (const ObjectFactor& factor : graph.observations) {
    const auto object = static_cast<size_t>(factor.object);
    const double scale = options.loss_scale * std::sqrt(static_cast<double>(factor.b.size()));
    problem.AddResidualBlock(new ObjectCost(factor), new ceres::CauchyLoss(scale),
                             blocks.cameras[static_cast<size_t>(factor.camera)], blocks.objects[object],
                             blocks.shapes[object]);
  }
}

void Store(const Blocks& blocks, MapGraph& graph) {
  for (size_t i = 0; i < blocks.cameras.size(); ++i) {
    graph.T_world_camera[i] = FromBlock(blocks.cameras[i]);
  }
  for (size_t o = 0; o < blocks.objects.size(); ++o) {
    graph.objects[o].T_world_object = FromBlock(blocks.objects[o]);
    Eigen::VectorXd& coefficients = graph.objects[o].coefficients;
    coefficients = Eigen::Map<const Eigen::VectorXd>(blocks.shapes[o], coefficients.size());
  }
  for (size_t k = 0; k < blocks.log_scale.size(); ++k) graph.log_scale[k] = *blocks.log_scale[k];
  graph.up_world = Eigen::Map<const Eigen::Vector3d>(blocks.up);
}

ceres::Solver::Options SolverOptions(const MapSolverOptions& options) {
  ceres::Solver::Options solver;
  solver.linear_solver_type = ceres::SPARSE_NORMAL_CHOLESKY;
  solver.max_num_iterations = 2 * options.max_iterations + 10;
  solver.initial_trust_region_radius = 1e6;
  solver.function_tolerance = 1e-5;
  solver.num_threads = 1;
  solver.logging_type = ceres::SILENT;
  return solver;
}

void AddFactors(const MapGraph& graph, const MapSolverOptions& options, Blocks& blocks,
                ceres::Problem& problem) {
  AddOdometry(graph, options, blocks, problem);
  AddObjects(graph, options, blocks, problem);
  AddObservations(graph, options, blocks, problem);
}

// Ends the solution after some steps that were taken; Ceres itself counts those it tried and took back, too.
class StopAfterSteps : public ceres::IterationCallback {
 public:
  explicit StopAfterSteps(int steps) : left_(steps) {}
  ceres::CallbackReturnType operator()(const ceres::IterationSummary& summary) override {
    if (summary.iteration > 0 && summary.step_is_successful) --left_;
    return left_ > 0 ? ceres::SOLVER_CONTINUE : ceres::SOLVER_TERMINATE_SUCCESSFULLY;
  }

 private:
  int left_;
};

}  // namespace

MapSolution SolveMapGraph(MapGraph& graph, const MapSolverOptions& options) {
  Blocks blocks(graph);
  ceres::Problem problem;
  AddFactors(graph, options, blocks, problem);
  ceres::Solver::Summary summary;
  StopAfterSteps stop(options.max_iterations);
  ceres::Solver::Options solver = SolverOptions(options);
  solver.callbacks.push_back(&stop);
  const OneThread one_thread;
  ceres::Solve(solver, &problem, &summary);
  const bool usable = summary.IsSolutionUsable();
  if (usable) Store(blocks, graph);
  return {summary.initial_cost, usable ? summary.final_cost : summary.initial_cost,
          static_cast<int>(summary.iterations.size()) - 1};  // the first is the start
}

std::optional<double> ScaleSigma(const MapGraph& graph, const MapSolverOptions& options) {
  if (graph.scale_is_held) return std::nullopt;
  Blocks blocks(graph);
  ceres::Problem problem;
  AddFactors(graph, options, blocks, problem);
  std::vector<std::pair<const double*, const double*>> pairs;
  for (const double* a : blocks.log_scale) {
    for (const double* b : blocks.log_scale) {
      if (a <= b) pairs.emplace_back(a, b);
    }
  }
  const OneThread one_thread;
  ceres::Covariance covariance{ceres::Covariance::Options()};
  if (!covariance.Compute(pairs, &problem)) return std::nullopt;
  double sum = 0;
  for (const auto& [a, b] : pairs) {
    double value = 0;
    covariance.GetCovarianceBlock(a, b, &value);
    sum += a == b ? value : 2 * value;
  }
  return std::sqrt(sum) / static_cast<double>(blocks.log_scale.size());
}

}  // namespace armature
