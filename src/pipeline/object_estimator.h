// SPDX-License-Identifier: BSD-3-Clause
// One object in one image: association (paper 3.3, Algorithm 1) and resection (3.4) in turn.
#pragma once

#include "association/hypotheses.h"
#include "association/hypothesis_cost.h"
#include "association/printed_cost.h"
#include "base/enum_names.h"
#include "resection/line_resection.h"
#include "resection/single_view_result.h"

namespace armature {

enum class AssociationCost {
  kCoverage,  // what the lines leave unexplained, hypothesis_cost.h
  kPrinted,   // the paper's C1 + k1 C2 + k2 C3
};

template <>
struct EnumNames<AssociationCost> {
  static constexpr NamedValue<AssociationCost> kTable[] = {{AssociationCost::kCoverage, "coverage"},
                                                           {AssociationCost::kPrinted, "printed"}};
};

struct AssociationOptions {
  AssociationCost cost = AssociationCost::kCoverage;
  PrintedCostOptions printed;
  CostOptions coverage;
  HypothesisOptions hypotheses;
  BoxOptions box;
  int refined_hypotheses = 8;  // the best, diverse ones that go on to resection
  double prune_margin =
      3;           // a hypothesis whose cost without lines is this much above the best is not looked at
  int rounds = 4;  // of association and resection each, at most
  double search_gate = 0.04;  // share of the box's diagonal: distance gate of the search and the first round
  double final_gate_pixels = 4;     // distance gate of the last round and of the reported matches
  double search_angle_deg = 10;     // degrees: angle gate of the search
  double final_angle_deg = 6;       // degrees
  double diverse_azimuth_deg = 10;  // degrees: hypotheses closer than this in azimuth and
  double diverse_depth = 0.1;       // this share in depth are the same; only the better is refined
  int max_segments = 80;            // the longest in the box
  int min_edges = 2;                // matched edges, fewer are too few
  double ambiguity_margin =
      1.0;  // half a turn that costs no more than this above the winner, but for the priors of turn
  double max_shape_sigmas = 3;  // a shape with a coefficient beyond this is not believed
  bool occlusion = true;        // objects already found in the image hide those behind them
};

struct EstimatorTimes {
  double association_ms = 0;
  double optimization_ms = 0;
};

SingleViewResult EstimateObject(const ObjectView& view, const AssociationOptions& association,
                                const ResectionOptions& resection, EstimatorTimes& times);

}  // namespace armature
