// SPDX-License-Identifier: BSD-3-Clause
#include "bench/sections/view_counts.h"

#include <algorithm>

#include "association/hypotheses.h"
#include "category/category_lookup.h"
#include "lines/selection.h"

namespace armature {
namespace {

ObjectView MakeView(const Detection& detection, const FrameResult& frame, const Camera& camera,
                    const CategoryModel& model, const Options& options) {
  ObjectView view;
  view.camera = &camera;
  view.model = &model;
  view.detection = detection;
  view.sides = SidesAtImageBorder(detection.box, camera);
  const double margin = options.lines.box_margin * std::max(detection.box.width, detection.box.height);
  view.segments = SegmentsInBox(frame.segments, detection.box.Grown(margin), options.lines.min_length,
                                options.association.max_segments);
  view.up_camera = frame.up_camera;
  view.floor = frame.floor;
  return view;
}

std::vector<Box> OtherBoxes(const FrameResult& frame, size_t index) {
  std::vector<Box> boxes;
  for (size_t i = 0; i < frame.observations.size(); ++i) {
    if (i != index) boxes.push_back(frame.observations[i].detection.box);
  }
  return boxes;
}

size_t CountHypotheses(const ObjectView& view, const AssociationOptions& options) {
  std::vector<Wireframe> dictionary;
  for (const Eigen::VectorXd& coefficients : view.model->dictionary)
    dictionary.push_back(WireframeFromCoefficients(*view.model, coefficients));
  return MakeHypotheses(view, dictionary, options.box, options.hypotheses).size();
}

}  // namespace

ViewCounts CountViews(const FrameResult& frame, const Camera& camera,
                      const std::vector<CategoryModel>& models, const Options& options) {
  ViewCounts counts;
  const double share = 1.0 / static_cast<double>(frame.observations.size());
  for (size_t i = 0; i < frame.observations.size(); ++i) {
    const Detection& detection = frame.observations[i].detection;
    ObjectView view = MakeView(detection, frame, camera, LookUpModel(models, detection.category), options);
    view.hidden_probability = HiddenProbabilities(detection.box, OtherBoxes(frame, i));
    counts.hypotheses += share * static_cast<double>(CountHypotheses(view, options.association));
    counts.segments += share * static_cast<double>(view.segments.size());
  }
  return counts;
}

}  // namespace armature
