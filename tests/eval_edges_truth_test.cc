// SPDX-License-Identifier: BSD-3-Clause
// edges_gt.csv: reading it, and matches judged by it.
#include <gtest/gtest.h>

#include "support/edge_world.h"
#include "support/expect_input_error.h"

namespace armature {
namespace {

using testing::EdgeWorld;
using testing::ExpectInputError;

const std::string kBackTop = "0.0,chair0,back_top,100,100,200,100,1\n";

MatchCounts ChairCounts(const RunEvaluation& evaluation) { return *evaluation.detections.at(0).matches; }
MatchCounts TableCounts(const RunEvaluation& evaluation) { return *evaluation.detections.at(1).matches; }

TEST(EvalTrueEdges, AreReadInTheOrderOfTheCategory) {
  const EdgeWorld world;
  const SequenceTruth truth = world.Truth();
  ASSERT_TRUE(truth.edges);
  const std::vector<VisibleEdge> edges = truth.edges->Seen(0, 0.0004, 200);
  const CategorySpec spec = LookUpModel(world.models, "chair").spec;
  ASSERT_EQ(edges.size(), spec.edge_names.size());
  for (size_t i = 0; i < edges.size(); ++i) {
    const std::string& name = spec.edge_names[i];
    EXPECT_EQ(edges[i].in_image, name == "back_top" || name == "seat_front" || name == "seat_rear" ||
                                     name == "leg_front_left" || name == "leg_rear_left")
        << name;
    EXPECT_EQ(IsVisible(edges[i]), name == "back_top" || name == "seat_front") << name;
    if (name != "seat_front") continue;
    EXPECT_EQ(edges[i].line.p2, Eigen::Vector2d(200, 200));
    EXPECT_EQ(edges[i].visible_length(), 50);
    EXPECT_EQ(edges[i].pixels_per_metre, 200);
  }
}

TEST(EvalTrueEdges, NoneAtOtherTimes) {
  const EdgeWorld world;
  for (const VisibleEdge& edge : world.Truth().edges->Seen(0, 0.2, 200)) {
    EXPECT_FALSE(edge.in_image);
    EXPECT_EQ(edge.visible_length(), 0);
  }
}

TEST(EvalTrueEdges, SequencesWithoutThem) {
  const EdgeWorld world;
  std::filesystem::remove(world.folder / "sequence/edges_gt.csv");
  EXPECT_FALSE(world.Truth().edges);
}

TEST(EvalTrueEdges, BadRows) {
  const EdgeWorld world;
  const auto refused = [&](const std::string& rows, const std::vector<std::string>& texts) {
    world.WriteEdges(kBackTop + rows);
    ExpectInputError([&] { world.Truth(); }, texts);
  };
  refused("0.0,chair7,seat_rear,1,2,3,4,1\n", {"edges_gt.csv:4", "chair7", "objects_gt.csv"});
  refused("0.0,chair0,seat_raer,1,2,3,4,1\n", {"edges_gt.csv:4", "chair", "seat_raer", "seat_rear"});
  refused("0.0,table0,back_top,1,2,3,4,1\n", {"edges_gt.csv:4", "table", "back_top"});
  refused("0.0,chair0,seat_rear,1,2,3,4,1.01\n", {"edges_gt.csv:4", "visible", "1.01"});
  refused("0.0,chair0,seat_rear,1,2,3,4,-0.1\n", {"edges_gt.csv:4", "visible", "-0.1"});
  refused("0.0,chair0,seat_rear,1,2,3,four,1\n", {"edges_gt.csv:4", "y2", "four"});
  refused("0.0,chair0,seat_rear,1,2,nan,4,1\n", {"edges_gt.csv:4", "x2"});
  refused("0.0,chair0,seat_rear,1,2,3,4\n", {"edges_gt.csv:4", "7 fields"});
  refused("0.0,chair0,back_top,1,2,3,4,1\n", {"edges_gt.csv:4", "back_top", "line 3"});
  refused("0.1,chair0,seat_rear,1,2,3,4,1\n", {"edges_gt.csv:4", "0.1", "groundtruth.txt"});
  world.folder.Write("sequence/edges_gt.csv", "timestamp,id,edge,x1,y1,x2,y2\n");
  ExpectInputError([&] { world.Truth(); }, {"edges_gt.csv:1", "visible"});
}

TEST(EvalTrueEdges, AllRight) {
  const EdgeWorld world;
  const RunEvaluation evaluation = world.Evaluate(testing::RightEdgeMatches());
  EXPECT_TRUE(evaluation.has_true_edges);
  for (const EvaluatedDetection& d : evaluation.detections) {
    const MatchCounts& counts = *d.matches;
    EXPECT_EQ(counts.matches, 2);
    EXPECT_EQ(counts.visible_edges, 2);
    for (const RightMatches& right : {counts.on_edge, counts.near_edge}) {
      EXPECT_EQ(right.matches, 2);
      EXPECT_EQ(right.edges, 2);
      EXPECT_EQ(right.match_length, counts.match_length);
      EXPECT_EQ(right.covered_length, counts.visible_length);
    }
  }
  EXPECT_EQ(ChairCounts(evaluation).visible_length, 150);
  EXPECT_EQ(TableCounts(evaluation).visible_length, 160);
}

TEST(EvalTrueEdges, ASwappedPairIsWrong) {
  const EdgeWorld world;
  const MatchCounts counts =
      ChairCounts(world.Evaluate({"0.0,0,seat_front,100,100,200,100", "0.0,0,back_top,100,200,200,200"}));
  EXPECT_EQ(counts.matches, 2);
  EXPECT_EQ(counts.near_edge.matches, 0);
  EXPECT_EQ(counts.near_edge.edges, 0);
  EXPECT_EQ(counts.near_edge.covered_length, 0);
}

// Turned by half a turn the table's rear edge is called its front edge: right if and only if the pose says
// so.
TEST(EvalTrueEdges, SymmetricTurn) {
  const EdgeWorld world;
  const std::vector<std::string> swapped = {"0.0,1,top_rear,300,200,400,200",
                                            "0.0,1,top_front,320,170,380,170"};
  const RunEvaluation turned = world.Evaluate(swapped, true);
  EXPECT_EQ(TableCounts(turned).on_edge.matches, 2);
  EXPECT_EQ(TableCounts(turned).on_edge.edges, 2);
  EXPECT_EQ(turned.detections[1].judged[0].edge, "top_rear");
  EXPECT_EQ(turned.detections[1].judged[0].true_edge, "top_front");
  EXPECT_EQ(TableCounts(world.Evaluate(swapped, false)).on_edge.matches, 0);
  EXPECT_EQ(TableCounts(world.Evaluate(testing::RightEdgeMatches(), true)).on_edge.matches, 0);
}

TEST(EvalTrueEdges, AMatchOnAHiddenEdgeIsWrong) {
  const EdgeWorld world;
  const RunEvaluation evaluation = world.Evaluate({"0.0,0,leg_rear_left,150,210,150,290"});
  EXPECT_EQ(ChairCounts(evaluation).on_edge.matches, 0);
  EXPECT_EQ(ChairCounts(evaluation).near_edge.matches, 0);
  EXPECT_EQ(evaluation.detections[0].judged[0].distance, 0.0);  // it is only hidden
}

TEST(EvalTrueEdges, AMatchOnAnEdgeThatIsSeenTooLittleIsRightButFindsNothing) {
  const EdgeWorld world;
  const MatchCounts counts = ChairCounts(
      world.Evaluate({"0.0,0,leg_front_left,100,210,100,310", "0.0,0,seat_rear,110,190,125,190"}));
  EXPECT_EQ(counts.on_edge.matches, 2);
  EXPECT_EQ(counts.visible_edges, 2);
  EXPECT_EQ(counts.on_edge.edges, 0);
  EXPECT_EQ(counts.on_edge.covered_length, 0);
}

TEST(EvalTrueEdges, AMatchOutsideTheImageIsWrong) {
  const EdgeWorld world;
  const RunEvaluation evaluation = world.Evaluate({"0.0,0,leg_rear_right,150,210,150,290"});
  EXPECT_EQ(ChairCounts(evaluation).near_edge.matches, 0);
  EXPECT_FALSE(evaluation.detections[0].judged[0].distance);
}

// 5 cm are 10 px at the depth of the objects' centres.
TEST(EvalTrueEdges, CentimetresBesideTheEdgeAreNear) {
  const EdgeWorld world;
  const auto at = [&](int y) {
    return world.Evaluate({fmt::format("0.0,0,back_top,100,{0},200,{0}", y)}).detections[0];
  };
  EXPECT_TRUE(at(104).judged[0].on_edge);
  EXPECT_FALSE(at(105).judged[0].on_edge);
  EXPECT_TRUE(at(114).judged[0].near_edge);
  EXPECT_EQ(at(114).matches->near_edge.covered_length, 100);
  EXPECT_FALSE(at(115).judged[0].near_edge);
  EXPECT_EQ(*at(115).judged[0].distance, 15.0);
}

TEST(EvalTrueEdges, Lengths) {
  const EdgeWorld world;
  const MatchCounts counts = ChairCounts(world.Evaluate(
      {"0.0,0,back_top,100,100,130,100", "0.0,0,back_top,120,101,150,101",  // two overlapping fragments
       "0.0,0,seat_front,100,200,200,200",                                  // longer than what is seen
       "0.0,0,seat_front,100,300,140,300"}));                               // elsewhere
  EXPECT_EQ(counts.matches, 4);
  EXPECT_EQ(counts.match_length, 200);
  EXPECT_EQ(counts.on_edge.matches, 3);
  EXPECT_EQ(counts.on_edge.edges, 2);
  EXPECT_EQ(counts.on_edge.match_length, 160);
  EXPECT_EQ(counts.visible_length, 150);
  EXPECT_EQ(counts.on_edge.covered_length, 100);  // 50 of the one, no more than the visible 50 of the other
}

TEST(EvalTrueEdges, WithoutPoseNothingIsFound) {
  const EdgeWorld world;
  world.WriteRun({"0.0,0,back_top,100,100,200,100"});
  world.folder.Write("run/observations.csv",
                     "timestamp,index,status,object,cost,edges_matched,tx,ty,tz,qx,qy,qz,qw,shape\n"
                     "0.0,0,diverged,,,0,,,,,,,,\n");
  const MatchCounts counts =
      ChairCounts(EvaluateRun(LoadRun(world.folder / "run"), world.Truth(), world.models, CadLibrary()));
  EXPECT_EQ(counts.matches, 0);
  EXPECT_EQ(counts.visible_edges, 2);
}

TEST(EvalTrueEdges, FalseAlarmsWithPose) {
  const EdgeWorld world;
  EXPECT_EQ(world.Evaluate({}).false_alarms, 2);
  EXPECT_EQ(world.Evaluate({}).trusted_false_alarms, 0);
  const RunEvaluation evaluation =
      world.Evaluate({}, false, "0.2,0,ok,,1,5,0,0,3,0,0,0,1,\n0.2,1,ambiguous,,1,5,0,0,3,0,0,0,1,\n");
  EXPECT_EQ(evaluation.false_alarms, 2);
  EXPECT_EQ(evaluation.trusted_false_alarms, 1);
}

// What the CAD models tell is written as edges_gt.csv, without one of the chair's edges: it is the file that
// counts.
TEST(EvalTrueEdges, ArePreferredToCad) {
  const testing::TrueWorld world;
  const auto run = world.WriteRun("run", testing::Unchanged, testing::SameName);
  const TrueScene scene(world.sequence, world.models, world.cad);
  std::string rows = testing::kTrueEdgesHeader;
  for (size_t object = 0; object < 2; ++object) {
    for (const TimedPose& camera : world.sequence.truth.T_world_camera) {
      const std::vector<VisibleEdge> edges = *scene.EdgesSeen(object, camera);
      for (size_t e = 0; e < edges.size(); ++e) {
        const Segment& line = edges[e].line;
        const std::string& name = scene.spec(object).edge_names[e];
        if (name == "back_top" || !edges[e].in_image) continue;
        rows +=
            fmt::format("{},{},{},{},{},{},{},{}\n", camera.timestamp,
                        world.sequence.truth.objects[object].id, name, line.p1.x(), line.p1.y(), line.p2.x(),
                        line.p2.y(), edges[e].visible_length() / std::max(1.0, std::round(line.length())));
      }
    }
  }
  world.folder.Write("sequence/edges_gt.csv", rows);
  const RunEvaluation by_cad = world.Evaluate(run);
  const RunEvaluation by_file =
      EvaluateRun(LoadRun(run), LoadSequenceTruth(world.folder / "sequence", CollectSpecs(world.models)),
                  world.models, world.cad);
  ASSERT_EQ(by_file.detections.size(), by_cad.detections.size());
  for (size_t i = 0; i < by_cad.detections.size(); ++i) {
    const MatchCounts &cad = *by_cad.detections[i].matches, &file = *by_file.detections[i].matches;
    const int left_out = by_cad.detections[i].category == "chair" ? 1 : 0;
    EXPECT_EQ(file.matches, cad.matches);
    EXPECT_EQ(file.on_edge.matches, cad.on_edge.matches - left_out);
    EXPECT_EQ(file.on_edge.edges, file.visible_edges);
    EXPECT_DOUBLE_EQ(file.on_edge.covered_length, file.visible_length);
  }
}

}  // namespace
}  // namespace armature
