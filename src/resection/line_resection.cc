// SPDX-License-Identifier: BSD-3-Clause
#include "resection/line_resection.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "geometry/rotation.h"
#include "resection/normal_equations.h"
#include "resection/resection_problem.h"
#include "resection/resection_solver.h"

namespace armature {
namespace {

// Pixels: a segment of this length has full weight, shorter ones less; tuned on office_dev and redkitchen_a.
constexpr double kFullLength = 60;

// The line through a segment in pixels, a^2 + b^2 = 1.
Eigen::Vector3d LineThrough(const Segment& segment) {
  const Eigen::Vector2d d = (segment.p2 - segment.p1).normalized();
  return {-d.y(), d.x(), d.y() * segment.p1.x() - d.x() * segment.p1.y()};
}

// Position s of the edge's point whose image is nearest to the pixel, kept within the edge.
double PositionOnEdge(const ProjectedEdge& edge, const Eigen::Vector2d& pixel) {
  const double along = edge.direction.dot(pixel - edge.line.p1) / edge.length;
  const double t = std::clamp(along, 0.0, 1.0);
  const double inverse_z = edge.inverse_z1 + t * (edge.inverse_z2 - edge.inverse_z1);
  return edge.s1 + (edge.s2 - edge.s1) * t * edge.inverse_z2 / inverse_z;
}

void AddMatches(const std::vector<EdgeMatch>& matches, const ProjectedWireframe& projected,
                const ResectionOptions& options, ResectionProblem& problem) {
  for (const EdgeMatch& match : matches) {
    const ProjectedEdge& edge = projected.edges[static_cast<size_t>(match.edge)];
    if (edge.length <= 0) continue;
    const Eigen::Vector3d line = LineThrough(match.segment);
    const double weight = std::sqrt(std::min(1.0, match.segment.length() / kFullLength));
    const double sigma = std::hypot(options.segment_sigma, edge.slack);
    for (const Eigen::Vector2d& end : {match.segment.p1, match.segment.p2}) {
      ShapePoint point = PointOnEdge(*problem.model, match.edge, PositionOnEdge(edge, end));
      point.X0.y() -= edge.drop;
      problem.line_terms.push_back({point, line, weight / sigma, kSegmentLossScale, false});
    }
  }
}

// |N . R D|^2 + |N . (R M + T)|^2 is half the sum of the squared distances of M + D and M - D from the plane.
void AddPlanes(const std::vector<EdgeMatch>& matches, double weight, ResectionProblem& problem) {
  constexpr double kNotRobust = std::numeric_limits<double>::infinity();
  for (const EdgeMatch& match : matches) {
    const Eigen::Vector3d normal =
        problem.camera->Ray(match.segment.p1).cross(problem.camera->Ray(match.segment.p2)).normalized();
    for (const double s : {-1.0, 1.0}) {
      const ShapePoint point = PointOnEdge(*problem.model, match.edge, s);
      problem.plane_terms.push_back({point, normal, 0, weight * std::sqrt(0.5), kNotRobust});
    }
  }
}

// Edges that stand on the floor with their second end.
std::vector<int> Legs(const CategoryModel& model) {
  if (!model.spec.stands_on_floor) return {};
  constexpr double kFoot = 0.05;  // metres above the lowest end
  const auto feet = [&](int edge) { return model.mean(6 * edge + 1) + 0.5 * model.mean(6 * edge + 4); };
  double lowest = feet(0);
  for (int edge = 1; edge < model.spec.edges(); ++edge) lowest = std::min(lowest, feet(edge));
  std::vector<int> legs;
  for (int edge = 0; edge < model.spec.edges(); ++edge) {
    if (feet(edge) < lowest + kFoot && model.mean(6 * edge + 4) < 0) legs.push_back(edge);
  }
  return legs;
}

// Where segments on an edge end, of those that reach about as far as the edge does: the farthest of them.
std::optional<Eigen::Vector2d> FarthestEnd(const std::vector<EdgeMatch>& matches, int index,
                                           const ProjectedEdge& edge, double tolerance) {
  std::optional<Eigen::Vector2d> farthest;
  double reach = edge.length - tolerance;
  for (const EdgeMatch& match : matches) {
    if (match.edge != index) continue;
    for (const Eigen::Vector2d& end : {match.segment.p1, match.segment.p2}) {
      const double along = edge.direction.dot(end - edge.line.p1);
      if (along > edge.length + tolerance) return std::nullopt;  // it goes on: not this object's alone
      if (along <= reach) continue;
      reach = along;
      farthest = end;
    }
  }
  return farthest;
}

// A leg's segments end where the leg does. Lines alone say nothing of how long an edge is, and a leg's length
// is what the metric scale comes from: a seat is 0.45 m above the floor. Segments that end early - many are
// fragments - are outliers: the loss is narrow. Only for poses that are nearly right.
void AddLegEnds(const std::vector<EdgeMatch>& matches, const ProjectedWireframe& projected,
                const ResectionOptions& options, ResectionProblem& problem) {
  constexpr double kLegEndLoss = 1;  // standard deviations
  if (options.leg_end_sigma <= 0) return;
  const double sigma = options.leg_end_sigma * options.segment_sigma;
  for (const int leg : Legs(*problem.model)) {
    const ProjectedEdge& edge = projected.edges[static_cast<size_t>(leg)];
    if (edge.length <= 0 || edge.s2 < 0.5 - 1e-6) continue;  // its lower end is outside of the picture
    const auto end = FarthestEnd(matches, leg, edge, 2 * sigma);
    if (!end) continue;
    const Eigen::Vector3d line(edge.direction.x(), edge.direction.y(), -edge.direction.dot(*end));
    problem.line_terms.push_back(
        {PointOnEdge(*problem.model, leg, 0.5), line, 1 / sigma, kLegEndLoss, false});
  }
}

// Each side of the box is a line that the extreme point of the projection on that side should touch (seen
// sides) or reach (open sides).
void AddBox(const ObjectView& view, const BoxSides& sides, const ProjectedWireframe& projected,
            const BoxOptions& box_options, const ResectionOptions& options, ResectionProblem& problem) {
  if (options.box_weight <= 0) return;
  const Box& box = view.detection.box;
  const auto [sigma_x, sigma_y] = SideSigmas(box, box_options);
  const std::array<ExtremePoint, 4> extremes = Extremes(projected);
  const Eigen::Vector2d reach = ImagePadding(view.model->spec, problem.R0);
  // Signed so that the distance is positive where the projection falls short of the side.
  std::array<Eigen::Vector3d, 4> lines = {
      Eigen::Vector3d(1, 0, -box.left()), Eigen::Vector3d(0, 1, -box.top()),
      Eigen::Vector3d(-1, 0, box.right()), Eigen::Vector3d(0, -1, box.bottom())};
  for (size_t side = 0; side < 4; ++side) {
    if (extremes[side].edge < 0) continue;
    const ShapePoint point = PointOnEdge(*problem.model, extremes[side].edge, extremes[side].s);
    lines[side].z() -=
        reach(static_cast<Eigen::Index>(side % 2)) * view.camera->fx * extremes[side].inverse_z;
    const double sigma = side % 2 == 0 ? sigma_x : sigma_y;
    problem.line_terms.push_back({point, lines[side], options.box_weight / sigma, options.box_loss_scale,
                                  sides[side] == BoxSide::kOpen});
  }
}

// The object's lowest end of an edge touches the floor: -up . P = camera height.
void AddFloor(const ObjectView& view, const PoseAndShape& start, ResectionProblem& problem) {
  if (!view.floor || !view.up_camera || !view.model->spec.stands_on_floor) return;
  problem.plane_terms.push_back({LowestPoint(*view.model, start.coefficients), *view.up_camera,
                                 view.floor->camera_height, 1 / view.floor->sigma, 3.0});
}

ResectionProblem MakeProblem(const ResectionInput& input) {
  const auto& [view, sides, matches, projected, at, box, options] = input;
  ResectionProblem problem;
  problem.camera = view.camera;
  problem.model = view.model;
  problem.R0 = at.T_camera_object.linear();
  problem.T0 = at.T_camera_object.translation();
  problem.shape_weight = options.shape_weight;
  if (view.track_prior) problem.track_prior = &*view.track_prior;
  if (view.up_camera) {
    problem.normal_term = options.normal_term;
    problem.up_camera = *view.up_camera;
    problem.up_weight = 1 / (options.up_sigma_deg * kDegree);
  } else {
    problem.normal_term = NormalTerm::kNone;
  }
  problem.line_terms.reserve(2 * matches.size() + 4);
  if (options.line_term == LineTerm::kPlanes) {
    AddPlanes(matches, 1 / (options.up_sigma_deg * kDegree), problem);
  } else {
    AddMatches(matches, projected, options, problem);
  }
  AddBox(view, sides, projected, box, options, problem);
  AddFloor(view, at, problem);
  return problem;
}

// The paper's turns: pose with the shape held (eq. 24), then shape with the pose held (eq. 25).
SolverResult SolveAlternating(ResectionProblem& problem, const SolverOptions& options, Eigen::VectorXd& x,
                              int alternations) {
  SolverResult result;
  for (int turn = 0; turn < alternations; ++turn) {
    for (const bool pose : {true, false}) {
      problem.pose_is_free = pose;
      problem.shape_is_free = !pose;
      const SolverResult half = SolveResectionWithCeres(problem, options, x);
      result = {half.cost, result.iterations + half.iterations, half.stop};
    }
  }
  return result;
}

SolverResult Solve(ResectionProblem& problem, const ResectionOptions& options, Eigen::VectorXd& x) {
  const SolverOptions solver{.max_iterations = options.max_iterations};
  if (options.mode == ResectionMode::kAlternating)
    return SolveAlternating(problem, solver, x, options.alternations);
  if (options.solver == ResectionSolver::kCeres) return SolveResectionWithCeres(problem, solver, x);
  return SolveResection(problem, solver, x);
}

// The problem's unknowns at its own pose and the given shape.
Eigen::VectorXd UnknownsAt(const ResectionProblem& problem, const Eigen::VectorXd& coefficients) {
  Eigen::VectorXd x = Eigen::VectorXd::Zero(problem.NumParameters());
  x.tail(problem.Modes()) = coefficients;
  return x;
}

// Of all unknowns at the problem's own pose and the given shape.
Eigen::MatrixXd Covariance(const ResectionProblem& problem, const Eigen::VectorXd& coefficients) {
  const Eigen::VectorXd x = UnknownsAt(problem, coefficients);
  Eigen::MatrixXd information = Linearise<Eigen::Dynamic>(problem, x.data()).information;
  // A direction of the pose that nothing observes gets a large but finite variance: 1 rad, 10 m.
  information.diagonal().head<3>().array() += 1.0;
  information.diagonal().segment<3>(3).array() += 0.01;
  return information.ldlt().solve(Eigen::MatrixXd::Identity(x.size(), x.size()));
}

// Eq. 28: the pose and shape that were found, as sure as eqs. 24 and 25 leave them without the statistics.
ImageEvidence EvidenceOfEstimate(const ResectionInput& input) {
  ResectionProblem problem = MakeProblem(input);
  problem.shape_weight = 0;
  const Eigen::VectorXd x = UnknownsAt(problem, input.at.coefficients);
  return {Linearise<Eigen::Dynamic>(problem, x.data()).information, Eigen::VectorXd::Zero(x.size())};
}

}  // namespace

ResectionResult ResectFrom(ResectionProblem& problem, const Eigen::VectorXd& coefficients,
                           const ResectionOptions& options) {
  Eigen::VectorXd x = UnknownsAt(problem, coefficients);
  const SolverResult solved = Solve(problem, options, x);
  ResectionResult result;
  result.iterations = solved.iterations;
  result.cost = solved.cost;
  result.stop = x.allFinite() ? solved.stop : StopReason::kNotFinite;
  result.estimate.T_camera_object.linear() = ExpSO3(x.head<3>()) * problem.R0;
  result.estimate.T_camera_object.translation() = problem.T0 + x.segment<3>(3);
  result.estimate.coefficients = x.tail(problem.Modes());
  return result;
}

ResectionResult Resect(const ResectionInput& input) {
  ResectionProblem problem = MakeProblem(input);
  return ResectFrom(problem, input.at.coefficients, input.options);
}

Eigen::Matrix<double, 6, 6> PoseCovariance(const ResectionInput& input) {
  return Covariance(MakeProblem(input), input.at.coefficients).topLeftCorner<6, 6>();
}

Measurement MeasurementAt(const ResectionInput& optimum) {
  const ResectionProblem problem = MakeProblem(optimum);
  return {optimum.at, Covariance(problem, optimum.at.coefficients),
          problem.shape_weight * problem.shape_weight};
}

ImageEvidence EvidenceAt(const ResectionInput& input) {
  if (input.options.line_term == LineTerm::kPlanes) return EvidenceOfEstimate(input);
  const auto& [view, sides, matches, projected, at, box, options] = input;
  ResectionProblem problem;
  problem.camera = view.camera;
  problem.model = view.model;
  problem.R0 = at.T_camera_object.linear();
  problem.T0 = at.T_camera_object.translation();
  problem.normal_term = NormalTerm::kNone;
  problem.shape_weight = 0;
  AddMatches(matches, projected, options, problem);
  AddLegEnds(matches, projected, options, problem);
  AddBox(view, sides, projected, box, options, problem);
  const Eigen::VectorXd x = UnknownsAt(problem, at.coefficients);
  const auto equations = Linearise<Eigen::Dynamic>(problem, x.data());
  return {equations.information, equations.gradient};
}

}  // namespace armature
