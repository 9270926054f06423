// SPDX-License-Identifier: BSD-3-Clause
#include "retrieval/instance_fit.h"

#include <cmath>

#include "association/matching.h"
#include "geometry/rotation.h"

namespace armature {
namespace {

constexpr double kScoreGate = 4;  // pixels, of the matches that count in the end

MapGraph MakeGraph(const ObjectSightings& sightings, const CategoryModel& model) {
  MapGraph graph;
  graph.T_world_camera = sightings.T_world_camera;
  graph.cameras_are_held = true;
  graph.scale_is_held = true;
  graph.up_world = sightings.up_world;
  graph.up_sigma = 1e-3;
  graph.objects.push_back({&model, sightings.T_world_object, Eigen::VectorXd::Zero(1)});
  return graph;
}

// The frames with the instance's model instead of the category's.
std::vector<MapFrame> FramesWith(const CategoryModel& model, std::vector<MapFrame> frames) {
  for (MapFrame& frame : frames) frame.observations.front().view.model = &model;
  return frames;
}

double ViewCost(const ObjectView& view, const PoseAndShape& at, const Wireframe& wireframe,
                const InstanceFitOptions& options) {
  ProjectedWireframe projected;
  ProjectWireframe(*view.camera, view.model->spec, wireframe, at.T_camera_object,
                   ClipBox(view.detection.box, view.sides, *view.camera), view.occluders, projected);
  const MatchGate gate{kScoreGate, kRefinementAngleDeg * kDegree};
  return LineCost(projected, MatchSegments(projected, view.segments, gate).covered_length) +
         PriorCost(view, at, wireframe, view.sides, projected, options.box, options.cost);
}

}  // namespace

CategoryModel MakeInstanceModel(const CategorySpec& spec, const Wireframe& wireframe, double size_sigma) {
  CategoryModel model;
  model.spec = spec;
  model.mean = ShapeVector(wireframe);
  model.basis = model.mean.normalized();
  model.standard_deviations = Eigen::VectorXd::Constant(1, size_sigma * model.mean.norm());
  return model;
}

InstanceFit FitInstance(const ObjectSightings& sightings, const CategorySpec& spec,
                        const Wireframe& wireframe, double size_sigma, const InstanceFitOptions& options) {
  const double sigma = std::hypot(size_sigma, options.size_sigma);
  const CategoryModel model = MakeInstanceModel(spec, wireframe, sigma);
  const std::vector<MapFrame> frames = FramesWith(model, sightings.frames);
  const ObjectOfObservation phi(frames.size(), {0});
  MapGraph graph = MakeGraph(sightings, model);
  MapSolverOptions solver = options.solver;
  solver.max_iterations = kRefinementSteps;
  solver.shape_weight = 1;  // the sigma of the only mode, its size, is as it is given
  for (int round = 0; round < options.refinement.rounds; ++round) {
    Relinearise(frames, phi, round, options.box, options.resection, options.refinement, graph);
    SolveMapGraph(graph, solver);
  }
  const GraphObject& object = graph.objects.front();
  const Wireframe fitted = WireframeFromCoefficients(model, object.coefficients);
  InstanceFit fit{0, object.T_world_object, 1 + sigma * object.coefficients(0)};
  for (size_t i = 0; i < frames.size(); ++i) {
    const PoseAndShape at{graph.T_world_camera[i].inverse() * object.T_world_object,
                          Eigen::VectorXd::Zero(1)};
    fit.cost += ViewCost(frames[i].observations.front().view, at, fitted, options);
  }
  fit.cost /= static_cast<double>(frames.size());
  return fit;
}

}  // namespace armature
