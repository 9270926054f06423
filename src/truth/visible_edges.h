// SPDX-License-Identifier: BSD-3-Clause
// Which parts of an object's true edges are seen in an image, and which of them segments cover.
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "association/projection.h"
#include "category/category_model.h"
#include "geometry/camera.h"
#include "geometry/segment.h"

namespace armature {

// When a segment is on an edge.
struct EdgeTolerance {
  double distance = 4;   // pixels
  double metres = 0;     // added to the distance, as seen at the edge's depth
  double angle_deg = 6;  // degrees
};

// A true edge in the image, sampled each pixel where it is not known to be hidden.
struct VisibleEdge {
  Segment line;                          // pixels: its part inside the image; no length: outside
  std::vector<Eigen::Vector2d> samples;  // pixels, one each pixel of length
  double visible_share = 1;              // of the samples; below 1 where it is not known which are hidden
  bool in_image = false;
  double pixels_per_metre = 0;  // at the middle of the line, across it
  double visible_length() const { return visible_share * static_cast<double>(samples.size()); }  // pixels
};

// The edge of which that share is seen, it is not known where.
VisibleEdge EdgeSeenInPart(const Segment& line, double visible_share, double pixels_per_metre);

// One an edge of the category. `occluders`: faces of other objects in the image.
std::vector<VisibleEdge> VisibleEdges(const Camera& camera, const CategorySpec& spec,
                                      const Wireframe& wireframe, const Eigen::Isometry3d& T_camera_object,
                                      const std::vector<ImageFace>& occluders);

// Pixels of the edge's visible length beside which some segment runs: within the distance of the segment,
// between its ends, the directions within the angle. Where it is not known which samples are hidden, those
// that are covered count as visible ones, as many as there are.
double CoveredLength(const VisibleEdge& edge, const std::vector<Segment>& segments,
                     const EdgeTolerance& tolerance);

// Pixels between the line of the edge, which is in the image, and the farther end of the segment.
double DistanceFromLine(const Segment& segment, const VisibleEdge& edge);

// Whether the segment is of the edge: both ends within the distance of the edge's line, the directions within
// the angle, and beside the edge's part in the image for at least a pixel. Hidden parts count, as truth's
// faces are only an outline, but not those of an edge of which nothing is seen by its visible share.
bool LiesOnEdge(const Segment& segment, const VisibleEdge& edge, const EdgeTolerance& tolerance);

// The `step`-th of `symmetry_order` equal parts of a turn about y.
Eigen::Matrix3d TurnAboutY(int symmetry_order, int step);

// For each edge, the one that stands where it would come to stand after turning the object about y by the
// `step`-th of `symmetry_order` equal parts of a turn: a table turned by 180 degrees has its top_rear where
// top_front was.
std::vector<int> SymmetricCounterparts(const Wireframe& wireframe, int symmetry_order, int step);

// The step of the object's symmetry under which the true rotation is nearest to the estimated one.
int NearestSymmetryStep(const Eigen::Matrix3d& R_estimated, const Eigen::Matrix3d& R_true,
                        int symmetry_order);

}  // namespace armature
