// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "association/box_constraints.h"
#include "association/hypotheses.h"
#include "association/hypothesis_cost.h"
#include "association/line_seeds.h"
#include "association/matching.h"
#include "association/printed_cost.h"
#include "geometry/rotation.h"
#include "support/synthetic_view.h"

namespace armature {
namespace {

using testing::SyntheticView;

ProjectedEdge HorizontalEdge(double y, double from, double to) {
  ProjectedEdge edge;
  edge.line = {{from, y}, {to, y}};
  edge.length = to - from;
  edge.visible_share = 1;
  return edge;
}

// The quick way past most pairs must leave the same as looking at every pair.
TEST(Matching, IsAsIfEveryPairWereCompared) {
  const SyntheticView synthetic("chair", 0.4, {0.1, 0.3, 2.5}, Eigen::Vector2d(0.5, -0.5));
  const ProjectedWireframe projected = synthetic.Project(synthetic.truth);
  std::vector<Segment> segments;
  for (int i = 0; i < 60; ++i) {  // in every direction, all over the chair
    const double angle = 2.4 * i, length = 12 + i;
    const Eigen::Vector2d middle(330 + 3.7 * i, 90 + (53 * i) % 360);
    const Eigen::Vector2d half = 0.5 * length * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    segments.push_back({middle - half, middle + half});
  }
  segments.insert(segments.end(), synthetic.view.segments.begin(), synthetic.view.segments.end());
  const MatchGate gate{15, 0.3};
  double covered = 0;
  std::vector<int> best_edge(segments.size(), -1);
  std::vector<double> best(segments.size(), 0);
  for (size_t e = 0; e < projected.edges.size(); ++e) {
    if (projected.edges[e].length <= 1 || projected.edges[e].visible_share < 0.2) continue;
    double sum = 0;
    for (size_t i = 0; i < segments.size(); ++i) {
      const PairScore pair = ComparePair(projected.edges[e], segments[i], gate);
      const double explained = pair.overlap * pair.quality;
      sum += explained;
      if (explained <= best[i]) continue;
      best[i] = explained;
      best_edge[i] = static_cast<int>(e);
    }
    covered += std::min(sum, projected.edges[e].length * projected.edges[e].visible_share);
  }
  EXPECT_NEAR(CoveredLength(projected, segments, gate), covered, 1e-9);
  const Matching matching = MatchSegments(projected, segments, gate);
  ASSERT_GT(matching.matches.size(), 12u);
  size_t next = 0;
  for (size_t i = 0; i < segments.size(); ++i) {
    if (best_edge[i] < 0) continue;
    ASSERT_LT(next, matching.matches.size());
    EXPECT_EQ(matching.matches[next].edge, best_edge[i]);
    EXPECT_EQ(matching.matches[next].segment.p1, segments[i].p1);
    ++next;
  }
  EXPECT_EQ(next, matching.matches.size());
}

TEST(Projection, EdgesBehindAFaceAreHidden) {
  // Seen from the front above, the rear legs' tops of a chair are hidden by its seat, the front legs are not.
  const SyntheticView synthetic("chair", 0.0, {0, 0.4, 2.0}, Eigen::Vector2d::Zero(), 0.7);
  const ProjectedWireframe projected = synthetic.Project(synthetic.truth);
  const auto& names = synthetic.model.spec.edge_names;
  const auto share = [&](const std::string& name) {
    return projected.edges[static_cast<size_t>(std::find(names.begin(), names.end(), name) - names.begin())]
        .visible_share;
  };
  EXPECT_EQ(share("leg_front_left"), 1.0);
  EXPECT_LT(share("leg_rear_left"), 0.8);
}

TEST(Projection, AnotherObjectsFaceHidesWhatIsBehindIt) {
  const SyntheticView synthetic("chair", 0.3, {0, 0.2, 3}, Eigen::Vector2d::Zero());
  Eigen::Matrix3Xd wall(3, 4);
  wall << -1, 1, 1, -1, -1, -1, 1, 1, 1, 1, 1, 1;
  ProjectedWireframe projected;
  const auto visible_length = [&](double z) {
    Eigen::Matrix3Xd placed = wall * z;
    ProjectWireframe(synthetic.camera, synthetic.model.spec,
                     WireframeFromCoefficients(synthetic.model, synthetic.truth.coefficients),
                     synthetic.truth.T_camera_object, {0, 0, 855, 479},
                     {ProjectFace(synthetic.camera, placed)}, projected);
    return projected.VisibleLength();
  };
  EXPECT_EQ(visible_length(1.0), 0);
  EXPECT_GT(visible_length(6.0), 100);
}

TEST(Projection, AnEdgeThroughTheCameraIsCutAtTheNearPlane) {
  Eigen::Matrix3Xd corners(3, 4);
  corners << -1, 1, 1, -1, 1, 1, 1, 1, -1, -1, 3, 3;  // a floor that goes on behind the camera
  const Camera camera{640, 480, 500, 500, 320, 240, {}};
  const ImageFace face = ProjectFace(camera, corners);
  EXPECT_EQ(face.corners.size(), 4u);
  EXPECT_TRUE(face.Hides({320, 470}, 1 / 20.0));   // behind the floor
  EXPECT_FALSE(face.Hides({320, 470}, 1 / 1.0));   // in front of it
  EXPECT_FALSE(face.Hides({320, 100}, 1 / 20.0));  // above the horizon
}

TEST(Matching, PairsAreGatedByDistanceAndAngle) {
  const ProjectedEdge edge = HorizontalEdge(100, 0, 100);
  const MatchGate gate{4, 0.1};
  const PairScore on = ComparePair(edge, {{20, 100}, {60, 100}}, gate);
  EXPECT_DOUBLE_EQ(on.overlap, 40);
  EXPECT_DOUBLE_EQ(on.quality, 1);
  EXPECT_EQ(ComparePair(edge, {{20, 105}, {60, 105}}, gate).overlap, 0);
  EXPECT_EQ(ComparePair(edge, {{20, 96}, {60, 104}}, gate).overlap, 0);
  EXPECT_EQ(ComparePair(edge, {{120, 100}, {160, 100}}, gate).overlap, 0);
  EXPECT_NEAR(ComparePair(edge, {{20, 102}, {60, 102}}, gate).rms, 2, 1e-12);
}

TEST(Matching, ASegmentServesOneEdgeAndAnEdgeTakesFragments) {
  ProjectedWireframe projected;
  projected.edges = {HorizontalEdge(100, 0, 100), HorizontalEdge(103, 0, 100)};
  const std::vector<Segment> segments = {{{5, 100.5}, {40, 100.5}}, {{50, 100.2}, {95, 100.2}}};
  const Matching matching = MatchSegments(projected, segments, {4, 0.1});
  ASSERT_EQ(matching.matches.size(), 2u);
  EXPECT_EQ(matching.matches[0].edge, 0);
  EXPECT_EQ(matching.matches[1].edge, 0);
}

TEST(Matching, HiddenEdgesTakeNoSegment) {
  ProjectedWireframe projected;
  projected.edges = {HorizontalEdge(100, 0, 100)};
  projected.edges[0].visible_share = 0;
  EXPECT_TRUE(MatchSegments(projected, {{{5, 100}, {40, 100}}}, {4, 0.1}).matches.empty());
}

TEST(Matching, ThePerfectViewIsCovered) {
  const SyntheticView synthetic("table", 0.5, {0, 0.2, 3}, Eigen::Vector2d::Zero());
  const ProjectedWireframe projected = synthetic.Project(synthetic.truth);
  EXPECT_GT(CoveredLength(projected, synthetic.view.segments, {4, 0.1}), 0.9 * projected.VisibleLength());
}

TEST(PrintedCost, FollowsTheEquations) {
  const Segment edge{{0, 0}, {100, 0}};
  // p1 = 2, p2 = 6, middles (50, 0) and (30, 4)
  const Segment segment{{10, 2}, {50, 6}};
  const double expected = 4 + 0.5 * 4 + 0.25 * std::hypot(20, 4);
  EXPECT_NEAR(PrintedPairCost(edge, segment, {0.5, 0.25}, OffsetSign::kPrinted), expected, 1e-12);
  EXPECT_NEAR(PrintedPairCost(edge, segment, {0.5, 0.25}, OffsetSign::kNone), expected, 1e-12);
}

TEST(PrintedCost, SignedOffsetRewardsTheWrongSide) {
  // As printed, a segment on the negative side costs less than one on the edge: the reason for the default
  // cost.
  const Segment edge{{0, 0}, {100, 0}};
  EXPECT_LT(PrintedPairCost(edge, {{0, -30}, {100, -30}}, {1, 0}, OffsetSign::kPrinted),
            PrintedPairCost(edge, {{0, 0}, {100, 0}}, {1, 0}, OffsetSign::kPrinted));
}

TEST(PrintedCost, MeantOffsetsCostAlikeOnBothSides) {
  const Segment edge{{0, 0}, {100, 0}}, below{{0, 30}, {100, 30}}, above{{0, -30}, {100, -30}};
  EXPECT_DOUBLE_EQ(PrintedPairCost(edge, below, {1, 0}, OffsetSign::kNone), 30);
  EXPECT_DOUBLE_EQ(PrintedPairCost(edge, above, {1, 0}, OffsetSign::kNone), 30);
}

TEST(PrintedCost, ACrossingSegmentThatCostsNothingAsPrintedCostsAsMeant) {
  // p1 = -2, p2 = -6: as printed C1 = 4 and C2 = -4 cancel, however far the segment runs across.
  const Segment edge{{0, 0}, {100, 0}}, segment{{40, -2}, {60, -6}};
  EXPECT_DOUBLE_EQ(PrintedPairCost(edge, segment, {1, 0}, OffsetSign::kPrinted), 0);
  EXPECT_DOUBLE_EQ(PrintedPairCost(edge, segment, {1, 0}, OffsetSign::kNone), 8);
}

TEST(PrintedCost, AsMeantTheEdgeTakesTheSegmentOnIt) {
  ProjectedWireframe projected;
  projected.edges = {HorizontalEdge(100, 0, 100)};
  const Segment on_it{{10, 101}, {90, 101}}, far{{10, 60}, {90, 60}};
  const auto taken = [&](OffsetSign sign) {
    return AssociateAsPrinted(projected, {far, on_it}, {1, 0.1}, sign).matches.at(0).segment.p1.y();
  };
  EXPECT_EQ(taken(OffsetSign::kPrinted), 60) << "40 px off, on the side that is paid for";
  EXPECT_EQ(taken(OffsetSign::kNone), 101);
}

TEST(BoxConstraints, SidesAtTheBorderAreOpen) {
  const Camera camera{640, 480, 500, 500, 320, 240, {}};
  const BoxSides sides = SidesAtImageBorder({5, 100, 300, 376}, camera);
  EXPECT_EQ(sides[0], BoxSide::kOpen);
  EXPECT_EQ(sides[1], BoxSide::kSeen);
  EXPECT_EQ(sides[2], BoxSide::kSeen);
  EXPECT_EQ(sides[3], BoxSide::kOpen);
}

TEST(BoxConstraints, PaddingIsTurnedWithTheObject) {
  const Eigen::Matrix3d oblique = ExpSO3({0.4, -1.1, 0.7}), quarter_turn = ExpSO3({0, 90 * kDegree, 0});
  CategorySpec spec;
  spec.padding = Eigen::Vector3d::Constant(0.02);
  EXPECT_TRUE(ImagePadding(spec, oblique).isApprox(Eigen::Vector2d(0.02, 0.02)));
  spec.padding = Eigen::Vector3d(0.03, 0.02, 0.01);
  EXPECT_TRUE(ImagePadding(spec, Eigen::Matrix3d::Identity()).isApprox(Eigen::Vector2d(0.03, 0.02)));
  EXPECT_TRUE(ImagePadding(spec, quarter_turn).isApprox(Eigen::Vector2d(0.01, 0.02)));
  // Half way the image's x is along (x + z) / sqrt(2).
  EXPECT_NEAR(ImagePadding(spec, ExpSO3({0, 45 * kDegree, 0})).x(), std::sqrt((0.0009 + 0.0001) / 2), 1e-12);
}

TEST(BoxConstraints, TheTranslationIsRecoveredFromAWholeBox) {
  for (const char* category : {"chair", "table", "laptop"}) {
    const SyntheticView synthetic(category, 0.7, {0.3, 0.2, 2.5}, Eigen::Vector2d::Zero());
    const Eigen::Vector3d T =
        TranslationFromBox(synthetic.view, synthetic.view.sides,
                           WireframeFromCoefficients(synthetic.model, synthetic.truth.coefficients),
                           synthetic.truth.T_camera_object.linear());
    EXPECT_LT((T - synthetic.truth.T_camera_object.translation()).norm(), 0.05) << category;
  }
}

TEST(BoxConstraints, AHiddenBottomDoesNotPullTheDepthAway) {
  SyntheticView synthetic("chair", 0.7, {0.3, 0.2, 2.5}, Eigen::Vector2d::Zero());
  synthetic.view.detection.box.height *= 0.6;  // only the upper part is seen
  BoxSides open = synthetic.view.sides;
  open[3] = BoxSide::kOpen;
  const Wireframe wireframe = WireframeFromCoefficients(synthetic.model, synthetic.truth.coefficients);
  const Eigen::Matrix3d R = synthetic.truth.T_camera_object.linear();
  const double true_depth = 2.5;
  EXPECT_NEAR(TranslationFromBox(synthetic.view, open, wireframe, R).z(), true_depth, 0.15);
  EXPECT_GT(PrintedTranslation(synthetic.view, wireframe, R).z(), 1.2 * true_depth);
}

TEST(BoxConstraints, AnotherBoxBelowMakesTheBottomLikelyHidden) {
  const Box chair{100, 100, 100, 100}, table{50, 160, 300, 200}, apart{400, 100, 100, 100};
  EXPECT_GT(HiddenProbabilities(chair, {table})[3], 0.5);
  EXPECT_LT(HiddenProbabilities(chair, {apart})[3], 0.5);
  EXPECT_EQ(HiddenProbabilities(chair, {table})[1], 0);
}

TEST(LineSeeds, FindTheTableThatTheImageCuts) {
  SyntheticView synthetic("table", 0.5, {0.2, 0.5, 2.2}, Eigen::Vector2d::Zero(), 0.5);
  const Wireframe wireframe = WireframeFromCoefficients(synthetic.model, synthetic.truth.coefficients);
  const Eigen::Matrix3d R = synthetic.truth.T_camera_object.linear();
  const Eigen::RowVector3d up = synthetic.view.up_camera->transpose();
  const double lowest =
      (up * R * wireframe.midpoints - (up * R * wireframe.directions).cwiseAbs() / 2).minCoeff() +
      up.dot(synthetic.truth.T_camera_object.translation());
  synthetic.view.floor = FloorPrior{-lowest, 0.05};
  const auto translations = TranslationsFromLines(synthetic.view, wireframe, R);
  ASSERT_FALSE(translations.empty());
  double nearest = 1e9;
  for (const Eigen::Vector3d& T : translations) {
    nearest = std::min(nearest, (T - synthetic.truth.T_camera_object.translation()).norm());
  }
  EXPECT_LT(nearest, 0.02);
}

TEST(Hypotheses, HorizontalSegmentsVoteForTheTrueAzimuth) {
  const SyntheticView synthetic("table", 0.5, {0.1, 0.3, 2.6}, Eigen::Vector2d::Zero());
  const auto peaks = FindHorizontalAzimuths(synthetic.view, 0.7, 0.5, 1);
  ASSERT_EQ(peaks.size(), 1u);
  // Azimuths are about the ray to the box's centre here, so a degree or two of difference remains.
  EXPECT_LT(std::abs(WrapAngle(peaks[0] - 0.5)), 4 * kDegree);
}

TEST(Hypotheses, WithoutAPriorAllAzimuthsAreTried) {
  SyntheticView synthetic("chair", 0.5, {0.1, 0.3, 2.6}, Eigen::Vector2d::Zero());
  synthetic.view.detection.azimuth.reset();
  EXPECT_EQ(CandidateAzimuths(synthetic.view, {}).size(), 24u);
}

TEST(HypothesisCost, IsLowestAtTheTruth) {
  const SyntheticView synthetic("chair", 0.6, {0.1, 0.2, 2.6}, Eigen::Vector2d::Zero());
  const auto cost = [&](const PoseAndShape& at) {
    const ProjectedWireframe projected = synthetic.Project(at);
    return PriorCost(synthetic.view, at, WireframeFromCoefficients(synthetic.model, at.coefficients),
                     synthetic.view.sides, projected, {}, {}) +
           LineCost(projected, CoveredLength(projected, synthetic.view.segments, {8, 0.15}));
  };
  const double best = cost(synthetic.truth);
  for (const Eigen::Vector3d& shift :
       {Eigen::Vector3d(0.15, 0, 0), Eigen::Vector3d(0, 0.15, 0), Eigen::Vector3d(0, 0, 0.5)}) {
    PoseAndShape off = synthetic.truth;
    off.T_camera_object.translation() += shift;
    EXPECT_GT(cost(off), best + 1);
  }
  PoseAndShape turned = synthetic.truth;
  turned.T_camera_object.linear() = turned.T_camera_object.linear() * ExpSO3({0, 0.5, 0});
  EXPECT_GT(cost(turned), best + 1);
}

TEST(YawBelief, InterpolatesAndWrapsAround) {
  YawBelief belief;
  belief.cost.fill(1);
  belief.cost[0] = 3;
  const double bin = 2 * M_PI / YawBelief::kBins;
  EXPECT_NEAR(belief.At(-M_PI + 0.5 * bin), 3, 1e-9);
  EXPECT_NEAR(belief.At(-M_PI), 2, 1e-9);  // half-way between the last bin and the first
  EXPECT_NEAR(belief.At(0), 1, 1e-9);
}

}  // namespace
}  // namespace armature
