// SPDX-License-Identifier: BSD-3-Clause
// Where a detector should find the true objects.
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "category/category_model.h"
#include "geometry/box.h"
#include "geometry/camera.h"
#include "truth/ground_truth.h"

namespace armature {

struct TrueBox {
  size_t object = 0;  // place among the true objects
  Box visible;        // around what is seen of it, pixels inside the image
  Box whole;          // around all of it that is in the image, hidden or not
  double share = 0;   // of its edges that neither others nor the image's border hide, 0..1
};

// The true objects as their categories' mean wireframes, brought to their sizes: their boxes are known to a
// few percent where the CAD models are not.
class TrueWireframes {
 public:
  // Throws InputError for a category without model.
  TrueWireframes(const std::vector<TrueObject>& objects, const std::vector<CategoryModel>& models);

  // Of all objects of which something is in the image; hidden by each other's and their own faces.
  std::vector<TrueBox> Seen(const Camera& camera, const Eigen::Isometry3d& T_world_camera) const;

 private:
  struct Object {
    CategorySpec spec;
    Wireframe wireframe;
    Eigen::Isometry3d T_world_object;
  };

  std::vector<Object> objects_;
};

}  // namespace armature
