// SPDX-License-Identifier: BSD-3-Clause
// The matrix as tables: a row a sequence and variant, whatever became of it.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/reproduce/job.h"
#include "app/reproduce/matrix.h"
#include "io/text_table.h"

namespace armature {

// Numbers of the tables of an eval.json.
class EvaluatedNumbers {
 public:
  // `eval`: content of eval.json; null: there is none.
  explicit EvaluatedNumbers(nlohmann::json eval) : eval_(std::move(eval)) {}

  // In the first row of this table and sequence that has all these cells; none: there is no such row or
  // number.
  using Where = std::vector<std::pair<std::string, std::string>>;
  std::optional<double> Of(const std::string& table, const std::string& sequence, const Where& cells,
                           const std::string& column) const;

 private:
  nlohmann::json eval_;
};

// Objects found and their errors, cameras' errors, single views, and why there is nothing where a job failed.
Table MatrixTable(const Matrix& matrix, const std::vector<JobRecord>& records,
                  const EvaluatedNumbers& numbers);

// Mean and spread over the draws of each scene; none with one draw.
std::optional<Table> DrawsTable(const Matrix& matrix, const EvaluatedNumbers& numbers);

// What was done: a row a job.
Table JobTable(const std::vector<JobRecord>& records);

}  // namespace armature
