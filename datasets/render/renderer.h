// SPDX-License-Identifier: BSD-3-Clause
// Pictures of a lit scene. Its light is computed once, for a grid of points on every surface, and looked up
// in every picture.
#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <opencv2/core.hpp>
#include <vector>

#include "drawing/ray_scene.h"
#include "geometry/camera.h"

namespace armature {

// A lit rectangle that faces down.
struct Lamp {
  Eigen::Vector3d centre{0, 0, 2.5};  // world, metres
  Eigen::Vector2d size{1.2, 0.3};     // along the world's x and y, metres
  Colour colour{1, 0.96, 0.9};
  double power = 1;  // relative brightness
};

struct RenderOptions {
  double light_grid = 0.03;  // metres between points where the light is computed
  int light_samples = 64;    // rays a point for reflected light; 3/8 of it to each lamp
  int samples = 4;           // rays a pixel
};

// What the sensor of a perfect camera receives.
struct Picture {
  cv::Mat3f radiance;  // linear blue, green, red; 1 is white. Well exposed, see light.h
  cv::Mat1i objects;   // the number of the object that each pixel's first ray meets, kRoom elsewhere
};

class Renderer {
 public:
  // Computes the light. The result does not depend on the number of threads.
  Renderer(std::vector<PlacedMesh> meshes, const std::vector<Lamp>& lamps, const RenderOptions& options);
  ~Renderer();

  const RayScene& rays() const;

  // Distortion of the camera is not rendered. Thread-safe; one thread a picture.
  Picture Render(const Camera& camera, const Eigen::Isometry3d& T_world_camera) const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace armature
