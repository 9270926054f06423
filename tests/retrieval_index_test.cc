// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <tuple>

#include "geometry/random.h"
#include "retrieval/instance_index.h"

namespace armature {
namespace {

IndexMethod MethodNamed(const std::string& name) {
  IndexMethod method;
  method.kind = *FromName<IndexKind>(name);
  return method;
}

Eigen::MatrixXf NormalFeatures(Eigen::Index dimensions, Eigen::Index count, std::uint64_t seed) {
  Random random(seed);
  return Eigen::MatrixXf::NullaryExpr(dimensions, count,
                                      [&] { return static_cast<float>(random.Normal(0, 1)); });
}

// Whole numbers from 0 to 3: most distances are of many instances.
Eigen::MatrixXf GridFeatures(Eigen::Index dimensions, Eigen::Index count, std::uint64_t seed) {
  Random random(seed);
  return Eigen::MatrixXf::NullaryExpr(dimensions, count,
                                      [&] { return static_cast<float>(std::floor(random.Uniform(0, 4))); });
}

std::vector<Neighbour> AllByDistance(const Eigen::MatrixXf& features, const Eigen::VectorXf& query) {
  std::vector<Neighbour> all;
  all.reserve(static_cast<size_t>(features.cols()));
  for (int i = 0; i < features.cols(); ++i)
    all.push_back({i, (features.col(i).cast<double>() - query.cast<double>()).norm()});
  std::stable_sort(all.begin(), all.end(), [](auto& a, auto& b) { return a.distance < b.distance; });
  return all;
}

std::vector<Neighbour> First(std::vector<Neighbour> all, size_t k) {
  all.resize(std::min(k, all.size()));
  return all;
}

// Of how many of the five nearest are among the five found.
double RecallAtFive(const InstanceIndex& index, const Eigen::MatrixXf& features,
                    const Eigen::MatrixXf& queries) {
  int found = 0;
  for (const auto& query : queries.colwise()) {
    std::set<int> nearest;
    for (const Neighbour& n : First(AllByDistance(features, query), 5)) nearest.insert(n.instance);
    for (const Neighbour& n : index.Nearest(query, 5)) found += static_cast<int>(nearest.count(n.instance));
  }
  return found / (5.0 * static_cast<double>(queries.cols()));
}

const Eigen::MatrixXf kCorners{{0, 3, 0, 6, 0}, {0, 4, 1, 8, 1}};  // columns: instances in a plane

class EveryMethod : public ::testing::TestWithParam<std::string> {};
class ExactMethod : public ::testing::TestWithParam<std::string> {};
class SeededMethod : public ::testing::TestWithParam<std::string> {};

std::string TheName(const ::testing::TestParamInfo<std::string>& info) { return info.param; }

INSTANTIATE_TEST_SUITE_P(InstanceIndex, EveryMethod, ::testing::ValuesIn(ListNames<IndexKind>()), TheName);
INSTANTIATE_TEST_SUITE_P(InstanceIndex, ExactMethod, ::testing::Values("linear", "kdtree_single"), TheName);
INSTANTIATE_TEST_SUITE_P(InstanceIndex, SeededMethod, ::testing::Values("kdtree", "kmeans"), TheName);

TEST_P(EveryMethod, FindsTheNearestInThePlane) {
  const InstanceIndex index(kCorners, MethodNamed(GetParam()));
  EXPECT_EQ(index.instances(), 5);
  EXPECT_EQ(index.dimensions(), 2);
  EXPECT_EQ(index.Nearest(Eigen::Vector2f(0, 0), 4),
            (std::vector<Neighbour>{{0, 0.0}, {2, 1.0}, {4, 1.0}, {1, 5.0}}));
}

TEST_P(EveryMethod, ReturnsAllWhereThereAreFewer) {
  const InstanceIndex index(kCorners, MethodNamed(GetParam()));
  EXPECT_EQ(index.Nearest(Eigen::Vector2f(6, 8), 100),
            First(AllByDistance(kCorners, Eigen::Vector2f(6, 8)), 5));
}

TEST_P(EveryMethod, FindsNothingAmongNothing) {
  const InstanceIndex index(Eigen::MatrixXf(3, 0), MethodNamed(GetParam()));
  EXPECT_EQ(index.instances(), 0);
  EXPECT_EQ(index.dimensions(), 3);
  EXPECT_TRUE(index.Nearest(Eigen::Vector3f::Zero(), 5).empty());
  EXPECT_TRUE(index.Within(Eigen::Vector3f::Zero(), 5).empty());
}

TEST_P(EveryMethod, FindsAllWithinARadiusAndOnIt) {
  const InstanceIndex index(kCorners, MethodNamed(GetParam()));
  EXPECT_EQ(index.Within(Eigen::Vector2f(0, 0), 5),
            (std::vector<Neighbour>{{0, 0.0}, {2, 1.0}, {4, 1.0}, {1, 5.0}}));
  EXPECT_EQ(index.Within(Eigen::Vector2f(3, 4), 0), (std::vector<Neighbour>{{1, 0.0}}));
  EXPECT_TRUE(index.Within(Eigen::Vector2f(50, 50), 1).empty());
}

TEST_P(EveryMethod, TakesManyInstancesAtOnePoint) {
  const InstanceIndex index(Eigen::MatrixXf::Ones(4, 500), MethodNamed(GetParam()));
  EXPECT_EQ(index.Nearest(Eigen::Vector4f::Zero(), 1).at(0).distance, 2.0);
  EXPECT_EQ(index.Nearest(Eigen::Vector4f::Zero(), 500).size(), 500u);
}

TEST_P(EveryMethod, CanBeMoved) {
  InstanceIndex first(kCorners, MethodNamed(GetParam()));
  InstanceIndex second = std::move(first);
  first = InstanceIndex(kCorners.leftCols(1), MethodNamed(GetParam()));
  EXPECT_EQ(second.Nearest(Eigen::Vector2f(3, 4), 1).at(0).instance, 1);
  EXPECT_EQ(first.Nearest(Eigen::Vector2f(3, 4), 1).at(0).instance, 0);
}

TEST_P(EveryMethod, CountsItsMemory) {
  const size_t features = sizeof(float) * 7 * 1000;
  const InstanceIndex index(NormalFeatures(7, 1000, 1), MethodNamed(GetParam()));
  EXPECT_GE(index.memory_bytes(), features);
  EXPECT_LT(index.memory_bytes(), 40 * features);
}

TEST_P(ExactMethod, EqualsBruteForce) {
  for (const Eigen::Index dimensions : {1, 3, 7, 12}) {
    const Eigen::MatrixXf features = NormalFeatures(dimensions, 700, 1);
    const InstanceIndex index(features, MethodNamed(GetParam()));
    const Eigen::MatrixXf queries = NormalFeatures(dimensions, 40, 2);
    for (const auto& query : queries.colwise())
      ASSERT_EQ(index.Nearest(query, 9), First(AllByDistance(features, query), 9)) << dimensions;
  }
}

TEST_P(ExactMethod, BreaksTiesByInstanceAlsoAtTheEndOfTheList) {
  const Eigen::MatrixXf features = GridFeatures(3, 600, 3);
  const InstanceIndex index(features, MethodNamed(GetParam()));
  const Eigen::MatrixXf queries = GridFeatures(3, 30, 4);
  for (const auto& query : queries.colwise()) {
    const std::vector<Neighbour> all = AllByDistance(features, query);
    for (const int k : {1, 5, 60}) ASSERT_EQ(index.Nearest(query, k), First(all, static_cast<size_t>(k)));
    const auto beyond = std::find_if(all.begin(), all.end(), [](auto& n) { return n.distance > 2; });
    ASSERT_EQ(index.Within(query, 2), std::vector<Neighbour>(all.begin(), beyond));
  }
}

// In single precision the distances of these are the same, or in the wrong order.
TEST_P(ExactMethod, OrdersWhatOnlyDoublePrecisionTellsApart) {
  Random random(5);
  const Eigen::MatrixXf features = Eigen::MatrixXf::NullaryExpr(
      5, 400, [&] { return static_cast<float>(1000 + 1e-3 * std::floor(random.Uniform(0, 3))); });
  const InstanceIndex index(features, MethodNamed(GetParam()));
  const Eigen::VectorXf query = Eigen::VectorXf::Constant(5, 17.3F);
  EXPECT_EQ(index.Nearest(query, 20), First(AllByDistance(features, query), 20));
}

TEST_P(SeededMethod, TheSameSeedGivesTheSameAnswers) {
  const Eigen::MatrixXf features = NormalFeatures(7, 3000, 1), queries = NormalFeatures(7, 50, 2);
  IndexMethod method = MethodNamed(GetParam());
  method.checks = 20;
  const auto answers = [&](std::uint64_t seed) {
    method.seed = seed;
    const InstanceIndex index(features, method);
    std::vector<std::vector<Neighbour>> all;
    for (const auto& query : queries.colwise()) all.push_back(index.Nearest(query, 5));
    return all;
  };
  const auto once = answers(1);
  EXPECT_EQ(answers(1), once);
  EXPECT_NE(answers(2), once);
}

TEST_P(SeededMethod, MoreChecksFindMore) {
  const Eigen::MatrixXf features = NormalFeatures(7, 3000, 1), queries = NormalFeatures(7, 30, 2);
  const auto recall = [&](int checks) {
    IndexMethod method = MethodNamed(GetParam());
    method.checks = checks;
    return RecallAtFive(InstanceIndex(features, method), features, queries);
  };
  const double few = recall(8), some = recall(128), all = recall(100'000);
  EXPECT_LT(few, 0.8);
  EXPECT_GT(some, few + 0.1);
  EXPECT_EQ(all, 1);
}

}  // namespace
}  // namespace armature
