// SPDX-License-Identifier: BSD-3-Clause
// A perfect view of a shipped category's object: its visible edges as segments, its box, the true pose and
// shape.
#pragma once

#include <vector>

#include "association/box_constraints.h"
#include "association/object_view.h"
#include "geometry/viewpoint.h"
#include "io/category_yaml.h"
#include "support/category_examples.h"
#include "support/padded_box.h"

namespace armature::testing {

struct SyntheticView {
  Camera camera{856, 480, 580, 580, 427.5, 239.5, {}};
  CategoryModel model;
  PoseAndShape truth;
  ObjectView view;  // points into this struct

  SyntheticView(const SyntheticView&) = delete;
  SyntheticView& operator=(const SyntheticView&) = delete;

  // An upright object at `translation`, seen from the azimuth by a camera that looks down by the pitch.
  SyntheticView(const std::string& category, double azimuth, const Eigen::Vector3d& translation,
                const Eigen::VectorXd& coefficients, double pitch = 0.3)
      : model(LoadCategory(CategoryFolder() / (category + ".yaml"))) {
    const Eigen::Vector3d up(0, -std::cos(pitch), -std::sin(pitch));
    truth.coefficients = Eigen::VectorXd::Zero(model.modes());
    truth.coefficients.head(coefficients.size()) = coefficients;
    truth.T_camera_object.linear() = UprightRotation(azimuth, up, translation);
    truth.T_camera_object.translation() = translation;
    view.camera = &camera;
    view.model = &model;
    view.up_camera = up;
    ProjectedWireframe projected = Project(truth);
    for (const ProjectedEdge& edge : projected.edges) {
      if (edge.length > 15 && edge.visible_share > 0.5) view.segments.push_back(edge.line);
    }
    view.detection.category = category;
    view.detection.box = PaddedBox(camera, model.spec, projected, truth.T_camera_object.linear());
    view.detection.azimuth = azimuth;
    view.sides = SidesAtImageBorder(view.detection.box, camera);
  }

  ProjectedWireframe Project(const PoseAndShape& at) const {
    ProjectedWireframe projected;
    ProjectWireframe(camera, model.spec, WireframeFromCoefficients(model, at.coefficients),
                     at.T_camera_object, {0, 0, camera.width - 1.0, camera.height - 1.0}, {}, projected);
    return projected;
  }
};

}  // namespace armature::testing
