// SPDX-License-Identifier: BSD-3-Clause
// The light that falls on a quad, at points of a grid.
#pragma once

#include <vector>

#include "datasets/render/surfaces.h"
#include "datasets/render/textures.h"

namespace armature {

// Light: the radiance of a white, matt surface.
struct LightGrid {
  int columns = 2, rows = 2;  // along u and v
  std::vector<Rgb> light;     // row by row
  std::vector<char> hidden;   // whether the point is inside of something solid, so that nobody ever sees it

  LightGrid(const SurfaceQuad& quad, double spacing);

  size_t Index(int column, int row) const {
    return static_cast<size_t>(row) * static_cast<size_t>(columns) + static_cast<size_t>(column);
  }

  // Bilinear, u and v as those of RayHit.
  Rgb At(double u, double v) const;

  void Add(const LightGrid& other);  // of the same quad
  void Multiply(const Rgb& factor);

  // Gives hidden points next to others the mean of these: otherwise darkness would leak out of solids.
  void FillHidden();

  // Binomial, over three points a direction.
  void Smooth();
};

// Where a grid's point is: points of the rim are a little inside of the quad, as a neighbour may touch it.
Eigen::Vector3d MakePoint(const LightGrid& grid, const SurfaceQuad& quad, int column, int row);

}  // namespace armature
