// SPDX-License-Identifier: BSD-3-Clause
// A sequence with edges_gt.csv by hand, in round numbers, and runs on it with known matches.
#pragma once

#include <fmt/format.h>

#include <string>
#include <vector>

#include "support/true_world.h"

namespace armature::testing {

inline const char* const kTrueEdgesHeader = "# by hand\ntimestamp,id,edge,x1,y1,x2,y2,visible\n";

// At 0 s detection 0 is of a chair and 1 of a table, both 2.5 m deep: 5 cm are 10 px. At 0.2 s detections 0
// and 1 are false alarms. Of the chair's edges back_top (100 px of 100 seen) and seat_front (50 px of 100)
// count as visible; the others are too short, seen too little, or hidden. Both of the table's are seen: 100
// and 60 px.
class EdgeWorld {
 public:
  EdgeWorld() : models(LoadCategories(CategoryFolder())) {
    folder.Write(
        "sequence/sequence.yaml",
        "name: world\nfps: 5\ncamera:\n  model: pinhole\n  width: 640\n  height: 480\n  fx: 500\n  fy: 500\n"
        "  cx: 319.5\n  cy: 239.5\n  distortion: [0, 0, 0, 0, 0]\n");
    folder.Write("sequence/groundtruth.txt", "0.0 0 0 0 0 0 0 1\n0.2 0 0 0 0 0 0 1\n");
    folder.Write("sequence/objects_gt.csv",
                 fmt::format("id,category,instance,tx,ty,tz,qx,qy,qz,qw,size_x,size_y,size_z\n"
                             "chair0,chair,,{},0.4,0.8,0.4\ntable0,table,,{},1.2,0.74,0.6\n",
                             PoseText(ChairPose(), ","), PoseText(TablePose(), ",")));
    folder.Write("sequence/detections_gt.csv",
                 "timestamp,index,id\n0.0,0,chair0\n0.0,1,table0\n0.2,0,\n0.2,1,\n");
    WriteEdges(
        "0.0,chair0,back_top,100,100,200,100,1\n"
        "0.0,chair0,seat_front,100,200,200,200,0.5\n"
        "0.0,chair0,seat_rear,110,190,125,190,1\n"
        "0.0,chair0,leg_front_left,100,210,100,310,0.2\n"
        "0.0,chair0,leg_rear_left,150,210,150,290,0\n"
        "0.0,table0,top_front,300,200,400,200,1\n"
        "0.0,table0,top_rear,320,170,380,170,1\n");
  }

  static Eigen::Isometry3d ChairPose() { return SeenFrom(30, 20, {-0.5, 0, 2.5}); }
  static Eigen::Isometry3d TablePose() { return SeenFrom(-20, 20, {0.5, 0, 2.5}); }

  void WriteEdges(const std::string& rows) const {
    folder.Write("sequence/edges_gt.csv", kTrueEdgesHeader + rows);
  }

  SequenceTruth Truth() const { return LoadSequenceTruth(folder / "sequence", CollectSpecs(models)); }

  // A run with both objects at their true poses, the table's turned by half a turn if asked. `matches`: rows
  // of associations.csv without cost. `more`: further rows of observations.csv.
  std::filesystem::path WriteRun(const std::vector<std::string>& matches, bool turn_table = false,
                                 const std::string& more = "") const {
    const Eigen::Isometry3d table = turn_table ? HalfTurn("table", TablePose()) : TablePose();
    const std::string observations = fmt::format(
        "timestamp,index,status,object,cost,edges_matched,tx,ty,tz,qx,qy,qz,qw,shape\n"
        "0.0,0,ok,,1,5,{},\n0.0,1,ok,,1,5,{},\n",
        PoseText(ChairPose(), ","), PoseText(table, ","));
    std::string associations = "timestamp,index,edge,segment_x1,segment_y1,segment_x2,segment_y2,cost\n";
    for (const std::string& match : matches) associations += match + ",0.5\n";
    folder.Write("run/observations.csv", observations + more);
    folder.Write("run/associations.csv", associations);
    folder.Write("run/summary.json", "{\"sequence\": \"world\", \"complete\": true}\n");
    return folder / "run";
  }

  RunEvaluation Evaluate(const std::vector<std::string>& matches, bool turn_table = false,
                         const std::string& more = "") const {
    return EvaluateRun(LoadRun(WriteRun(matches, turn_table, more)), Truth(), models, CadLibrary());
  }

  TempFolder folder;
  std::vector<CategoryModel> models;
};

// The matches that are all right and find all visible edges.
inline std::vector<std::string> RightEdgeMatches() {
  return {"0.0,0,back_top,100,100,200,100", "0.0,0,seat_front,100,200,200,200",
          "0.0,1,top_front,300,200,400,200", "0.0,1,top_rear,320,170,380,170"};
}

}  // namespace armature::testing
