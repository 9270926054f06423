// SPDX-License-Identifier: BSD-3-Clause
// The tables of ways of retrieval beside each other that `armature eval` prints.
#pragma once

#include <string>
#include <vector>

#include "category/category_model.h"
#include "eval/retrieval/evaluated_queries.h"
#include "io/text_table.h"

namespace armature {

// A row a category and variant, over all runs and sequences. Variants that are no other ones for a category
// of few modes are left out.
Table RetrievalVariantTable(const EvaluatedQueries& evaluated, const std::vector<CategoryModel>& models);

// The same of queries of the library alone. `asked`: what was asked.
Table LibraryTable(const EvaluatedQueries& evaluated, const std::vector<CategoryModel>& models,
                   const InstanceLibrary& library, const std::string& asked);

}  // namespace armature
