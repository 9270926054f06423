// SPDX-License-Identifier: BSD-3-Clause
#include "mapping/map_solver.h"

#include <ceres/ceres.h>
#include <ceres/crs_matrix.h>
#include <ceres/normal_prior.h>

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "geometry/rotation.h"
#include "mapping/interruptible_solve.h"
#include "mapping/map_factors.h"
#include "mapping/one_thread.h"
#include "mapping/pose_block.h"
#include "mapping/supports.h"
#include "resection/resection_problem.h"

namespace armature {
namespace {

// Of the scale's logarithm: what the front end has learnt is never surer, its views' errors are alike.
constexpr double kLeastExpectedSigma = 0.1;
// Standard deviations, of the Cauchy loss on sizes: some furniture is of another kind, as coffee tables.
constexpr double kSizeLossScale = 2;
// The same on what stands on what: books may lie between, or it is over the table and not on it.
constexpr double kSupportLossScale = 2;

// The mean height along up of what the objects stand on, metres.
double FloorBelow(const MapGraph& graph) {
  double sum = 0, count = 0;
  for (const GraphObject& object : graph.objects) {
    if (!object.model->spec.stands_on_floor) continue;
    const ShapePoint lowest = LowestPoint(*object.model, object.coefficients);
    sum += graph.up_world.dot(object.T_world_object *
                              (std::exp(object.log_size) * (lowest.X0 + lowest.G * object.coefficients)));
    ++count;
  }
  return count > 0 ? sum / count : 0;
}

// The unknowns as Ceres sees them.
struct Blocks {
  std::vector<PoseBlock> cameras, objects;
  std::vector<Eigen::VectorXd> shapes;
  std::vector<double> log_size, log_scale;
  Eigen::Vector3d up;
  double floor = 0;  // metres, along up

  explicit Blocks(const MapGraph& graph) : log_scale(graph.log_scale), up(graph.up_world) {
    for (const Eigen::Isometry3d& pose : graph.T_world_camera) cameras.push_back(ToBlock(pose));
    for (const GraphObject& object : graph.objects) {
      objects.push_back(ToBlock(object.T_world_object));
      shapes.push_back(object.coefficients);
      log_size.push_back(object.log_size);
    }
    floor = FloorBelow(graph);
  }
};

void AddOdometry(const MapGraph& graph, const MapSolverOptions& options, Blocks& blocks,
                 ceres::Problem& problem) {
  for (const OdometryFactor& factor : graph.odometry) {
    const auto knot = static_cast<size_t>(factor.knot);
    problem.AddResidualBlock(new OdometryCost(factor), nullptr,
                             blocks.cameras[static_cast<size_t>(factor.from)].data(),
                             blocks.cameras[static_cast<size_t>(factor.to)].data(), &blocks.log_scale[knot],
                             &blocks.log_scale[knot + 1]);
  }
  for (PoseBlock& camera : blocks.cameras) problem.AddParameterBlock(camera.data(), 7, new PoseManifold);
  problem.SetParameterBlockConstant(blocks.cameras.front().data());
  if (graph.cameras_are_held) {
    for (PoseBlock& camera : blocks.cameras) problem.SetParameterBlockConstant(camera.data());
  }
  for (double& value : blocks.log_scale) {
    problem.AddParameterBlock(&value, 1);
    if (graph.scale_is_held) problem.SetParameterBlockConstant(&value);
  }
  for (size_t k = 0; k < blocks.log_scale.size(); ++k) {
    // Together, the knots' priors weigh as one.
    const double sigma = std::max(graph.expected_scale.sigma, kLeastExpectedSigma) *
                         std::sqrt(static_cast<double>(blocks.log_scale.size()));
    const Eigen::Matrix<double, 1, 1> weight(1 / sigma), mean(std::log(graph.expected_scale.scale));
    problem.AddResidualBlock(new ceres::NormalPrior(weight, mean), nullptr, &blocks.log_scale[k]);
    if (k > 0) {
      problem.AddResidualBlock(new RandomWalkCost(options.scale_drift_sigma), nullptr,
                               &blocks.log_scale[k - 1], &blocks.log_scale[k]);
    }
  }
}

void AddObjects(const MapGraph& graph, const MapSolverOptions& options, Blocks& blocks,
                ceres::Problem& problem) {
  const Eigen::Matrix3d up_weight = Eigen::Matrix3d::Identity() / graph.up_sigma;
  problem.AddParameterBlock(blocks.up.data(), 3, new ceres::SphereManifold<3>);
  problem.AddResidualBlock(new ceres::NormalPrior(up_weight, graph.up_world), nullptr, blocks.up.data());
  for (size_t o = 0; o < blocks.objects.size(); ++o) {
    double *pose = blocks.objects[o].data(), *shape = blocks.shapes[o].data();
    const auto modes = blocks.shapes[o].size();
    problem.AddParameterBlock(pose, 7, new PoseManifold);
    const Eigen::MatrixXd shape_weight = options.shape_weight * Eigen::MatrixXd::Identity(modes, modes);
    problem.AddResidualBlock(new ceres::NormalPrior(shape_weight, Eigen::VectorXd::Zero(modes)), nullptr,
                             shape);
    problem.AddParameterBlock(&blocks.log_size[o], 1);
    if (graph.sizes_are_held) {
      problem.SetParameterBlockConstant(&blocks.log_size[o]);
    } else {
      const Eigen::Matrix<double, 1, 1> weight(1 / graph.objects[o].model->spec.size_sigma), mean(0.0);
      problem.AddResidualBlock(new ceres::NormalPrior(weight, mean), new ceres::CauchyLoss(kSizeLossScale),
                               &blocks.log_size[o]);
    }
    if (options.upright_sigma_deg > 0) {
      problem.AddResidualBlock(new UprightCost(options.upright_sigma_deg * kDegree), nullptr, pose,
                               blocks.up.data());
    }
    if (options.floor_sigma > 0 && graph.objects[o].model->spec.stands_on_floor) {
      problem.AddResidualBlock(new FloorCost(graph.objects[o], options.floor_sigma), nullptr, pose, shape,
                               &blocks.log_size[o], blocks.up.data(), &blocks.floor);
    }
  }
}

// After objects and up have been added.
void AddSupports(const MapGraph& graph, const MapSolverOptions& options, Blocks& blocks,
                 ceres::Problem& problem) {
  if (options.floor_sigma <= 0) return;
  for (const Support& support : FindSupports(graph)) {
    const auto object = static_cast<size_t>(support.object), on = static_cast<size_t>(support.on);
    problem.AddResidualBlock(
        new SupportCost(graph.objects[object], graph.objects[on], support.face, options.floor_sigma),
        new ceres::CauchyLoss(kSupportLossScale), blocks.objects[object].data(), blocks.shapes[object].data(),
        &blocks.log_size[object], blocks.objects[on].data(), blocks.shapes[on].data(), &blocks.log_size[on],
        blocks.up.data());
  }
}

// After up has been added.
void AddHeights(const MapGraph& graph, const MapSolverOptions& options, Blocks& blocks,
                ceres::Problem& problem) {
  if (options.floor_sigma <= 0) return;
  for (const HeightFactor& factor : graph.heights) {
    problem.AddResidualBlock(new HeightCost(factor), nullptr,
                             blocks.cameras[static_cast<size_t>(factor.camera)].data(), blocks.up.data(),
                             &blocks.floor);
  }
}

void AddObservations(const MapGraph& graph, const MapSolverOptions& options, Blocks& blocks,
                     ceres::Problem& problem) {
  for (const ObjectFactor& factor : graph.observations) {
    const auto object = static_cast<size_t>(factor.object);
    const double scale = options.loss_scale * std::sqrt(static_cast<double>(factor.b.size()));
    problem.AddResidualBlock(new ObjectCost(factor), new ceres::CauchyLoss(scale),
                             blocks.cameras[static_cast<size_t>(factor.camera)].data(),
                             blocks.objects[object].data(), blocks.shapes[object].data(),
                             &blocks.log_size[object]);
  }
}

void Store(const Blocks& blocks, MapGraph& graph) {
  for (size_t i = 0; i < blocks.cameras.size(); ++i) {
    graph.T_world_camera[i] = FromBlock(blocks.cameras[i].data());
  }
  for (size_t o = 0; o < blocks.objects.size(); ++o) {
    graph.objects[o].T_world_object = FromBlock(blocks.objects[o].data());
    graph.objects[o].coefficients = blocks.shapes[o];
    graph.objects[o].log_size = blocks.log_size[o];
  }
  graph.log_scale = blocks.log_scale;
  graph.up_world = blocks.up;
}

ceres::Solver::Options MakeSolverOptions(const MapSolverOptions& options) {
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
  AddSupports(graph, options, blocks, problem);
  AddHeights(graph, options, blocks, problem);
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

// In an order of their own, the knots of the scale last. (Ceres' covariance orders blocks by address and
// leaves the arithmetic to BLAS: its last bits differ from run to run.)
std::vector<double*> FreeBlocks(Blocks& blocks, const ceres::Problem& problem) {
  std::vector<double*> all;
  for (PoseBlock& camera : blocks.cameras) all.push_back(camera.data());
  for (PoseBlock& object : blocks.objects) all.push_back(object.data());
  for (Eigen::VectorXd& shape : blocks.shapes) all.push_back(shape.data());
  for (double& value : blocks.log_size) all.push_back(&value);
  all.push_back(blocks.up.data());
  all.push_back(&blocks.floor);
  for (double& value : blocks.log_scale) all.push_back(&value);
  std::vector<double*> free;
  for (double* block : all) {
    if (problem.HasParameterBlock(block) && !problem.IsParameterBlockConstant(block)) free.push_back(block);
  }
  return free;
}

Eigen::SparseMatrix<double> EvaluateJacobian(ceres::Problem& problem, const std::vector<double*>& blocks) {
  ceres::Problem::EvaluateOptions evaluate;
  evaluate.parameter_blocks = blocks;
  ceres::CRSMatrix rows;
  problem.Evaluate(evaluate, nullptr, nullptr, nullptr, &rows);
  return Eigen::Map<const Eigen::SparseMatrix<double, Eigen::RowMajor>>(
      rows.num_rows, rows.num_cols, static_cast<Eigen::Index>(rows.values.size()), rows.rows.data(),
      rows.cols.data(), rows.values.data());
}

// (J^T J)^-1, a few columns of it at a time.
class InverseOfInformation {
 public:
  explicit InverseOfInformation(const Eigen::SparseMatrix<double>& J) : information_(J.transpose() * J) {}

  bool Exists() const {
    return information_.info() == Eigen::Success && information_.vectorD().minCoeff() > 0;
  }
  Eigen::VectorXd Times(const Eigen::VectorXd& vector) const { return information_.solve(vector); }

  // Rows and columns by their numbers; those of -1 are 0.
  Eigen::MatrixXd Block(const std::vector<Eigen::Index>& chosen) const {
    const auto n = static_cast<Eigen::Index>(chosen.size());
    Eigen::MatrixXd block = Eigen::MatrixXd::Zero(n, n);
    for (Eigen::Index j = 0; j < n; ++j) {
      if (chosen[static_cast<size_t>(j)] < 0) continue;
      const Eigen::VectorXd column =
          Times(Eigen::VectorXd::Unit(information_.cols(), chosen[static_cast<size_t>(j)]));
      for (Eigen::Index i = 0; i < n; ++i) {
        if (chosen[static_cast<size_t>(i)] >= 0) block(i, j) = column(chosen[static_cast<size_t>(i)]);
      }
    }
    return block;
  }

 private:
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> information_;
};

}  // namespace

MapSolution SolveMapGraph(MapGraph& graph, const MapSolverOptions& options) {
  Blocks blocks(graph);
  ceres::Problem problem;
  AddFactors(graph, options, blocks, problem);
  ceres::Solver::Summary summary;
  StopAfterSteps stop(options.max_iterations);
  ceres::Solver::Options solver = MakeSolverOptions(options);
  solver.callbacks.push_back(&stop);
  const OneThread one_thread;
  SolveUnlessInterrupted(solver, &problem, &summary);
  const bool usable = summary.IsSolutionUsable();
  if (usable) Store(blocks, graph);
  return {summary.initial_cost, usable ? summary.final_cost : summary.initial_cost,
          static_cast<int>(summary.iterations.size()) - 1};  // the first is the start
}

std::optional<GraphUncertainty> ComputeUncertainty(const MapGraph& graph, const MapSolverOptions& options) {
  Blocks blocks(graph);
  ceres::Problem problem;
  AddFactors(graph, options, blocks, problem);
  const std::vector<double*> free = FreeBlocks(blocks, problem);
  const Eigen::SparseMatrix<double> J = EvaluateJacobian(problem, free);
  const InverseOfInformation inverse(J);
  if (!inverse.Exists()) return std::nullopt;
  GraphUncertainty uncertainty;
  if (!graph.scale_is_held) {
    // The scale's knots are the last columns: the mean's variance is w^T (J^T J)^-1 w.
    const auto knots = static_cast<Eigen::Index>(blocks.log_scale.size());
    Eigen::VectorXd w = Eigen::VectorXd::Zero(J.cols());
    w.tail(knots).setConstant(1 / static_cast<double>(knots));
    uncertainty.scale_sigma = std::sqrt(w.dot(inverse.Times(w)));
  }
  std::map<const double*, std::pair<Eigen::Index, int>> columns;  // of each free block: the first, how many
  Eigen::Index next = 0;
  for (double* block : free) {
    const int size = problem.ParameterBlockTangentSize(block);
    columns[block] = {next, size};
    next += size;
  }
  for (size_t o = 0; o < blocks.objects.size(); ++o) {
    const Eigen::Index modes = blocks.shapes[o].size();
    std::vector<Eigen::Index> of_object(static_cast<size_t>(7 + modes), -1);  // -1: held
    Eigen::Index at = 0;
    for (const auto& [block, size] : {std::pair<const double*, Eigen::Index>{blocks.objects[o].data(), 6},
                                      {blocks.shapes[o].data(), modes},
                                      {&blocks.log_size[o], 1}}) {
      const auto found = columns.find(block);
      for (Eigen::Index k = 0; k < size; ++k, ++at) {
        if (found != columns.end()) of_object[static_cast<size_t>(at)] = found->second.first + k;
      }
    }
    uncertainty.objects.push_back(inverse.Block(of_object));
  }
  return uncertainty;
}

}  // namespace armature
