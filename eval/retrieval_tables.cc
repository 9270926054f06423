// SPDX-License-Identifier: BSD-3-Clause
#include "eval/retrieval_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <stdexcept>

#include "eval/retrieval_summary.h"

namespace armature {
namespace {

// Positions of queries.
using QuerySet = std::vector<size_t>;

// A query's field by which rows are made.
using QueryField = std::string RetrievalQuery::*;

QuerySet AllQueries(const EvaluatedQueries& evaluated) {
  QuerySet all(evaluated.queries.size());
  for (size_t i = 0; i < all.size(); ++i) all[i] = i;
  return all;
}

QuerySet Where(const EvaluatedQueries& evaluated, const QuerySet& among, QueryField field,
               const std::string& value) {
  QuerySet chosen;
  for (const size_t i : among) {
    if (evaluated.queries[i].*field == value) chosen.push_back(i);
  }
  return chosen;
}

// In the order in which they are met.
std::vector<std::string> ValuesOf(const EvaluatedQueries& evaluated, const QuerySet& among,
                                  QueryField field) {
  std::vector<std::string> values;
  for (const size_t i : among) {
    const std::string& value = evaluated.queries[i].*field;
    if (std::find(values.begin(), values.end(), value) == values.end()) values.push_back(value);
  }
  return values;
}

std::vector<std::string> CategoriesAmong(const EvaluatedQueries& evaluated, const QuerySet& among) {
  std::vector<std::string> categories = ValuesOf(evaluated, among, &RetrievalQuery::category);
  std::sort(categories.begin(), categories.end());
  return categories;
}

template <typename T>
std::vector<T> Chosen(const std::vector<T>& of_all, const QuerySet& chosen) {
  std::vector<T> some;
  for (const size_t i : chosen) some.push_back(of_all[i]);
  return some;
}

Cell Centimetres(const std::optional<double>& metres) {
  return metres ? NumberCell(100 * *metres, 2) : NoCell();
}

void PushRanks(const RetrievalSummary& s, std::vector<Cell>& row) {
  row.push_back(CountCell(s.queries));
  row.push_back(CountCell(s.in_library));
  row.push_back(PercentCell(s.top_1, s.in_library));
  row.push_back(PercentCell(s.top_5, s.in_library));
  row.push_back(NumberCell(s.mean_reciprocal_rank, 3));
}

void PushDistances(const RetrievalSummary& s, std::vector<Cell>& row) {
  row.push_back(Centimetres(s.chamfer));
  row.push_back(Centimetres(s.best_of_five));
  row.push_back(Centimetres(s.by_truth));
  row.push_back(NumberCell(s.ratio, 2));
}

std::vector<Cell> SummaryCells(std::vector<Cell> row, const EvaluatedQueries& evaluated,
                               const QuerySet& queries) {
  const RetrievalSummary s = Summarise(Chosen(evaluated.OutcomesOf(kDefaultVariant), queries));
  const BaselineSummary baselines = Summarise(Chosen(evaluated.baselines, queries));
  PushRanks(s, row);
  PushDistances(s, row);
  row.push_back(Centimetres(baselines.random));
  row.push_back(Centimetres(baselines.mean_shape));
  row.push_back(NumberCell(s.f_score, 3));
  row.push_back(NumberCell(s.f_score_by_truth, 3));
  return row;
}

// A row a category, and one of all of them where they are several.
void PushCategories(const std::string& run, const std::string& sequence, const EvaluatedQueries& evaluated,
                    const QuerySet& among, Table& table) {
  const std::vector<std::string> categories = CategoriesAmong(evaluated, among);
  const auto push = [&](const std::string& category, const QuerySet& queries) {
    table.rows.push_back(
        SummaryCells({TextCell(run), TextCell(sequence), TextCell(category)}, evaluated, queries));
  };
  for (const std::string& category : categories)
    push(category, Where(evaluated, among, &RetrievalQuery::category, category));
  if (categories.size() > 1) push("all", among);
}

const std::vector<std::string> kRankNotes = {
    "in library: queries whose true CAD model is in the library; the rank of the true model among all",
    "  instances of the category is over them: top-1, top-5: share of ranks 1, of ranks up to 5. MRR: mean "
    "of 1 / rank."};

std::vector<std::string> DistanceNotes(const EvaluatedQueries& evaluated) {
  const std::vector<RetrievalOutcome>& outcomes = evaluated.variants.front().outcomes;
  const int compared = Summarise(outcomes).compared;
  std::vector<std::string> notes = {
      "Chamfer [cm]: the true model left out, as if the library did not have it: mean distance from points "
      "on "
      "the",
      "  retrieved surface to the true one and back, their mean. Both in the object frame, axes aligned and "
      "centred",
      "  on their edges' bounding boxes, the true model in the true object's size; nothing else is aligned.",
      "best of 5: the nearest surface of the first five. by true shape: what plain k-NN of the same space "
      "finds "
      "for",
      "  the true object's coefficients: the best it could do. ratio: Chamfer / by true shape, of the "
      "means."};
  if (const int without = static_cast<int>(outcomes.size()) - compared; without > 0) {
    notes.push_back(fmt::format(
        "{} of {} queries are not in Chamfer and F-score: a model's surface is not there, or not known.",
        without, outcomes.size()));
  }
  return notes;
}

void Append(const std::vector<std::string>& more, std::vector<std::string>& notes) {
  notes.insert(notes.end(), more.begin(), more.end());
}

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
  table.columns = {"category",      "variant", "queries",     "in library",   "top-1 [%]",
                   "top-5 [%]",     "MRR",     "median rank", "Chamfer [cm]", "best of 5",
                   "by true shape", "ratio",   "F-score"};
  const QuerySet all = AllQueries(evaluated);
  for (const CategoryModel& model : models) {
    const QuerySet queries = Where(evaluated, all, &RetrievalQuery::category, model.spec.name);
    for (const EvaluatedVariant& variant : evaluated.variants) {
      if (queries.empty() || !IsDistinct(variant.variant, model.modes())) continue;
      table.rows.push_back(VariantRow(model.spec.name, variant, queries));
    }
  }
}

const std::vector<std::string> kVariantNotes = {
    "k-NN: nearest by the coefficients; raw: in metres of the modes, whitened: in standard deviations, with "
    "size: "
    "the",
    "  bounding box's size as three more dimensions; first n modes: the later ones left out. F-score: at 2 "
    "cm."};

Cell RankCell(const std::optional<int>& rank) { return rank ? CountCell(*rank) : NoCell(); }

std::string IdOf(const InstanceLibrary& library, const std::string& category, int instance) {
  const CategoryInstances* instances = library.Of(category);
  return instances && instance >= 0 ? instances->ids[static_cast<size_t>(instance)] : "";
}

}  // namespace

const std::vector<RetrievalOutcome>& EvaluatedQueries::OutcomesOf(const std::string& variant) const {
  for (const EvaluatedVariant& evaluated : variants) {
    if (evaluated.variant.name == variant) return evaluated.outcomes;
  }
  throw std::logic_error("not evaluated: " + variant);
}

Table RetrievalTable(const EvaluatedQueries& evaluated) {
  Table table;
  table.title = "CAD retrieval";
  table.columns = {"run",          "sequence",   "category",      "queries",
                   "in library",   "top-1 [%]",  "top-5 [%]",     "MRR",
                   "Chamfer [cm]", "best of 5",  "by true shape", "ratio",
                   "random",       "mean shape", "F-score",       "F-score by true shape"};
  const QuerySet all = AllQueries(evaluated);
  for (const std::string& run : ValuesOf(evaluated, all, &RetrievalQuery::run)) {
    const QuerySet of_run = Where(evaluated, all, &RetrievalQuery::run, run);
    const std::vector<std::string> sequences = ValuesOf(evaluated, of_run, &RetrievalQuery::sequence);
    for (const std::string& sequence : sequences)
      PushCategories(run, sequence, evaluated, Where(evaluated, of_run, &RetrievalQuery::sequence, sequence),
                     table);
    if (sequences.size() > 1) PushCategories(run, "all", evaluated, of_run, table);
  }
  table.notes = {
      "queries: objects of the map; the true one is that of most of its observations, wherever it stands."};
  Append(kRankNotes, table.notes);
  Append(DistanceNotes(evaluated), table.notes);
  Append({"random: expected Chamfer of a random pick of the others. mean shape: Chamfer of the one nearest "
          "to the",
          "  category's mean shape. F-score: at 2 cm; the share of the retrieved surface's points within 2 "
          "cm of the "
          "true",
          "  one and the share the other way, their harmonic mean."},
         table.notes);
  return table;
}

Table RetrievalVariantTable(const EvaluatedQueries& evaluated, const std::vector<CategoryModel>& models) {
  Table table;
  table.title = "CAD retrieval by variant, all sequences";
  PushVariants(evaluated, models, table);
  table.notes = kVariantNotes;
  Append({"covariance: distances weighed with the covariance of the estimated coefficients. re-ranked: the "
          "first by "
          "how well",
          "  their own edges explain the images."},
         table.notes);
  Append(kRankNotes, table.notes);
  Append(DistanceNotes(evaluated), table.notes);
  return table;
}

Table EachQueryTable(const EvaluatedQueries& evaluated, const InstanceLibrary& library) {
  Table table;
  table.title = "CAD retrieval of each object";
  table.columns = {"run",         "sequence",        "object",         "true model",
                   "rank k-NN",   "rank covariance", "rank re-ranked", "first other",
                   "Chamfer [cm]"};
  const auto& plain = evaluated.OutcomesOf(kPlainVariant);
  const auto& covariance = evaluated.OutcomesOf(kCovarianceVariant);
  const auto& reranked = evaluated.OutcomesOf(kDefaultVariant);
  for (size_t i = 0; i < evaluated.queries.size(); ++i) {
    const RetrievalQuery& query = evaluated.queries[i];
    const std::optional<SurfaceDistance>& distance = reranked[i].retrieved;
    table.rows.push_back({TextCell(query.run), TextCell(query.sequence), TextCell(query.object),
                          TextCell(query.true_model), RankCell(plain[i].rank), RankCell(covariance[i].rank),
                          RankCell(reranked[i].rank),
                          TextCell(IdOf(library, query.category, reranked[i].first_other)),
                          distance ? Centimetres(distance->chamfer) : NoCell()});
  }
  table.notes = {
      "rank: of the true model among all of its category; -: it is not in the library. k-NN: whitened.",
      "first other: the first of the re-ranked with the true model left out, and its Chamfer distance."};
  return table;
}

Table LibraryTable(const EvaluatedQueries& evaluated, const std::vector<CategoryModel>& models,
                   const InstanceLibrary& library, const std::string& asked) {
  Table table;
  table.title = "CAD retrieval by known coefficients with noise, no images";
  PushVariants(evaluated, models, table);
  std::vector<std::string> sizes;
  for (const CategoryInstances& instances : library.categories)
    sizes.push_back(fmt::format("{} {}", instances.size(), instances.category));
  table.notes = {fmt::format("queries: {}; instances: {}.", asked, fmt::join(sizes, ", "))};
  Append(kVariantNotes, table.notes);
  Append(kRankNotes, table.notes);
  Append(DistanceNotes(evaluated), table.notes);
  return table;
}

}  // namespace armature
