// SPDX-License-Identifier: BSD-3-Clause
// The true objects of a sequence with their own edges, seen from its cameras.
#pragma once

#include <optional>
#include <vector>

#include "association/projection.h"
#include "category/category_model.h"
#include "eval/cad_library.h"
#include "eval/ground_truth.h"
#include "eval/visible_edges.h"
#include "geometry/camera.h"

namespace armature {

// Throws InputError when there is no specification of the category.
const CategorySpec& SpecOf(const std::vector<CategorySpec>& specs, const std::string& category);

class TrueScene {
 public:
  // Keeps references to `truth`, which has to outlive it. Throws InputError for a category without
  // specification.
  TrueScene(const Camera& camera, const GroundTruth& truth, const std::vector<CategorySpec>& specs,
            const CadLibrary& cad);

  const CategorySpec& spec(size_t object) const { return objects_[object].spec; }
  // None where the CAD model is not known.
  const std::optional<Wireframe>& wireframe(size_t object) const { return objects_[object].wireframe; }
  // What is seen of the object's own edges: not outside the image, nor behind its own faces or those of the
  // other objects with a known CAD model. None where the object's CAD model is not known.
  std::optional<std::vector<VisibleEdge>> EdgesSeen(size_t object,
                                                    const Eigen::Isometry3d& T_world_camera) const;

 private:
  struct Object {
    CategorySpec spec;
    std::optional<Wireframe> wireframe;
  };

  Camera camera_;
  const GroundTruth& truth_;
  std::vector<Object> objects_;  // as truth.objects
};

}  // namespace armature
