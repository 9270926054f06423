// SPDX-License-Identifier: BSD-3-Clause
#include "cli/align_meshes.h"

#include <numbers>

#include "base/interrupt.h"
#include "geometry/surface_distance.h"
#include "io/mesh_file.h"

namespace armature {
namespace {

constexpr int kSurfacePoints = 4000;

// Centred, of diagonal 1, y up, turned about y.
Eigen::Affine3d Normalising(const TriangleMesh& mesh, int quarter_turns) {
  const Eigen::Matrix3d z_to_y{{1, 0, 0}, {0, 0, 1}, {0, -1, 0}};
  const Eigen::Matrix3d R =
      Eigen::AngleAxisd(quarter_turns * std::numbers::pi / 2, Eigen::Vector3d::UnitY()) * z_to_y;
  const Eigen::Matrix3Xd turned = R * mesh.vertices;
  const Eigen::Vector3d least = turned.rowwise().minCoeff(), most = turned.rowwise().maxCoeff();
  return Eigen::Scaling(1 / (most - least).norm()) * Eigen::Translation3d(-(least + most) / 2) *
         Eigen::Affine3d(R);
}

Eigen::Matrix3Xf MakeEnds(const Wireframe& wireframe) {
  Eigen::Matrix3Xf ends(3, 2 * wireframe.edges());
  for (int e = 0; e < wireframe.edges(); ++e) {
    for (int end = 0; end < 2; ++end) ends.col(2 * e + end) = wireframe.End(e, end).cast<float>();
  }
  return ends;
}

}  // namespace

Eigen::Affine3d AlignedToAnnotations(const TriangleMesh& mesh, const Wireframe& wireframe) {
  const Eigen::Matrix3Xf ends = MakeEnds(wireframe);
  Eigen::Affine3d best = Eigen::Affine3d::Identity();
  float least = std::numeric_limits<float>::infinity();
  for (int quarter_turns = 0; quarter_turns < 4; ++quarter_turns) {
    const Eigen::Affine3d T = Normalising(mesh, quarter_turns);
    const float distance =
        SurfacePoints(SampleSurface(Moved(T, mesh), kSurfacePoints, 1)).MeasureDistances(ends).mean();
    if (distance >= least) continue;
    least = distance;
    best = T;
  }
  return best;
}

void AlignMeshes(const std::filesystem::path& folder, std::vector<CadModel>& models) {
  for (CadModel& model : models) {
    ThrowIfInterrupted();
    if (model.geometry.empty() || model.T_annotation_geometry) continue;
    model.T_annotation_geometry =
        AlignedToAnnotations(ReadGeometry(folder / model.geometry), model.wireframe);
  }
}

}  // namespace armature
