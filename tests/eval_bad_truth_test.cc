// SPDX-License-Identifier: BSD-3-Clause
// Ground truth that cannot be right is refused with its line.
#include <gtest/gtest.h>

#include "support/expect_input_error.h"
#include "support/true_world.h"

namespace armature {
namespace {

using testing::ExpectInputError;
using testing::ReadFile;
using testing::TrueWorld;

class BadTruth : public ::testing::Test {
 protected:
  void ExpectError(const std::vector<std::string>& texts) const {
    ExpectInputError([&] { LoadSequenceTruth(world_.folder / "sequence", world_.specs); }, texts);
  }
  void Replace(const std::string& file, const std::string& from, const std::string& to) const {
    std::string text = ReadFile(world_.folder / ("sequence/" + file));
    text.replace(text.find(from), from.size(), to);
    world_.folder.Write("sequence/" + file, text);
  }

  TrueWorld world_;
};

TEST_F(BadTruth, HasAnObjectTwice) {
  Replace("objects_gt.csv", "table0,table", "chair0,table");
  ExpectError({"objects_gt.csv:3", "'chair0'", "line 2"});
}

TEST_F(BadTruth, HasSizesThatAreNone) {
  Replace("objects_gt.csv", "0.4,0.8,0.4", "-0.4,0.8,0.4");
  ExpectError({"objects_gt.csv:2", "'chair0'", "-0.4 x 0.8 x 0.4"});
  Replace("objects_gt.csv", "-0.4,0.8,0.4", "0.4,0,0.4");
  ExpectError({"objects_gt.csv:2", "greater than 0"});
}

TEST_F(BadTruth, HasACategoryWithoutModel) {
  Replace("objects_gt.csv", "table0,table", "table0,tabel");
  ExpectError({"objects_gt.csv:3", "'tabel'", "'table'"});
}

TEST_F(BadTruth, IsOfDetectionsThatAreNotThere) {
  world_.folder.Write("sequence/detections.csv",
                      "timestamp,category,x,y,width,height,score\n0.0,chair,1,1,9,9,1\n0.0,table,1,1,9,9,1\n"
                      "0.2,chair,1,1,9,9,1\n0.2,table,1,1,9,9,1\n0.2,table,1,1,9,9,1\n");
  LoadSequenceTruth(world_.folder / "sequence", world_.specs);
  Replace("detections_gt.csv", "0.0,1,table0", "0.0,2,table0");  // counted from 1
  ExpectError({"detections_gt.csv:3", "index 2", "2 detections", "from 0"});
  Replace("detections_gt.csv", "0.0,2,table0", "0.1,0,table0");
  ExpectError({"detections_gt.csv:3", "index 0", "0 detections at stamp 0.100000"});
  Replace("detections_gt.csv", "0.1,0,table0", "0.0,-1,table0");
  ExpectError({"detections_gt.csv:3", "index -1"});
  Replace("detections_gt.csv", "0.0,-1,table0", "0.0,0,table0");
  ExpectError({"detections_gt.csv:3", "line 2"});
}

}  // namespace
}  // namespace armature
