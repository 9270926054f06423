// SPDX-License-Identifier: BSD-3-Clause
#include "bench/sections/load_variants.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>

#include "association/hypotheses.h"
#include "bench/bench_sequence.h"
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

struct Search {
  double spread_deg, step_deg;
  size_t shapes;  // of the dictionary
};
constexpr size_t kAllShapes = std::numeric_limits<size_t>::max();
constexpr std::array<Search, 8> kSearches{{{0, 15, 1},
                                           {30, 15, 1},
                                           {30, 15, 2},
                                           {30, 15, kAllShapes},
                                           {30, 7.5, kAllShapes},
                                           {60, 7.5, kAllShapes},
                                           {60, 5, kAllShapes},
                                           {90, 5, kAllShapes}}};
constexpr std::array<int, 6> kMostSegments{5, 10, 20, 40, 80, 160};
constexpr std::array<std::array<int, 2>, 4> kImageSizes{{{640, 480}, {856, 480}, {1280, 720}, {1920, 1080}}};

void Vary(const Search& search, LoadVariant& variant) {
  HypothesisOptions& hypotheses = variant.options.association.hypotheses;
  hypotheses.azimuth_spread_deg = search.spread_deg;
  hypotheses.azimuth_step_deg = search.step_deg;
  for (CategoryModel& model : variant.models)
    model.dictionary.resize(std::min(model.dictionary.size(), search.shapes));
  const std::string shapes = search.shapes == kAllShapes
                                 ? "all shapes"
                                 : fmt::format("{} shape{}", search.shapes, search.shapes == 1 ? "" : "s");
  variant.setting =
      fmt::format("azimuths every {} deg within {} and {}", search.step_deg, search.spread_deg, shapes);
}

void Vary(int most_segments, LoadVariant& variant) {
  variant.options.association.max_segments = most_segments;
  variant.setting = fmt::format("at most {}", most_segments);
}

}  // namespace

std::string LoadVariant::name() const { return LoadName(load) + ": " + setting; }

std::string LoadName(Load load) {
  switch (load) {
    case Load::kHypotheses:
      return "hypotheses";
    case Load::kSegments:
      return "segments";
    case Load::kImageSize:
      return "image size";
  }
  std::abort();
}

std::vector<LoadVariant> MakeVariants(Load load, const BenchSequence& sequence, const EngineParts& parts,
                                      std::deque<BenchSequence>& resized) {
  const LoadVariant unchanged{load, "", parts.options, parts.models, &sequence};
  std::vector<LoadVariant> variants;
  if (load == Load::kHypotheses) {
    for (const Search& search : kSearches) Vary(search, variants.emplace_back(unchanged));
  } else if (load == Load::kSegments) {
    for (const int most : kMostSegments) Vary(most, variants.emplace_back(unchanged));
  } else {
    for (const auto& [width, height] : kImageSizes) {
      LoadVariant& variant = variants.emplace_back(unchanged);
      variant.sequence = &resized.emplace_back(Resized(sequence, width, height));
      variant.setting = ImageSize(variant.sequence->camera);
    }
  }
  return variants;
}

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
