// SPDX-License-Identifier: BSD-3-Clause
// What an evaluation leaves: tables for readers, records for programs.
#pragma once

#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "io/evaluation_records.h"
#include "io/text_table.h"

namespace armature {

struct Evaluation {
  std::vector<Table> tables{};
  EvaluationRecords records{};
  std::vector<std::string> failures{};  // lines: what could not be compared, beside what could

  void Append(Evaluation more) {
    std::move(more.tables.begin(), more.tables.end(), std::back_inserter(tables));
    AppendRecords(std::move(more.records), records);
    std::move(more.failures.begin(), more.failures.end(), std::back_inserter(failures));
  }
};

}  // namespace armature
