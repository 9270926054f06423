// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "retrieval/retrieve.h"
#include "support/frame_library.h"
#include "support/seen_chair.h"

namespace armature {
namespace {

using testing::FrameInstances;
using testing::FrameModel;
using testing::SeenChair;
using testing::SomeCoefficients;

// The plain form.
RetrievalOptions Plain() {
  RetrievalOptions options;
  options.covariance = options.rerank = false;
  return options;
}

std::vector<RetrievedInstance> Retrieved(const CategoryModel& model, const CategoryInstances& instances,
                                         const ShapeQuery& query, const RetrievalOptions& options,
                                         const ObjectSightings* sightings = nullptr) {
  return InstanceRetrieval(model, instances, options, BuildIndex(model, instances, options))
      .Retrieve(query, sightings);
}

std::vector<int> NumbersOf(const std::vector<RetrievedInstance>& retrieved) {
  std::vector<int> numbers(retrieved.size());
  for (size_t i = 0; i < numbers.size(); ++i) numbers[i] = retrieved[i].instance;
  return numbers;
}

// --- By shape alone

class FrameRetrieval : public ::testing::Test {
 protected:
  std::vector<RetrievedInstance> Retrieve(const RetrievalOptions& options) const {
    return Retrieved(model_, instances_, query_, options);
  }
  // All distances to the query, sorted.
  std::vector<double> Distances() const {
    const Eigen::RowVectorXd norms =
        (instances_.coefficients.cast<double>().colwise() - query_.coefficients).colwise().norm();
    std::vector<double> distances(norms.begin(), norms.end());
    std::sort(distances.begin(), distances.end());
    return distances;
  }

  CategoryModel model_ = FrameModel();
  CategoryInstances instances_ = FrameInstances(SomeCoefficients(40));
  ShapeQuery query_{Eigen::Vector3d(0.3, -0.5, 0.8), Eigen::Vector3d(1.3, 0.3, 1.2), {}};
};

TEST_F(FrameRetrieval, ListsTheKNearest) {
  for (const int k : {1, 5, 12}) {
    RetrievalOptions options = Plain();
    options.k = k;
    const std::vector<RetrievedInstance> retrieved = Retrieve(options);
    ASSERT_EQ(retrieved.size(), static_cast<size_t>(k));
    for (size_t i = 0; i < retrieved.size(); ++i) {
      EXPECT_NEAR(retrieved[i].distance, Distances()[i], 1e-5);
      EXPECT_FALSE(retrieved[i].fit);
    }
  }
}

TEST_F(FrameRetrieval, AllOfThemWhereKIsLarger) {
  RetrievalOptions options = Plain();
  options.k = 1000;
  const std::vector<int> numbers = NumbersOf(Retrieve(options));
  EXPECT_EQ(std::set<int>(numbers.begin(), numbers.end()).size(), 40);
  query_.evidence = ShapeEvidence{Eigen::Matrix3d::Identity(), query_.coefficients};
  options.covariance = true;
  EXPECT_EQ(Retrieve(options).size(), 40);
}

TEST_F(FrameRetrieval, NoneOfAnEmptyLibrary) {
  instances_ = FrameInstances(SomeCoefficients(1));
  instances_ = Without(instances_, {0});
  query_.evidence = ShapeEvidence{Eigen::Matrix3d::Identity(), query_.coefficients};
  EXPECT_TRUE(Retrieve(Plain()).empty());
  EXPECT_TRUE(Retrieve({}).empty());
}

TEST_F(FrameRetrieval, OnlyThoseWithinTheRadius) {
  RetrievalOptions options = Plain();
  options.k = 40;
  options.radius = (Distances()[6] + Distances()[7]) / 2;
  EXPECT_EQ(Retrieve(options).size(), 7);
  options.k = 3;
  EXPECT_EQ(Retrieve(options).size(), 3);
  options.radius = 1e-3;
  EXPECT_TRUE(Retrieve(options).empty());
}

TEST_F(FrameRetrieval, TheSpaceIsTheOneAskedFor) {
  RetrievalOptions raw = Plain();
  raw.features.space = FeatureSpace::kRaw;
  raw.features.modes = 2;
  const RetrievedInstance nearest = Retrieve(raw).front();
  const Eigen::Vector3d off =
      instances_.coefficients.col(nearest.instance).cast<double>() - query_.coefficients;
  EXPECT_NEAR(nearest.distance, off.cwiseProduct(model_.standard_deviations).head<2>().norm(), 1e-5);
}

// The estimate's first coefficient is the category's mean, because nothing was seen of it.
TEST_F(FrameRetrieval, WithCovarianceWhatWasNotSeenDoesNotCount) {
  Eigen::MatrixXd coefficients(3, 3);
  coefficients << 0, 1.5, 0, 0.6, 0, -0.7, 0, 0, 0;
  instances_ = FrameInstances(coefficients);
  query_.coefficients.setZero();
  query_.evidence = ShapeEvidence{Eigen::Vector3d(0, 50, 50).asDiagonal(), Eigen::Vector3d::Zero()};
  RetrievalOptions options = Plain();
  EXPECT_EQ(NumbersOf(Retrieve(options)), (std::vector<int>{0, 2, 1}));
  options.covariance = true;
  EXPECT_EQ(NumbersOf(Retrieve(options)), (std::vector<int>{1, 0, 2}));
  options.evidence_sigma = 0.5;
  EXPECT_NEAR(Retrieve(options)[1].distance, 0.6 / std::sqrt(1 / 50.0 + 0.25), 1e-5);
  query_.evidence.reset();
  EXPECT_EQ(NumbersOf(Retrieve(options)), (std::vector<int>{0, 2, 1})) << "without evidence the plain form";
}

TEST_F(FrameRetrieval, WithoutSightingsNothingIsReranked) {
  RetrievalOptions options = Plain();
  const std::vector<int> plain = NumbersOf(Retrieve(options));
  options.rerank = true;
  EXPECT_EQ(NumbersOf(Retrieve(options)), plain);
  const ObjectSightings none;
  EXPECT_EQ(NumbersOf(Retrieved(model_, instances_, query_, options, &none)), plain);
}

// --- By what the images show

// Chairs that differ from the one that is seen in one mode, and the true one, which is the farthest from the
// query.
class ChairRetrieval : public ::testing::Test {
 protected:
  ChairRetrieval() {
    query_.coefficients = chair_.truth().coefficients;
    query_.coefficients(1) += 1.5;
    std::vector<CadModel> cad;
    for (const double off : {1.5, 1.0, 0.6, 0.0}) {
      CadModel model;
      model.instance = "off by " + std::to_string(off);
      model.category = "chair";
      model.metric = true;
      Eigen::VectorXd coefficients = chair_.truth().coefficients;
      coefficients(1) += off;
      model.wireframe = WireframeFromCoefficients(chair_.model(), coefficients);
      cad.push_back(model);
    }
    instances_ = BuildLibrary({chair_.model()}, cad, "").categories.front();
  }
  std::vector<RetrievedInstance> Retrieve(const RetrievalOptions& options) const {
    return Retrieved(chair_.model(), instances_, query_, options, &sightings_);
  }

  SeenChair chair_;
  ObjectSightings sightings_ = chair_.Sightings(testing::FewCentimetres());
  CategoryInstances instances_;
  ShapeQuery query_;
};

TEST_F(ChairRetrieval, RerankingPutsTheTrueOneFirst) {
  EXPECT_EQ(NumbersOf(Retrieve(Plain())), (std::vector<int>{0, 1, 2, 3}));
  const std::vector<RetrievedInstance> retrieved = Retrieve({});
  EXPECT_EQ(NumbersOf(retrieved), (std::vector<int>{3, 2, 1, 0}));
  for (size_t i = 1; i < retrieved.size(); ++i) EXPECT_GE(retrieved[i].fit->cost, retrieved[i - 1].fit->cost);
  EXPECT_NEAR(retrieved.front().distance, 1.5, 0.1) << "of the shape, still";
}

TEST_F(ChairRetrieval, OnlyTheCandidatesAreReranked) {
  RetrievalOptions options;
  options.k = 1;
  options.candidates = 3;
  EXPECT_EQ(NumbersOf(Retrieve(options)), std::vector<int>{2});
  options.candidates = 4;
  EXPECT_EQ(NumbersOf(Retrieve(options)), std::vector<int>{3});
  options.k = 2;
  options.candidates = 1;
  EXPECT_EQ(NumbersOf(Retrieve(options)), (std::vector<int>{1, 0})) << "never fewer than are listed";
}

TEST_F(ChairRetrieval, TheRadiusIsThatOfTheShape) {
  RetrievalOptions options;
  options.radius = 0.7;
  EXPECT_EQ(NumbersOf(Retrieve(options)), (std::vector<int>{1, 0}));
}

}  // namespace
}  // namespace armature
