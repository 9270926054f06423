// SPDX-License-Identifier: BSD-3-Clause
// A published table of key points and boxes in miniature: chairs of a seat and a back in units of their own.
#pragma once

#include <fmt/format.h>

#include <string>
#include <vector>

#include "category/kept_apart.h"
#include "support/temp_folder.h"

namespace armature::testing {

// The first id of this form that is kept apart, or is not.
inline std::string PublishedId(bool kept_apart) {
  for (int i = 0;; ++i) {
    std::string id = fmt::format("model{}", i);
    if (IsKeptApart(id) == kept_apart) return id;
  }
}

// In units of half a metre, y up, back at +z: 1 wide, 1 deep, seat at 0.9, 1.8 high, its feet at y = -0.9.
inline void WritePublishedChairs(const TempFolder& folder, const std::vector<std::string>& ids) {
  std::string points = "model_id,sane,has_arms";
  for (const char* name : {"s0", "s1", "s2", "s3", "s4", "s5", "s17", "s18", "s19", "s20"})
    points += fmt::format(",{}_x,{}_y,{}_z", name, name, name);
  points += "\n";
  std::string boxes;
  for (const std::string& id : ids) {
    points += id + ",1,0,0.5,0.9,0.5,-0.5,0.9,0.5,0.5,0,0.5,-0.5,0,0.5,0.5,0,-0.5,-0.5,0,-0.5";
    points += ",0.5,-0.9,-0.5,0.5,-0.9,0.5,-0.5,-0.9,0.5,-0.5,-0.9,-0.5\n";
    const std::string axes = " 1 0 0 0 1 0 0 0 1\n";
    boxes += id + " 7 0 -0.05 0 0.5 0.05 0.5" + axes + id + " 7 0 0.45 0.45 0.5 0.45 0.05" + axes;
    for (const char* x : {"-0.45", "0.45"}) {
      for (const char* z : {"-0.45", "0.45"})
        boxes += fmt::format("{} 7 {} -0.5 {} 0.05 0.4 0.05{}", id, x, z, axes);
    }
  }
  folder.Write("keypointnet_chair_kp10.csv", points);
  folder.Write("keypointnet_chair_boxes.txt", boxes);
}

}  // namespace armature::testing
