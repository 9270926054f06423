// SPDX-License-Identifier: BSD-3-Clause
// How alike two surfaces are.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>

#include "geometry/triangle_mesh.h"

namespace armature {

// Points spread evenly over the surface (by area; the same for the same mesh, count and seed on every
// platform). 3 x count, the mesh's unit. At least one triangle with an area.
Eigen::Matrix3Xf SampleSurface(const TriangleMesh& mesh, int count, std::uint64_t seed);

// Points with PCL's KD-tree over them.
class SurfacePoints {
 public:
  explicit SurfacePoints(Eigen::Matrix3Xf points);  // at least one
  ~SurfacePoints();
  SurfacePoints(SurfacePoints&&) noexcept;
  SurfacePoints& operator=(SurfacePoints&&) noexcept;

  const Eigen::Matrix3Xf& points() const { return points_; }
  // The distance of each of the points to the nearest one of these, the points' unit.
  Eigen::VectorXf MeasureDistances(const Eigen::Matrix3Xf& points) const;

 private:
  struct Tree;
  Eigen::Matrix3Xf points_;
  std::unique_ptr<Tree> tree_;
};

struct SurfaceDistance {
  double chamfer = 0;    // the mean distance from a to b and that from b to a, their mean; metres
  double precision = 0;  // share of a's points within the threshold of b, 0..1
  double recall = 0;     // share of b's points within the threshold of a
  double f_score = 0;    // their harmonic mean
};

// Of a retrieved (a) and the true surface (b), both in one frame, metres.
SurfaceDistance CompareSurfaces(const SurfacePoints& retrieved, const SurfacePoints& truth, double threshold);

}  // namespace armature
