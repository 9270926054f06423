// SPDX-License-Identifier: BSD-3-Clause
// A true world with the input of a run, in which everything is wrong in a known way.
#pragma once

#include <string>

#include "support/true_world.h"

namespace armature::testing {

// At 0 s: detection 0 of the chair, 1 of the table, with viewpoint. At 0.2 s: a false alarm, the chair, a
// second box of it, the table taken for a chair, the table. The odometry is half as long as the true path,
// which leads 0.2 m to the right, and has its origin elsewhere.
class SubstitutionWorld : public TrueWorld {
 public:
  SubstitutionWorld() {
    folder.Write("sequence/sequence.yaml",
                 ReadFile(sequence_folder() / "sequence.yaml") + "up: [0, -1, 0]\n");
    folder.Write("sequence/rgb.txt", "0.0 -\n0.2 -\n");
    folder.Write("sequence/odometry.txt", "0.0 5 0 0 0 0 0 1\n0.2 5.1 0 0 0 0 0 1\n");
    folder.Write("sequence/detections.csv",
                 "timestamp,category,x,y,width,height,score,azimuth_deg,elevation_deg,tilt_deg\n"
                 "0.0,chair,150,150,100,180,0.9,,,\n"
                 "0.0,table,330,160,210,160,0.8,1,2,3\n"
                 "0.2,table,10,20,30,40,0.2,4,5,6\n"
                 "0.2,chair,120,150,100,180,0.9,10,20,0\n"
                 "0.2,chair,121,150,100,180,0.7,10,20,0\n"
                 "0.2,chair,300,160,210,160,0.6,7,8,9\n"
                 "0.2,table,300,160,210,160,0.8,,,\n");
    folder.Write("sequence/detections_gt.csv",
                 "timestamp,index,id\n0.0,0,chair0\n0.0,1,table0\n0.2,0,\n0.2,1,chair0\n0.2,2,chair0\n"
                 "0.2,3,table0\n0.2,4,table0\n");
    folder.Write("sequence/edges_gt.csv",
                 "timestamp,id,edge,x1,y1,x2,y2,visible\n"
                 "0.0,chair0,back_top,100,100,140,100,1\n"
                 "0.0,chair0,seat_front,100,200,140,200,0.5\n"
                 "0.0,chair0,seat_rear,100,180,140,180,0.2\n"
                 "0.2,table0,top_front,300,200,300,260,1\n"
                 "0.2,table0,top_rear,300,180,360,180,0\n");
    folder.Write("sequence/segments.csv", "timestamp,x1,y1,x2,y2\n0.0,1,1,50,60\n");
  }

  std::filesystem::path sequence_folder() const { return folder / "sequence"; }
};

}  // namespace armature::testing
