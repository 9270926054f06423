// SPDX-License-Identifier: BSD-3-Clause
// The objects of the map as one camera sees them: where their lines and boxes should be, and what hides them.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "mapping/map_frame.h"
#include "mapping/map_graph.h"

namespace armature {

struct SeenObject {
  PoseAndShape at;  // T_camera_object as it would be at the category's own size
  Wireframe wireframe;
  double size = 1;  // of the object, over that
};

// All objects of the map, detected in the image or not, and the faces of each.
struct SeenObjects {
  std::vector<SeenObject> objects;
  std::vector<std::vector<ImageFace>> faces;
};
SeenObjects SeeObjects(const MapGraph& graph, size_t camera, const Camera& intrinsics);

// What hides one object: the faces of all others, and what its view has besides.
std::vector<ImageFace> Occluders(const SeenObjects& seen, size_t object, const ObjectView& view);

// The object's edges, also where they are outside of the image; not what of them is hidden.
ProjectedWireframe ProjectWhole(const SeenObject& object, const Camera& camera);

// Which sides of the box the object can be taken to end at, given where the map has it: those that the
// image's border does not cut and where nothing hides that it goes on. (To take it for hidden wherever it
// goes on beyond the box would make what is too near fit every box: the map would shrink.)
BoxSides SidesSeen(const SeenObject& object, const ObjectView& view, const std::vector<ImageFace>& occluders,
                   const BoxOptions& options);

// The object's edges in the image, cut at the sides where it may go on, without what is hidden.
ProjectedWireframe ProjectSeen(const SeenObject& object, const ObjectView& view, const BoxSides& sides,
                               const std::vector<ImageFace>& occluders);

}  // namespace armature
