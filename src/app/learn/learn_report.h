// SPDX-License-Identifier: BSD-3-Clause
// What `armature learn` prints.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "category/category_model.h"
#include "category/held_out.h"
#include "category/set_comparison.h"

namespace armature {

// The set that was learnt from and another one, in the modes of the model.
struct ComparisonReport {
  SetStatistics own, other;
  std::string other_source;
  int other_read = 0;  // before implausible ones were left out
};

struct LearnReport {
  CategoryModel model;
  int models_read = 0;  // before implausible ones were left out
  int held_out_every = 0;
  std::vector<HeldOutRow> held_out;
  std::optional<ComparisonReport> comparison;
  std::string out;      // the file written, empty: none
  std::string library;  // the library written, empty: none
};

std::string ReportText(const LearnReport& report);
std::string ReportJson(const LearnReport& report);

}  // namespace armature
