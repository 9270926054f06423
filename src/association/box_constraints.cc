// SPDX-License-Identifier: BSD-3-Clause
#include "association/box_constraints.h"

#include <Eigen/Dense>
#include <algorithm>

namespace armature {
namespace {

// Tuned on office_dev and redkitchen_a, whose detections' boxes are a person's.
constexpr double kCutTolerance = 0.06;  // share of the box: a side this close to the image's border is cut
constexpr double kHiddenProbability = 0.3;        // of a bottom that no other box goes on beyond
constexpr double kHiddenBehindProbability = 0.7;  // of a side that another box goes on beyond

// Ends of all edges, rotated: 3 x 2m.
Eigen::Matrix3Xd RotatedEnds(const Wireframe& wireframe, const Eigen::Matrix3d& R) {
  const Eigen::Index m = wireframe.edges();
  Eigen::Matrix3Xd ends(3, 2 * m);
  ends.leftCols(m).noalias() = R * (wireframe.midpoints - 0.5 * wireframe.directions);
  ends.rightCols(m).noalias() = R * (wireframe.midpoints + 0.5 * wireframe.directions);
  return ends;
}

Eigen::Vector3d PrintedTranslation(const ObjectView& view, const Eigen::Matrix3Xd& ends) {
  const Camera& camera = *view.camera;
  const Box& box = view.detection.box;
  const Eigen::Vector3d extent = ends.rowwise().maxCoeff() - ends.rowwise().minCoeff();
  const double Tz = 0.5 * (extent.x() * camera.fx / box.width + extent.y() * camera.fy / box.height);
  const Eigen::Vector2d center = box.center();
  return {(center.x() - camera.cx) * Tz / camera.fx, (center.y() - camera.cy) * Tz / camera.fy, Tz};
}

// The ends that are seen farthest left, up, right and down from T.
std::array<Eigen::Index, 4> OutermostEnds(const Eigen::Matrix3Xd& ends, const Eigen::Vector3d& T) {
  std::array<Eigen::Index, 4> outermost{};
  Eigen::Vector2d least = Eigen::Vector2d::Constant(1e9), most = -least;
  for (Eigen::Index i = 0; i < ends.cols(); ++i) {
    const Eigen::Vector3d P = ends.col(i) + T;
    const Eigen::Vector2d seen = P.head<2>() / std::max(P.z(), 0.1);
    for (int axis = 0; axis < 2; ++axis) {
      if (seen(axis) < least(axis)) {
        least(axis) = seen(axis);
        outermost[static_cast<size_t>(axis)] = i;
      }
      if (seen(axis) > most(axis)) {
        most(axis) = seen(axis);
        outermost[static_cast<size_t>(axis) + 2] = i;
      }
    }
  }
  return outermost;
}

}  // namespace

BoxSides SidesAtImageBorder(const Box& box, const Camera& camera) {
  const double dx = kCutTolerance * box.width, dy = kCutTolerance * box.height;
  const auto side = [](bool cut) { return cut ? BoxSide::kOpen : BoxSide::kSeen; };
  return {side(box.left() < dx), side(box.top() < dy), side(box.right() > camera.width - 1 - dx),
          side(box.bottom() > camera.height - 1 - dy)};
}

std::array<double, 4> HiddenProbabilities(const Box& box, const std::vector<Box>& others) {
  std::array<double, 4> probability = {0, 0, 0, kHiddenProbability};
  // A strip just beyond each side, a fifth of the box deep.
  const double dx = 0.2 * box.width, dy = 0.2 * box.height;
  const std::array<Box, 4> beyond = {
      Box{box.left() - dx, box.top(), dx, box.height}, Box{box.left(), box.top() - dy, box.width, dy},
      Box{box.right(), box.top(), dx, box.height}, Box{box.left(), box.bottom(), box.width, dy}};
  for (const size_t side : {0, 2, 3}) {  // nothing hangs from above
    for (const Box& other : others) {
      // The other box must also reach into this one, else it is beside it.
      const bool overlaps = Intersection(other, box).area() > 0.1 * box.area();
      if (overlaps && Intersection(other, beyond[side]).area() > 0.6 * beyond[side].area()) {
        probability[side] = kHiddenBehindProbability;
      }
    }
  }
  return probability;
}

std::array<double, 2> SideSigmas(const Box& box, const BoxOptions& options) {
  return {options.sigma * box.width + options.sigma_pixels,
          options.sigma * box.height + options.sigma_pixels};
}

Box ClipBox(const Box& box, const BoxSides& sides, const Camera& camera) {
  const double left = sides[0] == BoxSide::kOpen ? box.left() : 0;
  const double top = sides[1] == BoxSide::kOpen ? box.top() : 0;
  const double right = sides[2] == BoxSide::kOpen ? box.right() : camera.width - 1;
  const double bottom = sides[3] == BoxSide::kOpen ? box.bottom() : camera.height - 1;
  return {left, top, right - left, bottom - top};
}

std::array<ExtremePoint, 4> Extremes(const ProjectedWireframe& projected) {
  std::array<ExtremePoint, 4> extremes{};
  extremes[0].pixel = extremes[1].pixel = 1e9;
  extremes[2].pixel = extremes[3].pixel = -1e9;
  const auto reach = [&](int edge, double s, const Eigen::Vector2d& p, double inverse_z) {
    if (p.x() < extremes[0].pixel) extremes[0] = {edge, s, p.x(), inverse_z};
    if (p.y() < extremes[1].pixel) extremes[1] = {edge, s, p.y(), inverse_z};
    if (p.x() > extremes[2].pixel) extremes[2] = {edge, s, p.x(), inverse_z};
    if (p.y() > extremes[3].pixel) extremes[3] = {edge, s, p.y(), inverse_z};
  };
  for (size_t i = 0; i < projected.edges.size(); ++i) {
    const ProjectedEdge& edge = projected.edges[i];
    if (edge.length <= 0) continue;
    reach(static_cast<int>(i), edge.s1, edge.line.p1, edge.inverse_z1);
    reach(static_cast<int>(i), edge.s2, edge.line.p2, edge.inverse_z2);
  }
  return extremes;
}

std::optional<Box> BoxAround(const ProjectedWireframe& projected) {
  const std::array<ExtremePoint, 4> extremes = Extremes(projected);
  if (extremes[0].edge < 0) return std::nullopt;
  return Box{extremes[0].pixel, extremes[1].pixel, extremes[2].pixel - extremes[0].pixel,
             extremes[3].pixel - extremes[1].pixel};
}

std::optional<Box> ExpectedBox(const Camera& camera, const CategoryModel& model, const PoseAndShape& object) {
  ProjectedWireframe projected;
  const Box image{0, 0, camera.width - 1.0, camera.height - 1.0};
  ProjectEdges(camera, WireframeFromCoefficients(model, object.coefficients), object.T_camera_object, image,
               projected);
  return BoxAround(projected);
}

std::optional<double> BoxAgreement(const Box& expected, const Box& seen, double least_overlap) {
  const double inside = Intersection(expected, seen).area() / std::max(seen.area(), 1.0);
  const double overlap = IntersectionOverUnion(expected, seen);
  if (overlap <= least_overlap && (inside <= 0.7 || overlap <= 0.1)) return std::nullopt;
  return overlap + 0.3 * inside;
}

Eigen::Vector2d ImagePadding(const CategorySpec& spec, const Eigen::Matrix3d& R_camera_object) {
  const double radius = spec.padding.x();
  if (spec.padding == Eigen::Vector3d::Constant(radius)) return Eigen::Vector2d::Constant(radius);  // a ball
  return (R_camera_object.topRows<2>().cwiseAbs2() * spec.padding.cwiseAbs2()).cwiseSqrt();
}

Eigen::Vector3d PrintedTranslation(const ObjectView& view, const Wireframe& wireframe,
                                   const Eigen::Matrix3d& R) {
  return PrintedTranslation(view, RotatedEnds(wireframe, R));
}

Eigen::Vector3d TranslationFromBox(const ObjectView& view, const BoxSides& sides, const Wireframe& wireframe,
                                   const Eigen::Matrix3d& R) {
  const Camera& camera = *view.camera;
  const Box& box = view.detection.box;
  const Eigen::Matrix3Xd ends = RotatedEnds(wireframe, R);
  const double side_x[2] = {(box.left() - camera.cx) / camera.fx, (box.right() - camera.cx) / camera.fx};
  const double side_y[2] = {(box.top() - camera.cy) / camera.fy, (box.bottom() - camera.cy) / camera.fy};
  const Eigen::Vector2d reach = ImagePadding(view.model->spec, R);
  Eigen::Vector3d T = PrintedTranslation(view, ends);
  const double start_depth = T.z();
  for (int iteration = 0; iteration < 3; ++iteration) {
    Eigen::Matrix<double, 6, 3> A;
    Eigen::Matrix<double, 6, 1> b;
    const std::array<Eigen::Index, 4> outermost = OutermostEnds(ends, T);
    for (int side = 0; side < 4; ++side) {
      const bool horizontal = side % 2 == 0;  // left and right constrain x
      const Eigen::Index corner = outermost[static_cast<size_t>(side)];
      const double at = horizontal ? side_x[side / 2] : side_y[side / 2];
      // An open side still says roughly where the object is: a tenth of the weight keeps the system regular.
      const double weight = sides[static_cast<size_t>(side)] == BoxSide::kSeen ? 1.0 : 0.1;
      A.row(side) << (horizontal ? weight : 0), (horizontal ? 0 : weight), -weight * at;
      const double padding = (side < 2 ? -1 : 1) * reach(side % 2);
      b(side) = weight * (at * ends(2, corner) - ends(horizontal ? 0 : 1, corner) - padding);
    }
    const double prior = 1e-3;
    A.row(4) << 0, 0, prior;
    b(4) = prior * start_depth;
    A.row(5).setZero();
    b(5) = 0;
    if (view.floor && view.up_camera && view.model->spec.stands_on_floor) {
      // up . (T + lowest) = -camera height, weighted against the sides' uncertainty at this depth.
      const double lowest = (view.up_camera->transpose() * ends).minCoeff();
      const double weight = 0.03 * box.width / camera.fx * T.z() / view.floor->sigma;
      A.row(5) = weight * view.up_camera->transpose();
      b(5) = -weight * (view.floor->camera_height + lowest);
    }
    T = (A.transpose() * A).ldlt().solve(A.transpose() * b);
    if (!(T.z() > 0.2)) T = PrintedTranslation(view, ends);
  }
  return T;
}

}  // namespace armature
