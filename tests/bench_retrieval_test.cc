// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <set>

#include "bench/retrieval/index_race.h"
#include "bench/retrieval/library_costs.h"
#include "bench/sections/retrieval_section.h"
#include "support/expect_input_error.h"
#include "support/table_cells.h"

namespace armature {
namespace {

using testing::CellText;

const std::set<std::string> kContenders{"linear",     "kdtree_single", "kdtree:32",  "kdtree:128",
                                        "kdtree:512", "kmeans:32",     "kmeans:128", "kmeans:512"};

TEST(RetrievalSection, HasARowASizeAndMethod) {
  const BenchSection section = RetrievalSection({.sizes = {50, 900}, .queries = 60});
  const Table& table = section.tables.at(0);
  ASSERT_EQ(table.rows.size(), 2 * kContenders.size());
  std::set<std::string> contenders;
  for (size_t row = 0; row < table.rows.size(); ++row) {
    EXPECT_EQ(CellText(table, row, "instances"), row < kContenders.size() ? "50" : "900");
    EXPECT_EQ(CellText(table, row, "n"), "40");
    EXPECT_GT(std::stod(CellText(table, row, "recall@5")), 0.4);
    EXPECT_GT(std::stod(CellText(table, row, "median [us]")), 0);
    contenders.insert(CellText(table, row, "index"));
  }
  EXPECT_EQ(contenders, kContenders);
  EXPECT_EQ(section.rows.size(), table.rows.size() * 40);
  EXPECT_FALSE(section.calibration_ms.empty());
}

TEST(RetrievalSection, ExactMethodsFindAllOfThem) {
  const BenchSection section = RetrievalSection({.sizes = {3, 2000}, .queries = 40});
  const Table& table = section.tables.at(0);
  for (size_t row = 0; row < table.rows.size(); ++row) {
    const std::string index = CellText(table, row, "index"), recall = CellText(table, row, "recall@5");
    const bool exact = index == "linear" || index == "kdtree_single";
    const bool has_all = exact || CellText(table, row, "instances") == "3";
    EXPECT_TRUE(!has_all || recall == "1.0000") << index << " " << recall;
    EXPECT_TRUE(has_all || index != "kdtree:32" || recall != "1.0000") << recall;
  }
}

TEST(RetrievalSection, HasASpanARowAndACurveAMethod) {
  const BenchSection section = RetrievalSection({.sizes = {10, 20}, .queries = 30});
  ASSERT_EQ(section.spans.size(), 2 * kContenders.size());
  EXPECT_EQ(section.spans[0].Key(), "retrieval//linear of 10/query");
  EXPECT_EQ(section.spans.back().Key(), "retrieval//kmeans:512 of 20/query");
  EXPECT_EQ(section.spans[0].milliseconds.n, 10u);
  ASSERT_EQ(section.series.size(), kContenders.size());
  for (const BenchSeries& series : section.series) {
    ASSERT_EQ(series.points.size(), 2u) << series.contender;
    EXPECT_EQ(series.points[1].x, 20);
    EXPECT_EQ(series.remark, " (1.000)");
  }
}

TEST(RetrievalSection, MeasuresWholeLibraries) {
  const BenchSection section = RetrievalSection({.sizes = {10, 20}, .queries = 30});
  const Table& table = section.tables.at(1);
  ASSERT_EQ(table.rows.size(), 2u);
  EXPECT_EQ(CellText(table, 1, "instances"), "20");
  for (const size_t row : {0u, 1u}) {
    for (const char* column : {"read [ms]", "write [ms]", "by covariance [ms]"})
      EXPECT_GE(std::stod(CellText(table, row, column)), 0) << column;
  }
  // 7 coefficients, 3 sizes, 66 numbers of edges, 12 of a transform, 1 deviation: 356 bytes and two names.
  const LibraryCosts costs = MeasureLibrary(MakeSyntheticLibrary(1000, 5));
  EXPECT_GT(costs.file_mb * (1 << 20), 1000 * (356 + 40));
  EXPECT_LT(costs.file_mb * (1 << 20), 1000 * (356 + 80));
}

TEST(Recall, CountsTrueNeighboursAmongThoseFound) {
  const Answers truth{{{1, 0.1}, {2, 0.2}}, {{3, 0.1}, {4, 0.2}}, {{5, 0.1}, {6, 0.2}}};
  EXPECT_EQ(Recall(truth, truth), 1);
  EXPECT_EQ(Recall({{{1, 0.1}, {7, 0.3}}, {{4, 0.2}, {3, 0.1}}}, truth), 0.75);  // of two queries
  EXPECT_EQ(Recall({{}}, truth), 0);
}

TEST(SyntheticLibrary, HasUnitDeviationAndQueriesNearInstances) {
  const SyntheticLibrary library = MakeSyntheticLibrary(5000, 200);
  EXPECT_EQ(library.features.rows(), 7);
  EXPECT_EQ(library.features.cols(), 5000);
  const Eigen::VectorXf mean = library.features.rowwise().mean();
  const float variance = (library.features.colwise() - mean).squaredNorm() / (7 * 5000);
  EXPECT_NEAR(variance, 1, 0.15);
  for (const auto& query : library.queries.colwise())
    EXPECT_LT((library.features.colwise() - query).colwise().norm().minCoeff(), 0.3 * 5);
  EXPECT_EQ(MakeSyntheticLibrary(5000, 200).queries, library.queries);
}

TEST(RetrievalSizes, AreSortedEachOnce) {
  EXPECT_EQ(RetrievalSizes({"1e3", "10", "1000"}), (std::vector<size_t>{10, 1000}));
}

TEST(RetrievalSizes, RefuseWhatIsNoNumberOfInstances) {
  const auto expect_refused = [](const std::string& text) {
    testing::ExpectInputError([&] { RetrievalSizes({"10", text}); }, {"--retrieval-sizes", text});
  };
  for (const char* text : {"0", "-3", "many", "5000001", "1.5"}) expect_refused(text);
}

}  // namespace
}  // namespace armature
