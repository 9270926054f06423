// SPDX-License-Identifier: BSD-3-Clause
// Where the edges of a sequence's objects truly are in its images, and how much of each is seen.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "category/category_model.h"
#include "geometry/segment.h"
#include "truth/ground_truth.h"
#include "truth/visible_edges.h"

namespace armature {

class TrueEdges {
 public:
  // Reads edges_gt.csv: `timestamp,id,edge,x1,y1,x2,y2,visible`, a row an edge that is in the image: the ends
  // of its part in the image, undistorted pixels, in the edge's sense, and the share (0..1) of that part
  // which nothing hides. Throws InputError: a malformed row, a stamp that no true camera has, an id that is
  // not in objects_gt.csv, an edge that the object's category has not, a repeated row, a category without
  // specification.
  TrueEdges(const std::filesystem::path& file, const GroundTruth& truth,
            const std::vector<CategorySpec>& specs);

  // One an edge of the object's category, seen at the stamp; those without row are outside the image.
  // `pixels_per_metre`: at the object.
  std::vector<VisibleEdge> Seen(size_t object, double timestamp, double pixels_per_metre) const;

 private:
  struct Row {
    Segment line;
    double visible_share = 0;
    int number = 0;  // of the line in the file
  };
  using Rows = std::vector<std::optional<Row>>;  // one an edge of the category

  const Rows* Find(size_t object, double timestamp) const;

  std::vector<size_t> edge_counts_;                       // of each object
  std::map<std::pair<long long, size_t>, Rows> rows_of_;  // by (whole microseconds, object)
};

}  // namespace armature
