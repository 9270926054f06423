// SPDX-License-Identifier: BSD-3-Clause
#include "eval/retrieval/retrieval_tables.h"

#include <algorithm>

#include "eval/retrieval/retrieval_cells.h"

namespace armature {
namespace {

std::vector<std::string> CategoriesAmong(const EvaluatedQueries& evaluated, const QuerySet& among) {
  std::vector<std::string> categories = CollectValues(evaluated, among, &RetrievalQuery::category);
  std::sort(categories.begin(), categories.end());
  return categories;
}

std::optional<double> ComputeShare(int part, int whole) {
  return whole > 0 ? std::optional(static_cast<double>(part) / whole) : std::nullopt;
}

RetrievalRecord MakeRecord(const std::string& run, const std::optional<std::string>& sequence,
                           const std::optional<std::string>& category, const EvaluatedQueries& evaluated,
                           const QuerySet& queries) {
  const RetrievalSummary s = Summarise(Chosen(evaluated.GetOutcomes(kDefaultVariant), queries));
  const BaselineSummary baselines = Summarise(Chosen(evaluated.baselines, queries));
  return {.sequence = sequence,
          .run = run,
          .category = category,
          .queries = s.queries,
          .in_library = s.in_library,
          .top_1_share = ComputeShare(s.top_1, s.in_library),
          .top_5_share = ComputeShare(s.top_5, s.in_library),
          .mean_reciprocal_rank = s.mean_reciprocal_rank,
          .compared = s.compared,
          .chamfer_m = s.chamfer,
          .best_of_five_chamfer_m = s.best_of_five,
          .by_true_shape_chamfer_m = s.by_truth,
          .chamfer_ratio = s.ratio,
          .random_chamfer_m = baselines.random,
          .mean_shape_chamfer_m = baselines.mean_shape,
          .f_score = s.f_score,
          .f_score_by_true_shape = s.f_score_by_truth};
}

std::vector<Cell> SummaryCells(const RetrievalRecord& r) {
  std::vector<Cell> row{TextCell(r.run),
                        TextCell(r.sequence.value_or("all")),
                        TextCell(r.category.value_or("all")),
                        CountCell(r.queries),
                        CountCell(r.in_library),
                        ShareCell(r.top_1_share, r.in_library),
                        ShareCell(r.top_5_share, r.in_library),
                        NumberCell(r.mean_reciprocal_rank, 3),
                        CountCell(r.compared)};
  for (const auto& metres : {r.chamfer_m, r.best_of_five_chamfer_m, r.by_true_shape_chamfer_m})
    row.push_back(Centimetres(metres));
  row.push_back(NumberCell(r.chamfer_ratio, 2));
  row.push_back(Centimetres(r.random_chamfer_m));
  row.push_back(Centimetres(r.mean_shape_chamfer_m));
  row.push_back(NumberCell(r.f_score, 3));
  row.push_back(NumberCell(r.f_score_by_true_shape, 3));
  return row;
}

std::vector<std::string> SummaryColumns() {
  return {"run",
          "sequence",
          "category",
          "queries",
          "in library",
          "top-1 [%]",
          "top-5 [%]",
          "MRR",
          "compared",
          "Chamfer [cm]",
          "best of 5",
          "by true shape",
          "ratio",
          "random",
          "mean shape",
          "F-score",
          "F-score by true shape"};
}

// A record a category, and one of all of them where they are several.
void PushCategories(const std::string& run, const std::optional<std::string>& sequence,
                    const EvaluatedQueries& evaluated, const QuerySet& among,
                    std::vector<RetrievalRecord>& records) {
  const std::vector<std::string> categories = CategoriesAmong(evaluated, among);
  for (const std::string& category : categories)
    records.push_back(MakeRecord(run, sequence, category, evaluated,
                                 Where(evaluated, among, &RetrievalQuery::category, category)));
  if (categories.size() > 1) records.push_back(MakeRecord(run, sequence, std::nullopt, evaluated, among));
}

Cell RankCell(const std::optional<int>& rank) { return rank ? CountCell(*rank) : NoCell(); }

std::string FindId(const InstanceLibrary& library, const std::string& category, int instance) {
  const CategoryInstances* instances = library.Of(category);
  return instances && instance >= 0 ? instances->ids[static_cast<size_t>(instance)] : "";
}

}  // namespace

std::vector<RetrievalRecord> MakeRetrievalRecords(const EvaluatedQueries& evaluated) {
  std::vector<RetrievalRecord> records;
  const QuerySet all = AllQueries(evaluated);
  for (const std::string& run : CollectValues(evaluated, all, &RetrievalQuery::run)) {
    const QuerySet of_run = Where(evaluated, all, &RetrievalQuery::run, run);
    const std::vector<std::string> sequences = CollectValues(evaluated, of_run, &RetrievalQuery::sequence);
    for (const std::string& sequence : sequences)
      PushCategories(run, sequence, evaluated, Where(evaluated, of_run, &RetrievalQuery::sequence, sequence),
                     records);
    if (sequences.size() > 1) PushCategories(run, std::nullopt, evaluated, of_run, records);
  }
  return records;
}

Table RetrievalTable(const EvaluatedQueries& evaluated) {
  Table table;
  table.title = "CAD retrieval";
  table.name = "retrieval";
  table.columns = SummaryColumns();
  for (const RetrievalRecord& record : MakeRetrievalRecords(evaluated))
    table.rows.push_back(SummaryCells(record));
  AppendNotes({"queries: objects of the map; the true one is that of most of its observations, wherever it "
               "stands."},
              table);
  AppendNotes(RankNotes(), table);
  AppendNotes(DistanceNotes(), table);
  AppendNotes(
      {"random: expected Chamfer of a random pick. mean shape: of the model nearest to the category's mean.",
       "F-score: at 2 cm: the share of the retrieved surface's points within 2 cm of the true one and the "
       "share the other way, their harmonic mean."},
      table);
  return table;
}

Table EachQueryTable(const EvaluatedQueries& evaluated, const InstanceLibrary& library) {
  Table table;
  table.title = "CAD retrieval of each object";
  table.name = "each_query";
  table.columns = {"run",         "sequence",        "object",         "true model",
                   "rank k-NN",   "rank covariance", "rank re-ranked", "first other",
                   "Chamfer [cm]"};
  const auto& plain = evaluated.GetOutcomes(kPlainVariant);
  const auto& covariance = evaluated.GetOutcomes(kCovarianceVariant);
  const auto& reranked = evaluated.GetOutcomes(kDefaultVariant);
  for (size_t i = 0; i < evaluated.queries.size(); ++i) {
    const RetrievalQuery& query = evaluated.queries[i];
    const std::optional<SurfaceDistance>& distance = reranked[i].retrieved;
    table.rows.push_back({TextCell(query.run), TextCell(query.sequence), TextCell(query.object),
                          TextCell(query.true_model), RankCell(plain[i].rank), RankCell(covariance[i].rank),
                          RankCell(reranked[i].rank),
                          TextCell(FindId(library, query.category, reranked[i].first_other)),
                          distance ? Centimetres(distance->chamfer) : NoCell()});
  }
  AppendNotes(
      {"rank: of the true model among all of its category; -: it is not in the library. k-NN: whitened.",
       "first other: the first of the re-ranked that has a surface and is not the true model; Chamfer: of "
       "its surface from that of the true model."},
      table);
  return table;
}

}  // namespace armature
