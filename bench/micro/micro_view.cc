// SPDX-License-Identifier: BSD-3-Clause
#include "bench/micro/micro_view.h"

#include <cmath>

#include "association/box_constraints.h"
#include "geometry/random.h"
#include "geometry/rotation.h"
#include "geometry/viewpoint.h"

namespace armature {
namespace {

constexpr double kAzimuth = 35 * kDegree;
constexpr double kPitch = 20 * kDegree;        // by which the camera looks down
constexpr double kAzimuthError = 8 * kDegree;  // of the detection's
constexpr double kEndNoise = 0.7;              // pixels, standard deviation of a fragment's ends
constexpr double kShortestEdge = 15;           // pixels; shorter ones are not found

Eigen::Vector2d Noisy(const Eigen::Vector2d& pixel, Random& random) {
  const double du = random.Normal(0, kEndNoise), dv = random.Normal(0, kEndNoise);
  return pixel + Eigen::Vector2d(du, dv);
}

Segment Fragment(const Segment& edge, double from, double to, Random& random) {
  const Eigen::Vector2d along = edge.p2 - edge.p1;
  const Eigen::Vector2d p1 = Noisy(edge.p1 + from * along, random);
  return {p1, Noisy(edge.p1 + to * along, random)};
}

Segment Clutter(const Box& box, Random& random) {
  const double u = random.Uniform(box.left(), box.right()), v = random.Uniform(box.top(), box.bottom());
  const double length = random.Uniform(0.05, 0.4) * std::min(box.width, box.height);
  const double angle = random.Uniform(0, M_PI);
  return {{u, v}, {u + length * std::cos(angle), v + length * std::sin(angle)}};
}

std::vector<Segment> Segments(const ProjectedWireframe& projected, const Box& box, size_t count) {
  Random random(1);
  std::vector<Segment> segments;
  for (const ProjectedEdge& edge : projected.edges) {
    if (edge.length < kShortestEdge || edge.visible_share < 0.5) continue;
    segments.push_back(Fragment(edge.line, 0, 0.55, random));
    segments.push_back(Fragment(edge.line, 0.6, 1, random));
  }
  while (segments.size() < count) segments.push_back(Clutter(box, random));
  segments.resize(count);
  return segments;
}

}  // namespace

MicroView::MicroView(const CategoryModel& category, size_t segments) : model(category) {
  for (const Eigen::VectorXd& c : model.dictionary) dictionary.push_back(WireframeFromCoefficients(model, c));
  truth.coefficients = Eigen::VectorXd::Zero(model.modes());
  const double size = BoundingBoxSize(WireframeFromCoefficients(model, truth.coefficients)).norm();
  const Eigen::Vector3d T = size * Eigen::Vector3d(0.2, 0.1, 2.2);
  const Eigen::Vector3d up(0, -std::cos(kPitch), -std::sin(kPitch));
  truth.T_camera_object.linear() = UprightRotation(kAzimuth, up, T);
  truth.T_camera_object.translation() = T;
  view.camera = &camera;
  view.model = &model;
  view.up_camera = up;
  view.detection.category = model.spec.name;
  view.detection.box = ExpectedBox(camera, model, truth).value();
  view.detection.azimuth = kAzimuth + kAzimuthError;
  view.sides = SidesAtImageBorder(view.detection.box, camera);
  view.hidden_probability = HiddenProbabilities(view.detection.box, {});
  view.segments = Segments(Project(truth), view.detection.box, segments);
}

ProjectedWireframe MicroView::Project(const PoseAndShape& at) const {
  ProjectedWireframe projected;
  ProjectWireframe(camera, model.spec, WireframeFromCoefficients(model, at.coefficients), at.T_camera_object,
                   {0, 0, camera.width - 1.0, camera.height - 1.0}, {}, projected);
  return projected;
}

PoseAndShape MicroView::NearTruth() const {
  PoseAndShape near = truth;
  near.T_camera_object.linear() = ExpSO3({0.02, 0.06, -0.02}) * truth.T_camera_object.linear();
  near.T_camera_object.translation() = 1.03 * truth.T_camera_object.translation();
  return near;
}

}  // namespace armature
