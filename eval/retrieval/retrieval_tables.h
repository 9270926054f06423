// SPDX-License-Identifier: BSD-3-Clause
// The tables of retrieval of runs that `armature eval` prints.
#pragma once

#include "eval/retrieval/evaluated_queries.h"
#include "io/evaluation_records.h"
#include "io/text_table.h"

namespace armature {

// The default variant with the baselines: a record a run, sequence and category, and records of all.
std::vector<RetrievalRecord> MakeRetrievalRecords(const EvaluatedQueries& evaluated);

// The same as a table: a row a run, sequence and category, and rows of all.
Table RetrievalTable(const EvaluatedQueries& evaluated);

// A row a query: ranks by the plain, the covariance's and the default variant.
Table EachQueryTable(const EvaluatedQueries& evaluated, const InstanceLibrary& library);

}  // namespace armature
