// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/object_views.h"

#include <algorithm>

#include "lines/selection.h"

namespace armature {

ObjectView MakeView(const Detection& detection, const std::vector<Segment>& segments,
                    const Eigen::Vector3d& up_camera, const Camera& camera, const CategoryModel& model,
                    const Options& options) {
  ObjectView view;
  view.camera = &camera;
  view.model = &model;
  view.detection = detection;
  view.detection.box = UndistortBox(camera, detection.box);
  const Box& box = view.detection.box;
  view.sides = SidesAtImageBorder(box, camera);
  const double margin = options.lines.box_margin * std::max(box.width, box.height);
  view.segments =
      SegmentsInBox(segments, box.Grown(margin), options.lines.min_length, options.association.max_segments);
  view.up_camera = up_camera;
  return view;
}

}  // namespace armature
