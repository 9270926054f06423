// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "eval/retrieval/retrieval_evaluation.h"
#include "eval/retrieval/retrieval_summary.h"
#include "support/expect_input_error.h"
#include "support/known_frames.h"
#include "support/map_world.h"

namespace armature {
namespace {

using testing::FrameLibrary;
using testing::MapWorld;

RetrievalOptions PlainRetrieval() {
  RetrievalOptions options;
  options.covariance = options.rerank = false;
  return options;
}

// 300 points are enough for small squares.
std::vector<RetrievalOutcome> Evaluated(const FrameLibrary& frames,
                                        const std::vector<RetrievalQuery>& queries) {
  RetrievalEvaluation evaluation(queries, frames.models, frames.library, frames.library, 300);
  return evaluation.Evaluate(PlainRetrieval());
}

TEST(EvalRetrieval, TruthAsEstimateIsPerfect) {
  const FrameLibrary frames(6);
  const std::vector<RetrievalQuery> queries = MakeLibraryQueries(frames.frames(), 1, 0, 1);
  ASSERT_EQ(queries.size(), 6u);
  const RetrievalSummary summary = Summarise(Evaluated(frames, queries));
  EXPECT_EQ(summary.in_library, 6);
  EXPECT_EQ(summary.top_1, 6);
  EXPECT_EQ(summary.mean_reciprocal_rank, 1);
  EXPECT_EQ(summary.ratio, 1);
  EXPECT_EQ(summary.chamfer, summary.by_truth);
  EXPECT_NEAR(*summary.chamfer, 0.1, 1e-3);  // the neighbour of each
}

TEST(EvalRetrieval, RanksAndDistancesOfAShiftedEstimate) {
  const FrameLibrary frames(6);
  const RetrievalOutcome outcome = Evaluated(frames, {frames.Query("cad:3", 0.8)}).front();
  // By distance: 1, 0, 2, 3.
  EXPECT_EQ(outcome.rank, 4);
  EXPECT_EQ(outcome.first_other, 1);
  EXPECT_NEAR(outcome.retrieved->chamfer, 0.2, 1e-3);
  EXPECT_NEAR(outcome.best_of_five->chamfer, 0.1, 1e-3);
  EXPECT_NEAR(outcome.by_truth->chamfer, 0.1, 1e-3);  // 2 and 4 are equally near: the first
  EXPECT_EQ(outcome.retrieved->f_score, 0);
}

TEST(EvalRetrieval, TheBestIsOfTheFirstFiveOnly) {
  const FrameLibrary frames(9);
  const RetrievalOutcome outcome = Evaluated(frames, {frames.Query("cad:8", 0)}).front();
  EXPECT_EQ(outcome.rank, 9);
  EXPECT_NEAR(outcome.best_of_five->chamfer, 0.4, 1e-3);
}

TEST(EvalRetrieval, AModelThatTheLibraryDoesNotHaveHasNoRankButASurface) {
  const FrameLibrary frames(6);
  const InstanceLibrary without{frames.library.root, {Without(frames.frames(), {3})}};
  const std::vector<RetrievalQuery> queries{frames.Query("cad:3", 0.8), frames.Query("cad:77", 0.8)};
  RetrievalEvaluation evaluation(queries, frames.models, without, frames.library, 300);
  const std::vector<RetrievalOutcome> outcomes = evaluation.Evaluate(PlainRetrieval());
  EXPECT_FALSE(outcomes[0].rank);
  EXPECT_NEAR(outcomes[0].retrieved->chamfer, 0.2, 1e-3);
  EXPECT_FALSE(outcomes[1].rank) << "known nowhere";
  EXPECT_EQ(outcomes[1].first_other, 1);
  EXPECT_FALSE(outcomes[1].retrieved || outcomes[1].by_truth);
}

TEST(EvalRetrieval, TheTrueSurfaceHasTheTrueSize) {
  const FrameLibrary frames(6);
  // Twice as high: the square of 2 is where that of 4 is.
  const RetrievalOutcome outcome = Evaluated(frames, {frames.Query("cad:2", 4, 0, {2, 4, 2})}).front();
  EXPECT_EQ(outcome.first_other, 4);
  EXPECT_NEAR(outcome.retrieved->chamfer, 0, 2e-3);
  EXPECT_EQ(outcome.retrieved->f_score, 1);
}

TEST(EvalRetrieval, TheTrueShapeHasTheTrueSize) {
  const FrameLibrary frames(6);
  // Posts 1 + 1 = 2 m long, twice as long 4 m: those of 3.
  const RetrievalOutcome outcome = Evaluated(frames, {frames.Query("cad:1", 0, 0, {2, 2, 4})}).front();
  EXPECT_NEAR(outcome.by_truth->chamfer, 0.2, 1e-3);
}

TEST(EvalRetrieval, ModelsWithoutSurfaceAreRankedAndNotCompared) {
  const FrameLibrary frames(6, {1, 4});
  const std::vector<RetrievalOutcome> outcomes =
      Evaluated(frames, {frames.Query("cad:3", 1), frames.Query("cad:4", 4)});
  EXPECT_EQ(outcomes[0].rank, 4);
  EXPECT_EQ(outcomes[0].first_other, 0);
  EXPECT_NEAR(outcomes[0].retrieved->chamfer, 0.3, 1e-3);
  EXPECT_EQ(outcomes[1].rank, 1);
  EXPECT_FALSE(outcomes[1].retrieved);
  const RetrievalSummary summary = Summarise(outcomes);
  EXPECT_EQ(summary.in_library, 2);
  EXPECT_EQ(summary.compared, 1);
  EXPECT_NEAR(*summary.chamfer, 0.3, 1e-3);
}

TEST(EvalRetrieval, AFileThatIsGoneIsNoSurfaceAndASpoiltOneIsAnError) {
  const FrameLibrary frames(3);
  std::filesystem::remove(frames.folder / "1.off");
  EXPECT_EQ(Evaluated(frames, {frames.Query("cad:0", 1)}).front().first_other, 2);
  frames.folder.Write("2.off", "OFF\n1 1\n");
  testing::ExpectInputError([&] { Evaluated(frames, {frames.Query("cad:0", 1)}); }, {"2.off"});
}

TEST(EvalRetrieval, BaselinesByHand) {
  const FrameLibrary frames(6);
  const std::vector<RetrievalQuery> queries{frames.Query("cad:3", 3), frames.Query("cad:0", 0)};
  RetrievalEvaluation evaluation(queries, frames.models, frames.library, frames.library, 300);
  const std::vector<RetrievalBaselines> baselines = evaluation.Baselines();
  EXPECT_NEAR(*baselines[0].random, (0.3 + 0.2 + 0.1 + 0.1 + 0.2) / 5, 1e-3);
  EXPECT_NEAR(*baselines[0].mean_shape, 0.3, 1e-3);
  EXPECT_NEAR(*baselines[1].mean_shape, 0.1, 1e-3) << "not the true model itself";
  EXPECT_NEAR(*Summarise(baselines).mean_shape, 0.2, 1e-3);
}

TEST(EvalRetrieval, ACategoryThatTheLibraryDoesNotHaveIsAskedInVain) {
  const FrameLibrary frames(3);
  const std::vector<RetrievalQuery> queries{frames.Query("cad:1", 1)};
  const InstanceLibrary nothing;
  RetrievalEvaluation evaluation(queries, frames.models, nothing, frames.library, 300);
  const RetrievalSummary summary = Summarise(evaluation.Evaluate(PlainRetrieval()));
  EXPECT_EQ(summary.queries, 1);
  EXPECT_EQ(summary.in_library + summary.compared, 0);
  EXPECT_FALSE(summary.mean_reciprocal_rank || summary.ratio);
  EXPECT_FALSE(evaluation.Baselines().front().random);
}

TEST(EvalRetrieval, SummaryByHand) {
  std::vector<RetrievalOutcome> outcomes(5);
  const std::vector<int> ranks{1, 2, 4, 10};
  for (size_t i = 0; i < ranks.size(); ++i) outcomes[i].rank = ranks[i];
  outcomes[0].retrieved = outcomes[0].best_of_five = SurfaceDistance{.chamfer = 0.03, .f_score = 0.5};
  outcomes[0].by_truth = SurfaceDistance{.chamfer = 0.02, .f_score = 0.75};
  outcomes[1].retrieved = SurfaceDistance{.chamfer = 9};  // nothing to compare it with
  const RetrievalSummary summary = Summarise(outcomes);
  EXPECT_EQ(summary.queries, 5);
  EXPECT_EQ(summary.in_library, 4);
  EXPECT_EQ(summary.top_1, 1);
  EXPECT_EQ(summary.top_5, 3);
  EXPECT_NEAR(*summary.mean_reciprocal_rank, (1 + 0.5 + 0.25 + 0.1) / 4, 1e-12);
  EXPECT_EQ(summary.median_rank, 3);
  EXPECT_EQ(summary.compared, 1);
  EXPECT_NEAR(*summary.ratio, 1.5, 1e-12);
  EXPECT_EQ(summary.f_score, 0.5);
  EXPECT_EQ(summary.f_score_by_truth, 0.75);
}

TEST(RetrievalRanking, ReRankedCandidatesComeFirstAndTheRestFollows) {
  MapWorld world;
  world.Put("chair", 0, 2.5, 30, 1);
  for (const double x : {-1.0, -0.3, 0.3, 1.0}) world.Look(x, 0, 0, 2.5);
  const ObjectSightings sightings{.frames = world.Frames({}),
                                  .T_world_camera = world.T_world_camera,
                                  .T_world_object = world.furniture[0].T_world_object};
  const CategoryModel& model = world.Model("chair");
  std::vector<CadModel> cad;
  for (const double shape : {-0.8, 0.0, 1.0, 2.0}) {  // the third is the true one
    Eigen::VectorXd coefficients = Eigen::VectorXd::Zero(model.modes());
    coefficients.head<2>() << shape, -0.5 * shape;
    cad.push_back({.instance = "cad",
                   .category = "chair",
                   .metric = true,
                   .wireframe = WireframeFromCoefficients(model, coefficients)});
  }
  const InstanceLibrary library = BuildLibrary({model}, cad, "");
  const ShapeQuery wrong{Eigen::VectorXd::Zero(model.modes()), {0.5, 0.9, 0.5}, std::nullopt};
  RetrievalOptions options = PlainRetrieval();
  options.rerank = true;
  options.k = 1;
  options.candidates = 3;
  const InstanceRanking ranking(model, library.categories.front(), options);
  EXPECT_EQ(ranking.Of(wrong, nullptr), (std::vector<int>{1, 0, 2, 3}));
  const std::vector<int> seen = ranking.Of(wrong, &sightings);
  EXPECT_EQ(seen.front(), 2);
  EXPECT_EQ(seen.back(), 3) << "the candidates do not reach it";
  EXPECT_EQ(seen.size(), 4u);
  EXPECT_EQ(FindRank(3, seen), 4);
  EXPECT_FALSE(FindRank(-1, seen));
}

}  // namespace
}  // namespace armature
