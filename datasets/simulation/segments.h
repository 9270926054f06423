// SPDX-License-Identifier: BSD-3-Clause
// Stands in for a renderer and a line detector: what ours finds in a picture of the scene, without the
// picture.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <opencv2/core.hpp>
#include <vector>

#include "datasets/simulation/surface_lines.h"
#include "drawing/ray_scene.h"
#include "geometry/camera.h"
#include "geometry/segment.h"

namespace armature {

// How the shipped detector finds lines, fitted to it on rendered pictures (datasets/README.md).
struct SegmentNoise {
  double patterns_per_m2 = 25;  // of wood, see surface_lines.cc
  double found_px = 12;         // length of a line that is found every second time
  double steepness = 1.6;       // of that, standard deviations a factor e of length
  double most = 0.75;           // no line is found more often, standard deviations: 77 %
  double persistence = 0.8;     // share of the variance that is the line's own, in all pictures
  double break_px = 110;        // mean length until a break
  double gap_px = 5;            // mean length of a break
  double end_px = 1.5;          // sigma of an end along the line
  double across_px = 0.8;       // sigma of an end across it
  double own_px = 2.5;          // lines nearer to a longer one, and along it, are lost to it
  double min_length_px = 10;    // as the detector's
};

// Pixels, longest first. `lines`: of the scene that the rays meet.
std::vector<Segment> SimulateSegments(const std::vector<SurfaceLine>& lines, const RayScene& rays,
                                      const Camera& camera, const Eigen::Isometry3d& T_world_camera,
                                      const SegmentNoise& noise, std::uint64_t seed);

// The number of the object that each pixel sees (RayScene), by a ray each other pixel and row.
cv::Mat1i SeeObjects(const RayScene& rays, const Camera& camera, const Eigen::Isometry3d& T_world_camera);

}  // namespace armature
