// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/options.h"

namespace armature {
namespace {

void AddLineOptions(LineOptions& o, std::vector<OptionEntry>& t) {
  t.push_back(Option("association.detector", &o.detector, "line segment detector"));
  t.push_back(Option("lines.published", &o.published,
                     "the detector's published parameters, not those tuned for recall"));
  t.push_back(Option("lines.edgedrawing_scale", &o.edgedrawing_scale,
                     "share of the image's size that the tuned edgedrawing looks at: half is twice as fast",
                     0.2, 1));
  t.push_back(Option("lines.min_length", &o.min_length, "shortest segment, pixels", 1, 1000));
  t.push_back(
      Option("lines.boxes_only", &o.boxes_only, "look only inside the grown boxes, not at the whole image"));
  t.push_back(
      Option("lines.box_margin", &o.box_margin, "a box grows by this share of its larger side", 0, 1));
}

void AddUpOptions(UpOptions& o, std::vector<OptionEntry>& t) {
  t.push_back(
      Option("up.source", &o.source, "auto: the sequence's where given, else estimated; estimate; level"));
  t.push_back(Option("up.window_frames", &o.window_frames, "frames whose evidence is kept", 1, 10000));
  t.push_back(Option("up.segments_per_frame", &o.segments_per_frame, "longest segments that vote, each frame",
                     0, 10000));
  t.push_back(Option("up.cone_deg", &o.cone_deg, "a segment this near to vertical may vote, degrees", 1, 45));
  t.push_back(Option("up.segment_sigma_deg", &o.segment_sigma_deg, "of a vertical segment's plane, degrees",
                     0.01, 20));
  t.push_back(Option("up.viewpoint_sigma_deg", &o.viewpoint_sigma_deg,
                     "of a prior's elevation and tilt, degrees", 0.1, 60));
  t.push_back(Option("up.open_box_sigma_deg", &o.open_box_sigma_deg, "the same where the box is cut, degrees",
                     0.1, 90));
  t.push_back(Option("up.level_sigma_deg", &o.level_sigma_deg, "of a level camera, degrees", 0.1, 90));
}

void AddFloorOptions(FloorOptions& o, std::vector<OptionEntry>& t) {
  t.push_back(Option("floor.enabled", &o.enabled, "furniture shares a floor"));
  t.push_back(Option("floor.initial_height", &o.initial_height,
                     "of the camera before anything is seen, metres", 0, 100));
  t.push_back(Option("floor.initial_sigma", &o.initial_sigma, "of the initial height, metres", 0.001, 100));
  t.push_back(
      Option("floor.drift", &o.drift, "of the camera's height, metres per square root of a second", 0, 10));
  t.push_back(
      Option("floor.climb_error", &o.climb_error, "of the climb that the odometry tells, share", 0, 10));
  t.push_back(
      Option("floor.size_sigma", &o.size_sigma, "of furniture's size about its reference, share", 0, 1));
  t.push_back(Option("floor.min_sigma", &o.min_sigma, "the height is never surer, metres", 0.001, 10));
}

void AddTrackOptions(TrackOptions& o, std::vector<OptionEntry>& t) {
  t.push_back(Option("tracks.enabled", &o.enabled, "objects seen before are expected where they were"));
  t.push_back(Option("tracks.fading", &o.fading, "weight of earlier frames with each new one", 0.1, 1));
  t.push_back(Option("tracks.measurement_scale", &o.measurement_scale,
                     "multiplies resection's standard deviations", 0.1, 100));
  t.push_back(
      Option("tracks.depth_sigma", &o.depth_sigma, "of one view's depth, share of the distance", 0, 1));
  t.push_back(
      Option("tracks.lateral_sigma", &o.lateral_sigma, "across the ray, share of the distance", 0, 1));
  t.push_back(Option("tracks.yaw_sigma_deg", &o.yaw_sigma_deg, "of one view's yaw, degrees", 0, 180));
  t.push_back(Option("tracks.shape_sigma", &o.shape_sigma, "added to one view's shape coefficients", 0, 100));
  t.push_back(Option("tracks.min_yaw_sigma_deg", &o.min_yaw_sigma_deg,
                     "a remembered yaw is never surer, degrees", 0.01, 180));
  t.push_back(
      Option("tracks.min_shape_sigma", &o.min_shape_sigma, "nor a remembered shape coefficient", 0.001, 100));
  t.push_back(Option("tracks.min_relative_sigma", &o.min_relative_sigma,
                     "a remembered position is never surer, share of the distance", 0.001, 1));
  t.push_back(Option("tracks.vote_weight", &o.vote_weight, "of one viewpoint prior", 0, 1));
  t.push_back(
      Option("tracks.min_edges", &o.min_edges, "matched edges of an estimate that is learnt from", 1, 100));
  t.push_back(Option("tracks.min_observations", &o.min_observations, "before a track is used", 1, 1000));
  t.push_back(Option("tracks.max_gap", &o.max_gap, "unseen, before a track is dropped, seconds", 0, 1e6));
}

void AddHypothesisOptions(HypothesisOptions& o, std::vector<OptionEntry>& t) {
  t.push_back(Option("association.use_viewpoint", &o.use_viewpoint, "use the detections' viewpoint priors"));
  t.push_back(Option("association.azimuth_spread_deg", &o.azimuth_spread_deg,
                     "tried either side of the prior, degrees", 0, 180));
  t.push_back(
      Option("association.azimuth_step_deg", &o.azimuth_step_deg, "between azimuths, degrees", 1, 180));
  t.push_back(Option("association.horizontal_peaks", &o.horizontal_peaks,
                     "azimuths tried where horizontal segments vanish", 0, 20));
  t.push_back(Option("association.elevation_spread_deg", &o.elevation_spread_deg,
                     "either side of the prior where up is unknown, degrees", 0, 90));
  t.push_back(Option("association.tilt_spread_deg", &o.tilt_spread_deg,
                     "either side of the prior where up is unknown, degrees", 0, 90));
  t.push_back(Option("association.angle_step_deg", &o.angle_step_deg, "between elevations and tilts, degrees",
                     1, 90));
  t.push_back(Option("association.depth_factor", &o.depth_factor,
                     "the box's depth is also tried divided and multiplied by this", 1, 4));
  t.push_back(Option("association.hidden_sides", &o.hidden_sides,
                     "also try that something hides the object beyond a side of its box"));
  t.push_back(Option("association.line_seeds", &o.line_seeds.enabled,
                     "translations from pairs of segments where the box is cut or hidden"));
  t.push_back(Option("association.line_seed_segments", &o.line_seeds.segments,
                     "longest segments that are tried on every edge", 2, 10000));
  t.push_back(Option("association.line_seed_pairs", &o.line_seeds.pairs,
                     "pairs of edge and segment that are combined", 2, 1000));
  t.push_back(Option("association.line_seed_translations", &o.line_seeds.translations,
                     "kept for each rotation and shape", 1, 1000));
  t.push_back(Option("association.line_seed_angle_deg", &o.line_seeds.max_angle_deg,
                     "between an edge and a segment's plane, degrees", 0.1, 45));
  t.push_back(Option("association.printed_translation", &o.printed_translation,
                     "the paper's T_z, T_x, T_y, not all sides of the box"));
}

void AddCostOptions(AssociationOptions& o, std::vector<OptionEntry>& t) {
  CostOptions& c = o.coverage;
  t.push_back(Option("association.cost", &o.cost, "coverage, or the paper's printed cost"));
  t.push_back(Option("association.k1", &o.printed.k1, "weight of C2 in the printed cost", 0, 1000));
  t.push_back(Option("association.k2", &o.printed.k2, "weight of C3 in the printed cost", 0, 1000));
  t.push_back(Option("association.coverage_weight", &c.coverage_weight,
                     "of the unexplained share of the visible edges", 0, 1000));
  t.push_back(Option("association.length_weight", &c.length_weight,
                     "of the explained length over the box's diagonal", 0, 1000));
  t.push_back(Option("association.box_weight", &c.box_weight, "of the squared box residuals", 0, 1000));
  t.push_back(Option("association.box_loss_scale", &c.box_loss_scale,
                     "of the box residuals, standard deviations", 0.1, 1000));
  t.push_back(Option("association.azimuth_sigma_deg", &c.azimuth_sigma_deg, "of the prior's azimuth, degrees",
                     0.1, 180));
  t.push_back(
      Option("association.azimuth_outliers", &c.azimuth_outliers, "share of priors that are wrong", 1e-6, 1));
  t.push_back(Option("association.azimuth_weight", &c.azimuth_weight,
                     "of the prior's negative log-likelihood", 0, 1000));
  t.push_back(
      Option("association.shape_weight", &c.shape_weight, "of the squared shape coefficients", 0, 1000));
  t.push_back(Option("association.floor_weight", &c.floor_weight, "of the squared floor residual", 0, 1000));
  t.push_back(Option("association.memory_weight", &c.memory_weight,
                     "of the squared distance from the remembered position", 0, 1000));
  t.push_back(Option("association.memory_loss_scale", &c.memory_loss_scale,
                     "of that distance, standard deviations", 0.1, 1000));
  t.push_back(Option("association.yaw_memory_cap", &c.yaw_memory_cap,
                     "the remembered viewpoint priors cost at most this", 0, 1000));
}

void AddAssociationOptions(AssociationOptions& o, std::vector<OptionEntry>& t) {
  AddCostOptions(o, t);
  AddHypothesisOptions(o.hypotheses, t);
  t.push_back(Option("association.cut_tolerance", &o.box.cut_tolerance,
                     "a side this near the border is cut, share of the box", 0, 0.5));
  t.push_back(Option("association.box_sigma", &o.box.sigma, "of a box's side, share of the box", 0.001, 1));
  t.push_back(
      Option("association.box_sigma_pixels", &o.box.sigma_pixels, "of a box's side, added, pixels", 0, 100));
  t.push_back(Option("association.hidden_probability", &o.box.hidden_probability,
                     "of a box's bottom that no other box goes on beyond", 0, 0.99));
  t.push_back(Option("association.hidden_behind_probability", &o.box.hidden_behind_probability,
                     "of a side that another box goes on beyond", 0, 0.99));
  t.push_back(Option("association.refined_hypotheses", &o.refined_hypotheses,
                     "best hypotheses that go on to resection", 1, 1000));
  t.push_back(Option("association.prune_margin", &o.prune_margin,
                     "hypotheses this much above the best without counting lines are not looked at", 0, 1e6));
  t.push_back(Option("association.rounds", &o.rounds, "of association and resection each", 1, 100));
  t.push_back(Option("association.search_gate", &o.search_gate,
                     "distance gate of the search, share of the box's diagonal", 0.001, 1));
  t.push_back(Option("association.final_gate_pixels", &o.final_gate_pixels,
                     "distance gate of the last round, pixels", 0.5, 100));
  t.push_back(Option("association.search_angle_deg", &o.search_angle_deg, "angle gate of the search, degrees",
                     1, 45));
  t.push_back(Option("association.final_angle_deg", &o.final_angle_deg,
                     "angle gate of the last round, degrees", 0.5, 45));
  t.push_back(Option("association.diverse_azimuth_deg", &o.diverse_azimuth_deg,
                     "hypotheses nearer in azimuth are alike, degrees", 0, 180));
  t.push_back(Option("association.diverse_depth", &o.diverse_depth,
                     "hypotheses nearer in depth are alike, share", 0, 1));
  t.push_back(Option("association.max_segments", &o.max_segments, "longest segments of a box that are used",
                     3, 100000));
  t.push_back(Option("association.min_edges", &o.min_edges, "matched edges, fewer are too few", 1, 100));
  t.push_back(Option("association.ambiguity_margin", &o.ambiguity_margin,
                     "half a turn costing no more than this above the winner is marked ambiguous", 0, 1e6));
  t.push_back(Option("association.max_shape_sigmas", &o.max_shape_sigmas,
                     "a shape with a coefficient beyond this is not believed", 0.1, 100));
  t.push_back(Option("association.occlusion", &o.occlusion, "objects already found hide those behind them"));
}

void AddResectionOptions(ResectionOptions& o, std::vector<OptionEntry>& t) {
  t.push_back(Option("resection.mode", &o.mode, "pose and shape jointly, or alternating as in the paper"));
  t.push_back(Option("resection.solver", &o.solver,
                     "of mode joint: our own of fixed size, or the reference, ceres::TinySolver"));
  t.push_back(Option("resection.normal_term", &o.normal_term, "what is kept upright"));
  t.push_back(Option("resection.max_iterations", &o.max_iterations, "of the optimiser, each round", 1, 1000));
  t.push_back(
      Option("resection.alternations", &o.alternations, "of pose and shape in mode alternating", 1, 100));
  t.push_back(Option("resection.segment_sigma", &o.segment_sigma, "of a segment's end, pixels", 0.01, 100));
  t.push_back(Option("resection.leg_end_sigma", &o.leg_end_sigma,
                     "of where a leg's segments end, in segment_sigma, for the map; 0: not used", 0, 100));
  t.push_back(Option("resection.full_length", &o.full_length,
                     "length from which a segment has full weight, pixels", 1, 10000));
  t.push_back(
      Option("resection.loss_scale", &o.loss_scale, "of the robust loss, standard deviations", 0.1, 1e6));
  t.push_back(Option("resection.box_weight", &o.box_weight, "of the box's residuals", 0, 1000));
  t.push_back(Option("resection.box_loss_scale", &o.box_loss_scale,
                     "of the box's residuals, standard deviations", 0.1, 1e6));
  t.push_back(Option("resection.up_sigma_deg", &o.up_sigma_deg, "of the up direction, degrees", 0.01, 90));
  t.push_back(Option("resection.shape_weight", &o.shape_weight, "of the shape coefficients", 0, 1000));
}

void AddNoiseOptions(const std::string& key, FactorNoise& o, std::vector<OptionEntry>& t) {
  t.push_back(Option(key + ".measurement_scale", &o.measurement_scale,
                     "multiplies the standard deviations of lines and box", 0.1, 100));
  t.push_back(
      Option(key + ".depth_sigma", &o.depth_sigma, "along the ray, share of the distance", 0.0001, 1));
  t.push_back(
      Option(key + ".lateral_sigma", &o.lateral_sigma, "across the ray, share of the distance", 0.0001, 1));
  t.push_back(
      Option(key + ".rotation_sigma_deg", &o.rotation_sigma_deg, "of the rotation, degrees", 0.01, 180));
  t.push_back(Option(key + ".shape_sigma", &o.shape_sigma, "of the shape's coefficients", 0.001, 100));
}

void AddMappingOptions(MappingOptions& o, std::vector<OptionEntry>& t) {
  t.push_back(Option("mapping.first_solve", &o.first_solve, "frames after which the map is first solved", 1,
                     1000000));
  t.push_back(Option("mapping.solve_growth", &o.solve_growth,
                     "it is solved again when there are this many times more", 1.01, 1000));
  t.push_back(Option("mapping.min_observations", &o.min_observations,
                     "frames that see an object before it is kept", 1, 1000));
  t.push_back(Option("mapping.knot_seconds", &o.knot_seconds, "between the knots of the odometry's scale",
                     0.1, 1000));
  t.push_back(Option("mapping.odometry.rotation_sigma_deg", &o.odometry.rotation_sigma_deg,
                     "of each step, degrees", 0.0001, 90));
  t.push_back(Option("mapping.odometry.translation_sigma", &o.odometry.translation_sigma,
                     "of each step, share of its length", 0.0001, 10));
  t.push_back(Option("mapping.odometry.translation_floor", &o.odometry.translation_floor,
                     "added to it, metres", 0.00001, 10));
  t.push_back(
      Option("mapping.up_sigma_deg", &o.up_sigma_deg, "least standard deviation of up, degrees", 0.01, 90));
  AddNoiseOptions("mapping.view_noise", o.view_noise, t);
  t.push_back(
      Option("mapping.loop_closure", &o.loop_closure, "objects seen again later are the same objects"));
  t.push_back(Option("mapping.recent_seconds", &o.recent_seconds,
                     "objects unseen for longer are not seen recently", 0.01, 10000));
  t.push_back(Option("mapping.association.gate", &o.association.gate,
                     "squared Mahalanobis distance per row that joins two objects", 0, 1000));
  t.push_back(Option("mapping.association.overlap", &o.association.overlap,
                     "or this intersection over union of their boxes", 0, 1));
  t.push_back(Option("mapping.association.together", &o.association.together,
                     "frames that may show both nevertheless", 0, 1000));
  t.push_back(Option("mapping.association.drift", &o.association.drift,
                     "of the odometry, share of the way travelled", 0, 10));
  t.push_back(Option("mapping.association.turn_drift_deg", &o.association.turn_drift_deg,
                     "of the odometry, degrees a metre travelled", 0, 180));
  t.push_back(Option("mapping.association.box_overlap", &o.association.box_overlap,
                     "of a detection's box and an object's projection", 0, 1));
  t.push_back(Option("mapping.max_iterations", &o.solver.max_iterations, "of the solver", 1, 1000));
  t.push_back(
      Option("mapping.loss_scale", &o.solver.loss_scale, "of the robust loss on an observation", 0.1, 1000));
  t.push_back(
      Option("mapping.shape_weight", &o.solver.shape_weight, "of the category's shape statistics", 0, 100));
  t.push_back(Option("mapping.upright_sigma_deg", &o.solver.upright_sigma_deg,
                     "of objects about up, degrees; 0: none", 0, 90));
  t.push_back(Option("mapping.floor_sigma", &o.solver.floor_sigma,
                     "of the floor below objects, metres; 0: none", 0, 10));
  t.push_back(Option("mapping.min_scale_sigma", &o.solver.min_scale_sigma,
                     "of the scale's logarithm: what the front end has learnt is never surer", 0.0001, 10));
  t.push_back(Option("mapping.scale_drift_sigma", &o.solver.scale_drift_sigma,
                     "of the scale's logarithm from knot to knot", 0.00001, 10));
  t.push_back(Option("mapping.refinement.rounds", &o.refinement.rounds,
                     "of matching all frames' lines anew; 0: none", 0, 100));
  t.push_back(Option("mapping.refinement.iterations", &o.refinement.iterations, "of the solver in each round",
                     1, 1000));
  t.push_back(Option("mapping.refinement.first_gate_pixels", &o.refinement.first_gate_pixels,
                     "distance gate of the first round", 0.1, 100));
  t.push_back(Option("mapping.refinement.last_gate_pixels", &o.refinement.last_gate_pixels,
                     "distance gate of the last round", 0.1, 100));
  t.push_back(Option("mapping.refinement.first_box_loss_scale", &o.refinement.first_box_loss_scale,
                     "of the box in the first round, standard deviations", 0.1, 1000));
  t.push_back(Option("mapping.refinement.gate_angle_deg", &o.refinement.gate_angle_deg, "angle gate, degrees",
                     0.1, 90));
  t.push_back(Option("mapping.refinement.min_edges", &o.refinement.min_edges,
                     "matched edges, fewer say nothing", 1, 100));
  AddNoiseOptions("mapping.refinement.noise", o.refinement.noise, t);
}

}  // namespace

std::vector<OptionEntry> OptionTable(Options& options) {
  std::vector<OptionEntry> table;
  AddLineOptions(options.lines, table);
  AddUpOptions(options.up, table);
  AddFloorOptions(options.floor, table);
  AddTrackOptions(options.tracks, table);
  AddAssociationOptions(options.association, table);
  AddResectionOptions(options.resection, table);
  AddMappingOptions(options.mapping, table);
  return table;
}

}  // namespace armature
