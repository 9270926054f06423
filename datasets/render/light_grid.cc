// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/render/light_grid.h"

#include <algorithm>
#include <cmath>

namespace armature {
namespace {

constexpr double kInset = 0.005;       // metres from the quad's sides
constexpr double kMaximalInset = 0.2;  // share of the quad

int PointsAlong(double length, double spacing) {
  return std::max(2, static_cast<int>(std::ceil(length / spacing)) + 1);
}

double Coordinate(int index, int count, double length) {
  const double inset = length > 0 ? std::min(kInset / length, kMaximalInset) : kMaximalInset;
  return std::clamp(index / (count - 1.0), inset, 1 - inset);
}

}  // namespace

LightGrid::LightGrid(const SurfaceQuad& quad, double spacing)
    : columns(PointsAlong(quad.Width(), spacing)), rows(PointsAlong(quad.Height(), spacing)) {
  light.assign(Index(0, rows), Rgb(0, 0, 0));
  hidden.assign(light.size(), 0);
}

Rgb LightGrid::At(double u, double v) const {
  const float x = std::clamp(static_cast<float>(u), 0.0f, 1.0f) * static_cast<float>(columns - 1);
  const float y = std::clamp(static_cast<float>(v), 0.0f, 1.0f) * static_cast<float>(rows - 1);
  const int column = std::min(static_cast<int>(x), columns - 2),
            row = std::min(static_cast<int>(y), rows - 2);
  const float tx = x - static_cast<float>(column), ty = y - static_cast<float>(row);
  const Rgb* low = &light[Index(column, row)];
  const Rgb* high = low + columns;
  return (low[0] + (low[1] - low[0]) * tx) * (1 - ty) + (high[0] + (high[1] - high[0]) * tx) * ty;
}

void LightGrid::Add(const LightGrid& other) {
  for (size_t i = 0; i < light.size(); ++i) light[i] += other.light[i];
}

void LightGrid::Multiply(const Rgb& factor) {
  for (Rgb& value : light) value *= factor;
}

void LightGrid::FillHidden() {
  const std::vector<Rgb> before = light;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      if (hidden[Index(column, row)] == 0) continue;
      Rgb sum(0, 0, 0);
      int count = 0;
      for (int y = std::max(row - 1, 0); y <= std::min(row + 1, rows - 1); ++y) {
        for (int x = std::max(column - 1, 0); x <= std::min(column + 1, columns - 1); ++x) {
          if (hidden[Index(x, y)] != 0) continue;
          sum += before[Index(x, y)];
          ++count;
        }
      }
      if (count > 0) light[Index(column, row)] = sum / static_cast<float>(count);
    }
  }
}

void LightGrid::Smooth() {
  const auto pass = [&](int count, int lines, size_t step, size_t line_step) {
    std::vector<Rgb> line(static_cast<size_t>(count));
    for (int l = 0; l < lines; ++l) {
      Rgb* const first = &light[static_cast<size_t>(l) * line_step];
      for (int i = 0; i < count; ++i) {
        const int previous = std::max(i - 1, 0), next = std::min(i + 1, count - 1);
        line[static_cast<size_t>(i)] =
            0.25f * (first[static_cast<size_t>(previous) * step] + first[static_cast<size_t>(next) * step]) +
            0.5f * first[static_cast<size_t>(i) * step];
      }
      for (int i = 0; i < count; ++i) first[static_cast<size_t>(i) * step] = line[static_cast<size_t>(i)];
    }
  };
  const auto width = static_cast<size_t>(columns);
  if (columns > 3) pass(columns, rows, 1, width);
  if (rows > 3) pass(rows, columns, width, 1);
}

Eigen::Vector3d MakePoint(const LightGrid& grid, const SurfaceQuad& quad, int column, int row) {
  return quad.At(Coordinate(column, grid.columns, quad.Width()), Coordinate(row, grid.rows, quad.Height()));
}

}  // namespace armature
