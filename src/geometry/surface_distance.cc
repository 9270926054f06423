// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/surface_distance.h"

#include <pcl/kdtree/kdtree_flann.h>
#include <pcl/point_types.h>

#include <cmath>
#include <vector>

#include "geometry/random.h"

namespace armature {
namespace {

using Tree3 = pcl::KdTreeFLANN<pcl::PointXYZ>;

struct Triangle {
  Eigen::Vector3d a, ab, ac;

  double area() const { return ab.cross(ac).norm() / 2; }
};

Triangle GetTriangle(const TriangleMesh& mesh, Eigen::Index i) {
  const Eigen::Vector3i v = mesh.triangles.col(i);
  const Eigen::Vector3d a = mesh.vertices.col(v[0]);
  return {a, mesh.vertices.col(v[1]) - a, mesh.vertices.col(v[2]) - a};
}

// Even over the triangle: Osada et al., Shape distributions, 2002.
Eigen::Vector3f PointOn(const Triangle& triangle, Random& random) {
  const double root = std::sqrt(random.Uniform(0, 1)), along = random.Uniform(0, 1);
  return (triangle.a + root * (1 - along) * triangle.ab + root * along * triangle.ac).cast<float>();
}

std::vector<double> AreasUpTo(const TriangleMesh& mesh) {
  std::vector<double> areas;
  double sum = 0;
  for (Eigen::Index i = 0; i < mesh.size(); ++i) areas.push_back(sum += GetTriangle(mesh, i).area());
  return areas;
}

pcl::PointXYZ PclPoint(const Eigen::Vector3f& p) { return {p.x(), p.y(), p.z()}; }

double ShareWithin(const Eigen::VectorXf& distances, double threshold) {
  return (distances.array().cast<double>() <= threshold).cast<double>().mean();
}

}  // namespace

Eigen::Matrix3Xf SampleSurface(const TriangleMesh& mesh, int count, std::uint64_t seed) {
  const std::vector<double> areas = AreasUpTo(mesh);
  Random random(seed);
  Eigen::Matrix3Xf points(3, count);
  // One point in each of `count` equal pieces of the area, in the order of the triangles.
  Eigen::Index triangle = 0;
  for (int i = 0; i < count; ++i) {
    const double area = areas.back() * (i + random.Uniform(0, 1)) / count;
    while (triangle + 1 < mesh.size() && areas[static_cast<size_t>(triangle)] <= area) ++triangle;
    points.col(i) = PointOn(GetTriangle(mesh, triangle), random);
  }
  return points;
}

struct SurfacePoints::Tree {
  Tree3 tree{false};  // the results need no order

  explicit Tree(const Eigen::Matrix3Xf& points) {
    const auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
    for (const auto& point : points.colwise()) cloud->push_back(PclPoint(point));
    tree.setInputCloud(cloud);
  }
};

SurfacePoints::SurfacePoints(Eigen::Matrix3Xf points)
    : points_(std::move(points)), tree_(std::make_unique<Tree>(points_)) {}
SurfacePoints::~SurfacePoints() = default;
SurfacePoints::SurfacePoints(SurfacePoints&&) noexcept = default;
SurfacePoints& SurfacePoints::operator=(SurfacePoints&&) noexcept = default;

Eigen::VectorXf SurfacePoints::MeasureDistances(const Eigen::Matrix3Xf& points) const {
  Eigen::VectorXf distances(points.cols());
  pcl::Indices nearest(1);
  std::vector<float> squared(1);
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    tree_->tree.nearestKSearch(PclPoint(points.col(i)), 1, nearest, squared);
    distances[i] = std::sqrt(squared[0]);
  }
  return distances;
}

SurfaceDistance CompareSurfaces(const SurfacePoints& retrieved, const SurfacePoints& truth,
                                double threshold) {
  const Eigen::VectorXf from_retrieved = truth.MeasureDistances(retrieved.points());
  const Eigen::VectorXf from_truth = retrieved.MeasureDistances(truth.points());
  SurfaceDistance distance;
  distance.chamfer = (from_retrieved.cast<double>().mean() + from_truth.cast<double>().mean()) / 2;
  distance.precision = ShareWithin(from_retrieved, threshold);
  distance.recall = ShareWithin(from_truth, threshold);
  const double sum = distance.precision + distance.recall;
  distance.f_score = sum > 0 ? 2 * distance.precision * distance.recall / sum : 0;
  return distance;
}

}  // namespace armature
