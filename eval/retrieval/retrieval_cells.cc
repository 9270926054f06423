// SPDX-License-Identifier: BSD-3-Clause
#include "eval/retrieval/retrieval_cells.h"

#include <fmt/format.h>

namespace armature {

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
  row.push_back(CountCell(s.compared));
  row.push_back(Centimetres(s.chamfer));
  row.push_back(Centimetres(s.best_of_five));
  row.push_back(Centimetres(s.by_truth));
  row.push_back(NumberCell(s.ratio, 2));
}

std::vector<std::string> RankNotes() {
  return {
      "in library: queries whose true CAD model is in the library. Over these, by the rank of the true "
      "model among all instances of its category: top-1, top-5: share of ranks 1, of ranks up to 5; "
      "MRR: mean of 1 / rank."};
}

std::vector<std::string> DistanceNotes() {
  return {
      "compared: queries whose true surface is known. Over these, without the true model, as if the "
      "library did not have it, and without models that have no surface:",
      fmt::format(
          "Chamfer: mean distance of {} points of the retrieved surface from the true one, and the other "
          "way round, their mean; two such sets of one surface are 0.3 (laptop) to 0.9 cm (table) apart. "
          "Both are in the object frame: same axes, centred on the bounding box of their edges, the true "
          "model in the true object's size. Nothing else is aligned.",
          kSurfacePoints),
      "best of 5: the nearest surface of the first five. by true shape: what k-NN of the same space finds "
      "for the true object's coefficients, the best it could do. ratio: Chamfer / by true shape, of the "
      "means."};
}

void AppendNotes(const std::vector<std::string>& notes, Table& table) {
  table.notes.insert(table.notes.end(), notes.begin(), notes.end());
}

}  // namespace armature
