// SPDX-License-Identifier: BSD-3-Clause
// The true objects of a sequence with their own edges, seen from its cameras.
#pragma once

#include <optional>
#include <vector>

#include "association/projection.h"
#include "category/category_model.h"
#include "truth/cad_library.h"
#include "truth/sequence_truth.h"
#include "truth/visible_edges.h"

namespace armature {

class TrueScene {
 public:
  // Keeps a reference to `sequence`, which has to outlive it. Throws InputError for a category without model.
  TrueScene(const SequenceTruth& sequence, const std::vector<CategoryModel>& models, const CadLibrary& cad);

  const CategorySpec& spec(size_t object) const { return objects_[object].spec; }
  // The category's: it tells which edges are alike under a symmetric turn.
  const Wireframe& mean_wireframe(size_t object) const { return objects_[object].mean; }
  // What is seen of the object's own edges. As the sequence's edges_gt.csv says, where it has one. Else from
  // the CAD models: not outside the image, nor behind its own faces or those of the other objects with a
  // known one; none where the object's is not known.
  std::optional<std::vector<VisibleEdge>> EdgesSeen(size_t object, const TimedPose& T_world_camera) const;

 private:
  struct Object {
    CategorySpec spec;
    Wireframe mean;
    std::optional<Wireframe> wireframe;  // none: its CAD model is not known
  };

  std::vector<VisibleEdge> ProjectedEdges(size_t object, const Eigen::Isometry3d& T_camera_world) const;

  const SequenceTruth& sequence_;
  std::vector<Object> objects_;  // as sequence.truth.objects
};

}  // namespace armature
