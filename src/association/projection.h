// SPDX-License-Identifier: BSD-3-Clause
// A wireframe seen by the camera: where its edges are in the image and which parts of them can be seen.
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "category/category_model.h"
#include "geometry/box.h"
#include "geometry/camera.h"
#include "geometry/segment.h"

namespace armature {

// A flat opaque polygon in the image. The inverse depth of a plane is affine in the pixel: 1/z =
// inverse_depth . (u, v, 1).
struct ImageFace {
  std::vector<Eigen::Vector2d> corners;       // pixels, in order
  Eigen::Vector2d least{0, 0}, most{-1, -1};  // pixels: the rectangle around the corners
  Eigen::Vector3d inverse_depth;              // 1/metres
  // Whether the face hides what lies at the pixel with the given inverse depth (a hair behind it, so that a
  // face does not hide its own border).
  bool Hides(const Eigen::Vector2d& pixel, double inverse_z) const;
};

struct ProjectedEdge {
  Segment line;           // pixels: the part inside the image (and the clip box), from s1 to s2
  double s1 = 0, s2 = 0;  // its ends on the edge: point M + s D, -1/2 .. 1/2
  double inverse_z1 = 0, inverse_z2 = 0;  // 1/metres at its ends
  Eigen::Vector2d direction{1, 0};        // unit, pixels
  double length = 0;                      // pixels; 0: outside the image or behind the camera
  double visible_share = 0;               // of that length, not hidden by faces
  double drop = 0;   // metres by which `line` is that of the edge moved down, object frame: see SlabOutline
  double slack = 0;  // pixels that the drop amounts to: segments scatter by them
};

struct ProjectedWireframe {
  std::vector<ProjectedEdge> edges;  // one an edge of the category
  std::vector<ImageFace> faces;      // of the object itself

  double VisibleLength() const;  // pixels, all edges
};

// The corners of a polygon given in the camera frame, cut at the near plane; no corners when all of it is
// behind.
ImageFace ProjectFace(const Camera& camera, const Eigen::Matrix3Xd& corners_camera);

// The object's faces in the image, e.g. as occluders of what is behind it.
std::vector<ImageFace> ProjectFaces(const Camera& camera, const CategorySpec& spec,
                                    const Wireframe& wireframe, const Eigen::Isometry3d& T_camera_object);

// Projects and clips to `clip` (at least the image; smaller where the object is known to be cut or hidden
// beyond a line). Every edge's visible share is left at 0.
void ProjectEdges(const Camera& camera, const Wireframe& wireframe, const Eigen::Isometry3d& T_camera_object,
                  const Box& clip, ProjectedWireframe& out);

// The same with a slab's near sides where they are seen.
void ProjectSeenEdges(const Camera& camera, const CategorySpec& spec, const Wireframe& wireframe,
                      const Eigen::Isometry3d& T_camera_object, const Box& clip, ProjectedWireframe& out);

// Then determines which parts are hidden by the object's own faces and by `occluders`: most of the work.
void DetermineVisibility(const Camera& camera, const CategorySpec& spec, const Wireframe& wireframe,
                         const Eigen::Isometry3d& T_camera_object, const std::vector<ImageFace>& occluders,
                         ProjectedWireframe& out);

// Both, edges as they are seen.
void ProjectWireframe(const Camera& camera, const CategorySpec& spec, const Wireframe& wireframe,
                      const Eigen::Isometry3d& T_camera_object, const Box& clip,
                      const std::vector<ImageFace>& occluders, ProjectedWireframe& out);

}  // namespace armature
