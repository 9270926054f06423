// SPDX-License-Identifier: BSD-3-Clause
#include "eval/retrieval/retrieval_variant_tables.h"

#include <fmt/format.h>

#include "eval/retrieval/retrieval_cells.h"

namespace armature {
namespace {

std::vector<Cell> VariantRow(const std::string& category, const EvaluatedVariant& variant,
                             const QuerySet& queries) {
  const RetrievalSummary s = Summarise(Chosen(variant.outcomes, queries));
  std::vector<Cell> row{TextCell(category), TextCell(variant.variant.name)};
  PushRanks(s, row);
  row.push_back(NumberCell(s.median_rank, 1));
  PushDistances(s, row);
  row.push_back(NumberCell(s.f_score, 3));
  return row;
}

void PushVariants(const EvaluatedQueries& evaluated, const std::vector<CategoryModel>& models, Table& table) {
  table.columns = {"category",  "variant",       "queries",     "in library", "top-1 [%]",
                   "top-5 [%]", "MRR",           "median rank", "compared",   "Chamfer [cm]",
                   "best of 5", "by true shape", "ratio",       "F-score"};
  const QuerySet all = AllQueries(evaluated);
  for (const CategoryModel& model : models) {
    const QuerySet queries = Where(evaluated, all, &RetrievalQuery::category, model.spec.name);
    for (const EvaluatedVariant& variant : evaluated.variants) {
      if (queries.empty() || !IsDistinct(variant.variant, model.modes())) continue;
      table.rows.push_back(VariantRow(model.spec.name, variant, queries));
    }
  }
}

std::vector<std::string> VariantNotes() {
  return {
      "k-NN: nearest by the coefficients; raw: in metres of the modes; whitened: in standard deviations; "
      "with size: the bounding box's size as three more dimensions; first n modes: without the others.",
      "F-score: at 2 cm, of the first retrieved."};
}

}  // namespace

Table RetrievalVariantTable(const EvaluatedQueries& evaluated, const std::vector<CategoryModel>& models) {
  Table table;
  table.title = "CAD retrieval by variant, all sequences";
  table.name = "retrieval_variants";
  PushVariants(evaluated, models, table);
  AppendNotes(VariantNotes(), table);
  AppendNotes(
      {fmt::format(
          "covariance: distances weighed with that of the estimated coefficients. re-ranked: the first {} "
          "by how well their own edges explain the images.",
          RetrievalOptions().candidates)},
      table);
  AppendNotes(RankNotes(), table);
  AppendNotes(DistanceNotes(), table);
  return table;
}

Table LibraryTable(const EvaluatedQueries& evaluated, const std::vector<CategoryModel>& models,
                   const InstanceLibrary& library, const std::string& asked) {
  Table table;
  table.title = "CAD retrieval by known coefficients with noise, no images";
  table.name = "library";
  PushVariants(evaluated, models, table);
  std::vector<std::string> sizes;
  for (const CategoryInstances& instances : library.categories)
    sizes.push_back(fmt::format("{} {}", instances.size(), instances.category));
  table.notes = {fmt::format("queries: {}. instances: {}.", asked, fmt::join(sizes, ", "))};
  AppendNotes(VariantNotes(), table);
  AppendNotes(RankNotes(), table);
  AppendNotes(DistanceNotes(), table);
  return table;
}

}  // namespace armature
