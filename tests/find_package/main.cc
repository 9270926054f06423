// SPDX-License-Identifier: BSD-3-Clause
// Projects the mean shape of a category model, seen from the front three metres away.
#include <cstdio>

#include "association/projection.h"
#include "eval/trajectories/trajectory_metrics.h"
#include "geometry/viewpoint.h"
#include "io/category_yaml.h"

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  using namespace armature;
  const CategoryModel model = LoadCategory(argv[1]);
  const Eigen::Vector3d ahead(0, 0, 3);
  Eigen::Isometry3d T_camera_object(Eigen::Translation3d{ahead});
  T_camera_object.linear() = RotationFromViewpoint({}, ahead);
  const Camera camera{640, 480, 500, 500, 319.5, 239.5, {}};
  ProjectedWireframe projected;
  ProjectEdges(camera, WireframeFromVector(model.mean), T_camera_object, {0, 0, 640, 480}, projected);
  std::vector<double> lengths;
  for (const ProjectedEdge& edge : projected.edges) lengths.push_back(edge.length);
  std::printf("%s: %d edges, the longest %.0f pixels\n", model.spec.name.c_str(), model.spec.edges(),
              SummarizeErrors(lengths).value().max);
}
