// SPDX-License-Identifier: BSD-3-Clause
#include "association/hypotheses.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "association/line_seeds.h"
#include "geometry/rotation.h"
#include "geometry/viewpoint.h"

namespace armature {
namespace {

constexpr double kAllRoundStep = 15 * kDegree;  // without a prior

Eigen::Vector3d BoxRay(const ObjectView& view) { return view.camera->Ray(view.detection.box.center()); }

// -spread, -spread + step, ... 0 ... spread
std::vector<double> Offsets(double spread, double step) {
  std::vector<double> offsets = {0};
  for (double offset = step; step > 0 && offset <= spread + 1e-9; offset += step) {
    offsets.push_back(offset);
    offsets.push_back(-offset);
  }
  return offsets;
}

// Upright; where up is unknown, as the prior's elevation and tilt have it.
Eigen::Matrix3d RotationAt(const ObjectView& view, double azimuth) {
  const Eigen::Vector3d ray = BoxRay(view);
  if (view.up_camera) return UprightRotation(azimuth, *view.up_camera, ray);
  return RotationFromViewpoint(
      {azimuth, view.detection.elevation.value_or(0), view.detection.tilt.value_or(0)}, ray);
}

// The box as it is, with its bottom hidden, with each other side hidden that may be, and with all of those.
std::vector<BoxSides> SideVariants(const ObjectView& view, const HypothesisOptions& options) {
  std::vector<BoxSides> variants = {view.sides};
  if (!options.hidden_sides) return variants;
  BoxSides all = view.sides;
  for (size_t side = 0; side < 4; ++side) {
    if (view.sides[side] == BoxSide::kOpen || view.hidden_probability[side] <= 0) continue;
    variants.push_back(view.sides);
    variants.back()[side] = all[side] = BoxSide::kOpen;
  }
  if (variants.size() > 2) variants.push_back(all);
  return variants;
}

// The sides that the wireframe's ends leave behind by far are taken to be hidden, if they may be.
BoxSides SidesFor(const ObjectView& view, const Wireframe& wireframe, const Eigen::Isometry3d& T,
                  const BoxOptions& options) {
  ProjectedWireframe projected;
  const Box image{0, 0, view.camera->width - 1.0, view.camera->height - 1.0};
  ProjectEdges(*view.camera, wireframe, T, image, projected);
  const std::array<ExtremePoint, 4> extremes = Extremes(projected);
  const Box& box = view.detection.box;
  const auto [sigma_x, sigma_y] = SideSigmas(box, options);
  const std::array<double, 4> beyond = {
      (box.left() - extremes[0].pixel) / sigma_x, (box.top() - extremes[1].pixel) / sigma_y,
      (extremes[2].pixel - box.right()) / sigma_x, (extremes[3].pixel - box.bottom()) / sigma_y};
  BoxSides sides = view.sides;
  for (size_t side = 0; side < 4; ++side) {
    if (beyond[side] > 2 && view.hidden_probability[side] > 0) sides[side] = BoxSide::kOpen;
  }
  return sides;
}

std::vector<double> DepthFactors(const HypothesisOptions& options) {
  if (options.depth_factor == 1) return {1.0};
  return {1.0, 1 / options.depth_factor, options.depth_factor};
}

// A representative shape of the dictionary under one rotation.
struct Turned {
  int dictionary_index;
  const Eigen::VectorXd& coefficients;
  const Wireframe& wireframe;
  double azimuth;
  const Eigen::Matrix3d& R;
};

Hypothesis At(const Turned& turned, const BoxSides& sides, const Eigen::Vector3d& translation) {
  Hypothesis hypothesis{
      {Eigen::Isometry3d::Identity(), turned.coefficients}, turned.dictionary_index, sides, turned.azimuth};
  hypothesis.start.T_camera_object.linear() = turned.R;
  hypothesis.start.T_camera_object.translation() = translation;
  return hypothesis;
}

void AddBoxHypotheses(const ObjectView& view, const Turned& turned, const std::vector<BoxSides>& variants,
                      const HypothesisOptions& options, std::vector<Hypothesis>& hypotheses) {
  for (const BoxSides& sides : variants) {
    const Eigen::Vector3d T = options.printed_translation
                                  ? PrintedTranslation(view, turned.wireframe, turned.R)
                                  : TranslationFromBox(view, sides, turned.wireframe, turned.R);
    for (const double factor : DepthFactors(options)) hypotheses.push_back(At(turned, sides, factor * T));
  }
}

void AddLineHypotheses(const ObjectView& view, const Turned& turned, const BoxOptions& box_options,
                       std::vector<Hypothesis>& hypotheses) {
  for (const Eigen::Vector3d& T : TranslationsFromLines(view, turned.wireframe, turned.R)) {
    Hypothesis hypothesis = At(turned, view.sides, T);
    hypothesis.sides = SidesFor(view, turned.wireframe, hypothesis.start.T_camera_object, box_options);
    hypotheses.push_back(std::move(hypothesis));
  }
}

void AddMemoryHypotheses(const ObjectView& view, const std::vector<BoxSides>& variants,
                         std::vector<Hypothesis>& hypotheses) {
  const PoseAndShape& expected = view.track_prior->expected;
  const Eigen::Isometry3d& T = expected.T_camera_object;
  const double azimuth = ViewpointFromRotation(T.linear(), T.translation()).azimuth;
  for (const BoxSides& sides : variants) hypotheses.push_back({expected, -1, sides, azimuth});
}

}  // namespace

std::vector<double> CandidateAzimuths(const ObjectView& view, const HypothesisOptions& options) {
  std::vector<double> azimuths;
  if (!view.detection.azimuth) {
    const double all_round = 2 * M_PI / view.model->spec.symmetry_order;
    for (double azimuth = 0; azimuth < all_round - 1e-9; azimuth += kAllRoundStep)
      azimuths.push_back(azimuth);
    return azimuths;
  }
  const double prior = *view.detection.azimuth, spread = options.azimuth_spread_deg * kDegree;
  for (const double offset : Offsets(spread, options.azimuth_step_deg * kDegree))
    azimuths.push_back(prior + offset);
  for (const double azimuth : FindHorizontalAzimuths(view, prior, spread, options.horizontal_peaks)) {
    azimuths.push_back(azimuth);
  }
  return azimuths;
}

std::vector<Hypothesis> MakeHypotheses(const ObjectView& view, const std::vector<Wireframe>& dictionary,
                                       const BoxOptions& box_options, const HypothesisOptions& options) {
  std::vector<Hypothesis> hypotheses;
  const std::vector<BoxSides> variants = SideVariants(view, options);
  const bool seeds_from_lines = NeedsLineSeeds(view);
  if (view.track_prior) AddMemoryHypotheses(view, variants, hypotheses);
  for (const double azimuth : CandidateAzimuths(view, options)) {
    const Eigen::Matrix3d R = RotationAt(view, azimuth);
    for (size_t d = 0; d < dictionary.size(); ++d) {
      const Turned turned{static_cast<int>(d), view.model->dictionary[d], dictionary[d], azimuth, R};
      AddBoxHypotheses(view, turned, variants, options, hypotheses);
      if (seeds_from_lines) AddLineHypotheses(view, turned, box_options, hypotheses);
    }
  }
  return hypotheses;
}

}  // namespace armature
