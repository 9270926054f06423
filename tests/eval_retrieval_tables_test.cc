// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "eval/retrieval/retrieval_tables.h"
#include "eval/retrieval/retrieval_variant_tables.h"
#include "support/known_frames.h"
#include "support/table_cells.h"

namespace armature {
namespace {

using testing::CellText;
using testing::FrameLibrary;
using testing::NotesText;

RetrievalOutcome OutcomeOfRank(int rank, double chamfer) {
  RetrievalOutcome outcome;
  outcome.rank = rank;
  outcome.first_other = 2;
  outcome.retrieved = outcome.best_of_five = SurfaceDistance{.chamfer = chamfer, .f_score = 0.25};
  outcome.by_truth = SurfaceDistance{.chamfer = 0.02, .f_score = 0.5};
  return outcome;
}

// One object in sequence a, two in b; the default variant has ranks 1, 2 and 6, the others have rank 3.
EvaluatedQueries ThreeQueries(const FrameLibrary& frames) {
  EvaluatedQueries evaluated;
  for (const char* sequence : {"a", "b", "b"}) {
    evaluated.queries.push_back(frames.Query("cad:1", 1));
    evaluated.queries.back().run = "mine";
    evaluated.queries.back().sequence = sequence;
    evaluated.queries.back().object = "frame0";
    evaluated.baselines.push_back({.random = 0.1, .mean_shape = std::nullopt});
  }
  for (const RetrievalVariant& variant : VariantsForSeen()) {
    const bool is_default = variant.name == kDefaultVariant;
    evaluated.variants.push_back({variant, std::vector<RetrievalOutcome>(3, OutcomeOfRank(3, 0.05))});
    if (is_default)
      evaluated.variants.back().outcomes = {OutcomeOfRank(1, 0.03), OutcomeOfRank(2, 0.03),
                                            OutcomeOfRank(6, 0.06)};
  }
  return evaluated;
}

TEST(RetrievalTables, HaveARowASequenceAndOneOfAll) {
  const FrameLibrary frames(3);
  const Table table = RetrievalTable(ThreeQueries(frames));
  ASSERT_EQ(table.rows.size(), 3u);
  EXPECT_EQ(CellText(table, 0, "sequence"), "a");
  EXPECT_EQ(CellText(table, 0, "top-1 [%]"), "100.0");
  EXPECT_EQ(CellText(table, 2, "run"), "mine");
  EXPECT_EQ(CellText(table, 2, "sequence"), "all");
  EXPECT_EQ(CellText(table, 2, "queries"), "3");
  EXPECT_EQ(CellText(table, 2, "top-1 [%]"), "33.3");
  EXPECT_EQ(CellText(table, 2, "top-5 [%]"), "66.7");
  EXPECT_EQ(CellText(table, 2, "MRR"), "0.556");
  EXPECT_EQ(CellText(table, 2, "compared"), "3");
  EXPECT_EQ(CellText(table, 2, "Chamfer [cm]"), "4.00");
  EXPECT_EQ(CellText(table, 2, "by true shape"), "2.00");
  EXPECT_EQ(CellText(table, 2, "ratio"), "2.00");
  EXPECT_EQ(CellText(table, 2, "random"), "10.00");
  EXPECT_EQ(CellText(table, 2, "mean shape"), "");
  EXPECT_EQ(CellText(table, 2, "F-score"), "0.250");
  EXPECT_EQ(CellText(table, 2, "F-score by true shape"), "0.500");
  EXPECT_NE(NotesText(table).find("centred on the bounding box of their edges"), std::string::npos);
}

TEST(RetrievalTables, HaveARowAVariantThatDiffers) {
  const FrameLibrary frames(3);
  const Table table = RetrievalVariantTable(ThreeQueries(frames), frames.models);
  std::vector<std::string> names;
  for (size_t row = 0; row < table.rows.size(); ++row) names.push_back(CellText(table, row, "variant"));
  // The frame has two modes.
  EXPECT_EQ(names,
            (std::vector<std::string>{"k-NN, raw", "k-NN, whitened", "k-NN, whitened, with size",
                                      "k-NN, whitened, first mode", "covariance", "k-NN, whitened, re-ranked",
                                      "covariance, re-ranked (default)"}));
  EXPECT_EQ(CellText(table, 0, "median rank"), "3.0");
  EXPECT_EQ(CellText(table, 6, "median rank"), "2.0");
  EXPECT_EQ(CellText(table, 6, "ratio"), "2.00");
}

TEST(RetrievalTables, HaveARowAQuery) {
  const FrameLibrary frames(3);
  const Table table = EachQueryTable(ThreeQueries(frames), frames.library);
  ASSERT_EQ(table.rows.size(), 3u);
  EXPECT_EQ(CellText(table, 2, "object"), "frame0");
  EXPECT_EQ(CellText(table, 2, "true model"), "cad:1");
  EXPECT_EQ(CellText(table, 2, "rank k-NN"), "3");
  EXPECT_EQ(CellText(table, 2, "rank re-ranked"), "6");
  EXPECT_EQ(CellText(table, 2, "first other"), "cad:2");
  EXPECT_EQ(CellText(table, 2, "Chamfer [cm]"), "6.00");
}

TEST(RetrievalTables, OfNothingAreDashes) {
  const FrameLibrary frames(3);
  EvaluatedQueries evaluated = ThreeQueries(frames);
  for (EvaluatedVariant& variant : evaluated.variants) variant.outcomes.assign(3, {});
  const Table table = RetrievalTable(evaluated), each = EachQueryTable(evaluated, frames.library);
  for (const char* column : {"top-1 [%]", "MRR", "Chamfer [cm]", "ratio", "F-score"})
    EXPECT_EQ(CellText(table, 2, column), "") << column;
  for (const char* column : {"rank covariance", "first other", "Chamfer [cm]"})
    EXPECT_EQ(CellText(each, 0, column), "") << column;
}

TEST(RetrievalVariants, TheDefaultIsOneOfThem) {
  const RetrievalOptions defaults = VariantsForSeen().back().options;
  EXPECT_TRUE(defaults.covariance && defaults.rerank);
  EXPECT_EQ(defaults.features.space, FeatureSpace::kWhitened);
  EXPECT_THROW(EvaluatedQueries().GetOutcomes("k-NN"), std::logic_error);
}

TEST(RetrievalTables, OfALibrarySayWhatWasAsked) {
  const FrameLibrary frames(3);
  EvaluatedQueries evaluated = ThreeQueries(frames);
  const Table table = LibraryTable(evaluated, frames.models, frames.library, "all of them");
  EXPECT_NE(NotesText(table).find("all of them. instances: 3 frame"), std::string::npos) << NotesText(table);
}

}  // namespace
}  // namespace armature
