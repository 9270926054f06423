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
  kPrinted,   // the paper's C1 + k1 C2 + k2 C3, printed_cost.h
  kMeant,     // the same with |C2|
};

template <>
struct EnumNames<AssociationCost> {
  static constexpr NamedValue<AssociationCost> kTable[] = {{AssociationCost::kCoverage, "coverage"},
                                                           {AssociationCost::kPrinted, "printed"},
                                                           {AssociationCost::kMeant, "meant"}};
};

struct AssociationOptions {
  AssociationCost cost = AssociationCost::kCoverage;
  PrintedCostOptions printed;
  CostOptions coverage;
  HypothesisOptions hypotheses;
  BoxOptions box;
  int refined_hypotheses = 8;  // the best, diverse ones that go on to resection
  int rounds = 4;              // of association and resection each, at most
  double search_gate = 0.04;   // share of the box's diagonal: distance gate of the search and the first round
  double final_gate_pixels = 4;  // distance gate of the last round and of the reported matches
  int max_segments = 80;         // the longest in the box
  bool occlusion = true;         // objects already found in the image hide those behind them
};

// Angle gates of the search and of the last round, degrees; tuned on office_dev and redkitchen_a.
inline constexpr double kSearchAngleDeg = 10, kFinalAngleDeg = 6;

SingleViewResult EstimateObject(const ObjectView& view, const AssociationOptions& association,
                                const ResectionOptions& resection);

}  // namespace armature
