// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/options.h"

// A row's key is the path of its field in Options; those that only studies turn are under "expert.".
#define OPTION(path, ...) Option(#path, &options.path, __VA_ARGS__)
#define EXPERT_OPTION(path, ...) Option("expert." #path, &options.path, __VA_ARGS__)

namespace armature {
namespace {

using Rows = std::vector<OptionEntry>;

Rows LineRows(Options& options) {
  return {
      OPTION(lines.detector, "line segment detector"),
      OPTION(lines.published, "the detector's published parameters, not those tuned for recall"),
      OPTION(
          lines.edgedrawing_scale,
          "size of the image that the tuned edgedrawing looks at, share of the given one: half is twice as "
          "fast",
          0.2, 1),
      OPTION(lines.min_length, "shortest segment that is used, pixels", 1, 1000),
      OPTION(lines.boxes_only, "look for segments only inside the grown boxes, not in the whole image"),
      OPTION(lines.box_margin, "what a box is grown by on each side, share of its larger side", 0, 1),
  };
}

Rows UpRows(Options& options) {
  return {
      OPTION(
          up.source,
          "where up comes from. auto: the sequence where it says so, else as estimate; estimate: lines and "
          "viewpoints; level: the camera is taken to be level"),
      OPTION(up.viewpoint_sigma_deg,
             "standard deviation of a viewpoint prior's elevation and tilt, degrees; of your detector", 0.1,
             60),
  };
}

Rows FloorRows(Options& options) {
  return {
      OPTION(floor.enabled, "furniture shares one floor, whose distance is learnt"),
      OPTION(floor.initial_height, "height of the camera above the floor before anything is seen, metres", 0,
             100),
      OPTION(floor.initial_sigma, "standard deviation of the initial height, metres", 0.001, 100),
  };
}

Rows TrackRows(Options& options) {
  return {
      OPTION(tracks.enabled, "objects seen in earlier frames are expected where they were"),
      OPTION(tracks.max_gap, "how long an object may be unseen before it is no longer expected, seconds", 0,
             1e6),
  };
}

Rows AssociationRows(Options& options) {
  return {
      OPTION(association.cost,
             "how hypotheses are judged: coverage, or the paper's cost as printed or as meant, with |C2|"),
      OPTION(association.refined_hypotheses,
             "how many of the best hypotheses go on from the search to resection", 1, 1000),
      OPTION(association.rounds, "rounds of association and resection for each of them", 1, 100),
      OPTION(association.occlusion, "objects already found in the image hide those behind them"),
      OPTION(association.hypotheses.use_viewpoint,
             "use the detections' viewpoint priors; without, all azimuths are tried"),
      OPTION(association.hypotheses.horizontal_peaks,
             "how many azimuths are tried on top, where horizontal segments vanish", 0, 20),
      OPTION(association.hypotheses.depth_factor,
             "the box's depth is also tried divided and multiplied by this; 1: not", 1, 4),
      OPTION(association.hypotheses.hidden_sides,
             "also try that something hides the object beyond a side of its box"),
      OPTION(association.hypotheses.printed_translation,
             "the paper's equations of T_z, T_x, T_y, not all sides of the box"),
      OPTION(association.coverage.box_weight,
             "weight of the squared box residuals in cost coverage; 0: the box is not used", 0, 1000),
      OPTION(association.coverage.azimuth_sigma_deg,
             "standard deviation of a viewpoint prior's azimuth, degrees; of your detector", 0.1, 180),
      OPTION(association.coverage.azimuth_outliers,
             "share of viewpoint priors that are simply wrong; of your detector", 1e-6, 1),
      OPTION(association.box.sigma, "standard deviation of a box side, share of the box; of your detector",
             0.001, 1),
      OPTION(association.box.sigma_pixels, "added to the standard deviation of a box side, pixels", 0, 100),
  };
}

Rows ResectionRows(Options& options) {
  return {
      OPTION(resection.mode, "pose and shape jointly, or alternating as in the paper"),
      OPTION(resection.line_term,
             "what keeps an edge on its segment: image, or the paper's planes; these are for "
             "mapping.refinement.rounds 0"),
      OPTION(resection.normal_term,
             "what is kept upright: the object's axis, the normal of its base, or what the paper prints"),
      OPTION(resection.segment_sigma,
             "standard deviation of a segment's end from its edge, pixels; of your detector", 0.01, 100),
      OPTION(resection.box_weight, "weight of the box's residuals; 0: the box is not used", 0, 1000),
      OPTION(resection.up_sigma_deg, "standard deviation of the up direction, degrees", 0.01, 90),
      OPTION(resection.shape_weight,
             "weight of the shape coefficients' distance from the category's mean; large: the mean shape", 0,
             1000),
  };
}

Rows MappingRows(Options& options) {
  return {
      OPTION(mapping.min_observations, "frames that have to see an object before it is in the map", 1, 1000),
      OPTION(mapping.loop_closure, "an object that is seen again after long is the same object"),
      OPTION(mapping.odometry.rotation_sigma_deg,
             "standard deviation of an odometry step's rotation, degrees; of your odometry", 0.0001, 90),
      OPTION(mapping.odometry.translation_sigma,
             "standard deviation of an odometry step's translation, share of its length; of your odometry",
             0.0001, 10),
      OPTION(mapping.odometry.translation_floor,
             "added to the standard deviation of an odometry step's translation, metres", 0.00001, 10),
      OPTION(mapping.association.drift,
             "standard deviation of the odometry's drift, metres a metre travelled; of your odometry", 0, 10),
      OPTION(mapping.association.turn_drift_deg,
             "standard deviation of the odometry's turning, degrees a metre travelled; of your odometry", 0,
             180),
      OPTION(mapping.solver.scale_drift_sigma,
             "standard deviation of the logarithm of the odometry's scale from knot to knot (2 seconds)",
             0.00001, 10),
      OPTION(mapping.solver.upright_sigma_deg,
             "standard deviation of an object's axis from up, degrees; 0: objects may lean", 0, 90),
      OPTION(mapping.solver.floor_sigma,
             "standard deviation of an object's lowest point from the floor, metres; 0: there is no floor", 0,
             10),
      OPTION(mapping.refinement.rounds,
             "rounds of matching all frames' lines anew and solving; 0: single-view estimates alone", 0, 100),
  };
}

Rows ExpertRows(Options& options) {
  return {
      EXPERT_OPTION(association.hypotheses.azimuth_spread_deg,
                    "farthest azimuth that is tried either side of the prior, degrees", 0, 180),
      EXPERT_OPTION(association.hypotheses.azimuth_step_deg,
                    "step between the azimuths that are tried, degrees", 1, 180),
      EXPERT_OPTION(association.max_segments, "most segments of a box that are used, the longest", 3, 100000),
      EXPERT_OPTION(association.search_gate, "distance gate of the search, share of the box's diagonal",
                    0.001, 1),
      EXPERT_OPTION(association.final_gate_pixels, "distance gate of the last round, pixels", 0.5, 100),
      EXPERT_OPTION(association.printed.k1, "weight of C2 in the paper's cost", 0, 1000),
      EXPERT_OPTION(association.printed.k2, "weight of C3 in the paper's cost", 0, 1000),
      EXPERT_OPTION(resection.solver,
                    "solver of mode joint: our own of fixed size, or the reference, ceres::TinySolver"),
      EXPERT_OPTION(resection.max_iterations, "most iterations of the solver in each round", 1, 1000),
      EXPERT_OPTION(resection.alternations, "turns of pose and shape in mode alternating", 1, 100),
      EXPERT_OPTION(mapping.recent_seconds,
                    "how long ago an object is still seen recently, for loop_closure false, seconds", 0.01,
                    10000),
      EXPERT_OPTION(mapping.association.gate,
                    "squared Mahalanobis distance per row below which two objects are joined", 0, 1000),
      EXPERT_OPTION(mapping.refinement.first_gate_pixels,
                    "distance gate of the refinement's first round, pixels", 0.1, 100),
      EXPERT_OPTION(mapping.refinement.last_gate_pixels, "distance gate of its last round, pixels", 0.1, 100),
  };
}

}  // namespace

std::vector<OptionEntry> OptionTable(Options& options) {
  Rows table;
  for (const auto rows :
       {LineRows, UpRows, FloorRows, TrackRows, AssociationRows, ResectionRows, MappingRows, ExpertRows}) {
    for (OptionEntry& row : rows(options)) table.push_back(std::move(row));
  }
  return table;
}

}  // namespace armature

#undef OPTION
#undef EXPERT_OPTION
