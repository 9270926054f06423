// SPDX-License-Identifier: BSD-3-Clause
#include "mapping/estimate_over_views.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "association/hypothesis_cost.h"
#include "association/matching.h"
#include "geometry/rotation.h"
#include "geometry/viewpoint.h"
#include "mapping/map_objects.h"

namespace armature {
namespace {

constexpr size_t kMostViews = 10;  // that are asked, evenly over all
constexpr double kYawStep = 15 * kDegree;
// Of the distance from the cameras' middle that the boxes leave: with little between the views, they hardly
// tell it.
constexpr std::array kDistanceFactors{1.0, 0.88, 1.14};
constexpr size_t kMostRefined = 6;
constexpr double kAlikeTurn = 20 * kDegree, kAlikeWay = 0.1;  // metres: of these only the best is refined
constexpr int kBoxSteps = 2, kRefiningRounds = 5, kStepsARound = 2;

constexpr double kCoarseGate = 0.06, kFineGate = 4;  // of the box's diagonal; pixels
constexpr double kCoarseAngle = 10 * kDegree, kFineAngle = 6 * kDegree;

constexpr double kShapeWeight = 0.15, kViewsOfShape = 3;  // the shape costs once, not in each view
constexpr double kPruneMargin = 3;                        // above the best, a view
constexpr double kUprightSigma = 1.5 * kDegree;
constexpr double kMostShape = 3;                                            // standard deviations
constexpr double kLongestTurn = 0.3, kLongestWay = 0.4, kLongestShape = 2;  // of a step: rad, m, sigmas
constexpr double kNearestObject = 0.2;                                      // metres before the camera

struct ViewOfObject {
  const ObjectView& view;
  Eigen::Isometry3d T_camera_world;
  std::vector<ImageFace> occluders;
};

struct ViewsOfObject {
  const CategoryModel& model;
  std::vector<ViewOfObject> views;
  Eigen::Vector3d up_world, middle;  // of the cameras, metres
  const BoxOptions& box;
  const ResectionOptions& resection;

  double count() const { return static_cast<double>(views.size()); }
};

struct PlacedObjectHypothesis {
  Eigen::Isometry3d T_world_object = Eigen::Isometry3d::Identity();
  Eigen::VectorXd coefficients;
  double cost = 0;  // mean over the views
};

SeenObject See(const PlacedObjectHypothesis& object, const ViewOfObject& view) {
  return {{view.T_camera_world * object.T_world_object, object.coefficients},
          WireframeFromCoefficients(*view.view.model, object.coefficients)};
}

// From coarse (progress 0) to fine (1), geometrically.
MatchGate GateAt(const ViewOfObject& view, double progress) {
  const Box& box = view.view.detection.box;
  const double coarse = std::max(kFineGate, kCoarseGate * std::hypot(box.width, box.height));
  return {coarse * std::pow(kFineGate / coarse, progress),
          kCoarseAngle * std::pow(kFineAngle / kCoarseAngle, progress)};
}

// None where it is behind a camera, or clearly above the bound.
std::optional<double> ComputeCost(const ViewsOfObject& views, const PlacedObjectHypothesis& object,
                                  double progress, double bound) {
  double sum = kShapeWeight * object.coefficients.squaredNorm() * std::min(views.count(), kViewsOfShape);
  for (const ViewOfObject& view : views.views) {
    SeenObject seen = See(object, view);
    if (seen.at.T_camera_object.translation().z() < kNearestObject) return std::nullopt;
    const BoxSides sides = SidesSeen(seen, view.view, view.occluders, views.box);
    const ProjectedWireframe projected = ProjectSeen(seen, view.view, sides, view.occluders);
    seen.at.coefficients.setZero();
    sum += PriorCost(view.view, seen.at, seen.wireframe, sides, projected, views.box, {});
    sum += LineCost(projected, CoveredLength(projected, view.view.segments, GateAt(view, progress)));
    if (sum > (bound + kPruneMargin) * views.count()) return std::nullopt;
  }
  return sum / views.count();
}

// 1/2 d^T H d + g^T d of d = (rotation, translation, coefficients): X = (exp(w) R, t + v) in the world.
struct NormalSystem {
  Eigen::MatrixXd H;
  Eigen::VectorXd g;
};

void AddView(const ImageEvidence& evidence, const Eigen::Matrix3d& R_camera_world, NormalSystem& system) {
  Eigen::MatrixXd J = Eigen::MatrixXd::Identity(system.g.size(), system.g.size());
  J.topLeftCorner<3, 3>() = J.block<3, 3>(3, 3) = R_camera_world;
  system.H += J.transpose() * evidence.information * J;
  system.g += J.transpose() * evidence.gradient;
}

// Upright and of the category's shapes; and a little on the diagonal, where no view says anything.
void AddPriors(const ViewsOfObject& views, const PlacedObjectHypothesis& object, NormalSystem& system) {
  const Eigen::Index modes = object.coefficients.size();
  const Eigen::Vector3d axis = object.T_world_object.linear().col(1);
  const double upright = views.count() / (kUprightSigma * kUprightSigma);
  system.H.topLeftCorner<3, 3>() += upright * Skew(axis).transpose() * Skew(axis);
  system.g.head<3>() -= upright * Skew(axis).transpose() * (axis - views.up_world);
  system.H.diagonal().tail(modes).array() += 1;
  system.g.tail(modes) += object.coefficients;
  system.H.diagonal().array() += 1e-3;
  system.H.diagonal().segment<3>(3).array() += 1;
}

void Move(const Eigen::VectorXd& whole_step, PlacedObjectHypothesis& object) {
  if (!whole_step.allFinite()) return;
  const Eigen::Index modes = object.coefficients.size();
  const double length = std::max({1.0, whole_step.head<3>().norm() / kLongestTurn,
                                  whole_step.segment<3>(3).norm() / kLongestWay,
                                  whole_step.tail(modes).norm() / kLongestShape});
  const Eigen::VectorXd step = whole_step / length;
  object.T_world_object.linear() = ExpSO3(step.head<3>()) * object.T_world_object.linear();
  object.T_world_object.translation() += step.segment<3>(3);
  object.coefficients = (object.coefficients + step.tail(modes)).cwiseMax(-kMostShape).cwiseMin(kMostShape);
}

NormalSystem EmptySystem(const PlacedObjectHypothesis& object) {
  const Eigen::Index size = 6 + object.coefficients.size();
  return {Eigen::MatrixXd::Zero(size, size), Eigen::VectorXd::Zero(size)};
}

// One step of Gauss and Newton of the position alone, by the boxes.
void StepByBoxes(const ViewsOfObject& views, PlacedObjectHypothesis& object) {
  NormalSystem system = EmptySystem(object);
  for (const ViewOfObject& view : views.views) {
    const SeenObject seen = See(object, view);
    if (seen.at.T_camera_object.translation().z() < kNearestObject) continue;
    const BoxSides sides = SidesSeen(seen, view.view, view.occluders, views.box);
    ProjectedWireframe projected;
    ProjectEdges(*view.view.camera, seen.wireframe, seen.at.T_camera_object,
                 ClipBox(view.view.detection.box, sides, *view.view.camera), projected);
    AddView(EvidenceAt({view.view, sides, {}, projected, seen.at, views.box, views.resection}),
            view.T_camera_world.linear(), system);
  }
  AddPriors(views, object, system);
  Eigen::VectorXd step = Eigen::VectorXd::Zero(system.g.size());
  step.segment<3>(3) = -system.H.block<3, 3>(3, 3).llt().solve(system.g.segment<3>(3));
  Move(step, object);
}

// One step of pose and shape, by the lines that match now and the boxes.
void StepByLines(const ViewsOfObject& views, double progress, PlacedObjectHypothesis& object) {
  NormalSystem system = EmptySystem(object);
  ResectionOptions resection = views.resection;
  for (const ViewOfObject& view : views.views) {
    const SeenObject seen = See(object, view);
    if (seen.at.T_camera_object.translation().z() < kNearestObject) continue;
    const BoxSides sides = SidesSeen(seen, view.view, view.occluders, views.box);
    const ProjectedWireframe projected = ProjectSeen(seen, view.view, sides, view.occluders);
    const MatchGate gate = GateAt(view, progress);
    const std::vector<EdgeMatch> matches = MatchSegments(projected, view.view.segments, gate).matches;
    resection.segment_sigma = views.resection.segment_sigma * std::max(1.0, gate.distance / (2 * kFineGate));
    AddView(EvidenceAt({view.view, sides, matches, projected, seen.at, views.box, resection}),
            view.T_camera_world.linear(), system);
  }
  AddPriors(views, object, system);
  Move(-system.H.llt().solve(system.g), object);
}

// Upright, its front at the yaw from a fixed horizontal direction.
Eigen::Matrix3d UprightAt(double yaw, const Eigen::Vector3d& up) {
  const Eigen::Vector3d zero = up.unitOrthogonal();
  const Eigen::Vector3d front = std::cos(yaw) * zero + std::sin(yaw) * up.cross(zero);
  Eigen::Matrix3d R;
  R << up.cross(front), up, front;
  return R;
}

// As it is; and all round with the dictionary's shapes, where the boxes have those.
std::vector<PlacedObjectHypothesis> MakeHypothesesOverViews(const ViewsOfObject& views,
                                                            const GraphObject& object) {
  std::vector<PlacedObjectHypothesis> hypotheses{{object.T_world_object, object.coefficients, 0}};
  const double all_round = 2 * M_PI / views.model.spec.symmetry_order;
  for (double yaw = 0; yaw < all_round - 1e-9; yaw += kYawStep) {
    for (const Eigen::VectorXd& coefficients : views.model.dictionary) {
      PlacedObjectHypothesis turned{object.T_world_object, coefficients, 0};
      turned.T_world_object.linear() = UprightAt(yaw, views.up_world);
      for (int step = 0; step < kBoxSteps; ++step) StepByBoxes(views, turned);
      const Eigen::Vector3d ray = turned.T_world_object.translation() - views.middle;
      for (const double factor : kDistanceFactors) {
        hypotheses.push_back(turned);
        hypotheses.back().T_world_object.translation() = views.middle + factor * ray;
      }
    }
  }
  return hypotheses;
}

bool AreAlike(const PlacedObjectHypothesis& a, const PlacedObjectHypothesis& b, int symmetry_order) {
  const double turn = AzimuthDifference(YawBetween(a.T_world_object, b.T_world_object), 0, symmetry_order);
  return std::abs(turn) < kAlikeTurn &&
         (a.T_world_object.translation() - b.T_world_object.translation()).norm() < kAlikeWay;
}

// The best few that are not alike.
std::vector<PlacedObjectHypothesis> SelectBest(const ViewsOfObject& views,
                                               std::vector<PlacedObjectHypothesis> hypotheses) {
  double best = 1e9;
  std::vector<PlacedObjectHypothesis> ranked;
  for (PlacedObjectHypothesis& hypothesis : hypotheses) {
    const auto cost = ComputeCost(views, hypothesis, 0, best);
    if (!cost) continue;
    best = std::min(best, *cost);
    hypothesis.cost = *cost;
    ranked.push_back(std::move(hypothesis));
  }
  std::stable_sort(ranked.begin(), ranked.end(),
                   [](const auto& a, const auto& b) { return a.cost < b.cost; });
  std::vector<PlacedObjectHypothesis> selected;
  for (PlacedObjectHypothesis& hypothesis : ranked) {
    if (selected.size() == kMostRefined) break;
    const bool alike = std::any_of(selected.begin(), selected.end(), [&](const auto& better) {
      return AreAlike(hypothesis, better, views.model.spec.symmetry_order);
    });
    if (!alike) selected.push_back(std::move(hypothesis));
  }
  return selected;
}

ViewsOfObject CollectViews(const ViewsOfMap& map, size_t object,
                           const std::vector<std::pair<size_t, size_t>>& all) {
  ViewsOfObject views{*map.graph.objects[object].model, {},      map.graph.up_world,
                      Eigen::Vector3d::Zero(),          map.box, map.resection};
  const double step = std::max(1.0, static_cast<double>(all.size()) / kMostViews);
  for (double at = 0; at < static_cast<double>(all.size()); at += step) {
    const auto [i, j] = all[static_cast<size_t>(at)];
    const ObjectView& view = map.frames[i].observations[j].view;
    const Eigen::Isometry3d& T_world_camera = map.graph.T_world_camera[i];
    views.views.push_back({view, T_world_camera.inverse(), Occluders(map.seen[i], object, view)});
    views.middle += T_world_camera.translation();
  }
  views.middle /= views.count();
  return views;
}

}  // namespace

GraphObject EstimateOverViews(const ViewsOfMap& map, size_t object,
                              const std::vector<std::pair<size_t, size_t>>& all) {
  const GraphObject& start = map.graph.objects[object];
  const ViewsOfObject views = CollectViews(map, object, all);
  std::optional<PlacedObjectHypothesis> best;
  for (PlacedObjectHypothesis& hypothesis : SelectBest(views, MakeHypothesesOverViews(views, start))) {
    for (int round = 0; round < kRefiningRounds; ++round) {
      const double progress = round / (kRefiningRounds - 1.0);
      for (int step = 0; step < kStepsARound; ++step) StepByLines(views, progress, hypothesis);
    }
    const auto cost = ComputeCost(views, hypothesis, 1, 1e9);
    if (!cost || (best && best->cost <= *cost)) continue;
    hypothesis.cost = *cost;
    best = std::move(hypothesis);
  }
  if (!best) return start;
  return {start.model, best->T_world_object, best->coefficients, 0};
}

}  // namespace armature
