// SPDX-License-Identifier: BSD-3-Clause
// The tables of retrieval that `armature eval` prints.
#pragma once

#include <string>
#include <vector>

#include "category/category_model.h"
#include "eval/retrieval_evaluation.h"
#include "eval/retrieval_variants.h"
#include "io/text_table.h"

namespace armature {

struct EvaluatedVariant {
  RetrievalVariant variant;
  std::vector<RetrievalOutcome> outcomes;  // one a query
};

// Queries, and what became of them.
struct EvaluatedQueries {
  std::vector<RetrievalQuery> queries;
  std::vector<EvaluatedVariant> variants;
  std::vector<RetrievalBaselines> baselines{};  // one a query; empty: not asked for

  // Throws std::logic_error when it was not evaluated.
  const std::vector<RetrievalOutcome>& OutcomesOf(const std::string& variant) const;
};

// The default variant with the baselines: a row a run, sequence and category, and rows of all.
Table RetrievalTable(const EvaluatedQueries& evaluated);

// A row a category and variant, over all runs and sequences. Variants that are no other ones for a category
// of few modes are left out.
Table RetrievalVariantTable(const EvaluatedQueries& evaluated, const std::vector<CategoryModel>& models);

// A row a query: ranks by the plain, the covariance's and the default variant.
Table EachQueryTable(const EvaluatedQueries& evaluated, const InstanceLibrary& library);

// As RetrievalVariantTable, of queries of the library alone. `asked`: what was asked.
Table LibraryTable(const EvaluatedQueries& evaluated, const std::vector<CategoryModel>& models,
                   const InstanceLibrary& library, const std::string& asked);

}  // namespace armature
