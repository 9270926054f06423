// SPDX-License-Identifier: BSD-3-Clause
// What `armature learn` prints.
#pragma once

#include <string>
#include <vector>

#include "category/category_model.h"
#include "category/held_out.h"

namespace armature {

struct LearnReport {
  CategoryModel model;
  int models_read = 0;  // before implausible ones were left out
  int held_out_every = 0;
  std::vector<HeldOutRow> held_out;
  std::string out;  // the file written, empty: none
};

std::string ReportText(const LearnReport& report);
std::string ReportJson(const LearnReport& report);

}  // namespace armature
