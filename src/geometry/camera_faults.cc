// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/camera_faults.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace armature {
namespace {

constexpr int kMostPixels = 65535;                         // in a row or column of a JPEG
constexpr double kShortest = 0.05, kLongest = 1000;        // focal lengths, of the image's size
constexpr double kUnusualRatio = 2, kImpossibleRatio = 5;  // of fx to fy, or of fy to fx
constexpr double kUnusualK1 = 10;
constexpr double kMostMoved = 3;  // how far a corner may be from where it is without distortion, as a ratio

using Faults = std::vector<CameraFault>;

void CheckSize(const char* key, int pixels, Faults& faults) {
  if (pixels <= kMostPixels) return;
  faults.push_back(
      {key, fmt::format("is {}; an image has at most {} pixels a side", pixels, kMostPixels), true});
}

void CheckFocalLength(const char* key, double focal, int size, Faults& faults) {
  if (focal < kShortest * size) {
    faults.push_back({key,
                      fmt::format("is {:g}, too short for {} pixels: it is in pixels; multiply a normalised "
                                  "focal length by the image's size",
                                  focal, size),
                      true});
  } else if (focal > kLongest * size) {
    faults.push_back(
        {key, fmt::format("is {:g}, too long for {} pixels; write the focal length in pixels", focal, size),
         true});
  }
}

void CheckRatio(const Camera& camera, Faults& faults) {
  const double ratio = std::max(camera.fx / camera.fy, camera.fy / camera.fx);
  if (ratio <= kUnusualRatio) return;
  faults.push_back({"fx",
                    fmt::format("is {:g} where fy is {:g}: pixels are about as wide as high; correct one",
                                camera.fx, camera.fy),
                    ratio > kImpossibleRatio});
}

void CheckPrincipalPoint(const char* key, double at, int size, Faults& faults) {
  const double outside = std::max(-0.5 - at, at - (size - 0.5));
  if (outside <= 0) return;
  faults.push_back(
      {key,
       fmt::format("is {:g}, outside the image of {} pixels; write the principal point in pixels "
                   "of this image",
                   at, size),
       outside > size});
}

// The radius without distortion that the lens brings to the distorted one; both over the focal length. None:
// the image folds before.
std::optional<double> UndistortedRadius(const std::array<double, 5>& distortion, double distorted) {
  const double k1 = distortion[0], k2 = distortion[1], k3 = distortion[4];
  constexpr int kSteps = 2000;
  double before = 0, r = 0;
  for (double step = distorted / kSteps; r < 1e3 * distorted; step *= 1.005) {
    r += step;
    const double r2 = r * r, now = r * (1 + r2 * (k1 + r2 * (k2 + r2 * k3)));
    if (now <= before) return std::nullopt;
    if (now >= distorted) return r;
    before = now;
  }
  return std::nullopt;
}

double FarthestCorner(const Camera& camera) {
  double farthest = 0;
  for (const double x : {-0.5, camera.width - 0.5}) {
    for (const double y : {-0.5, camera.height - 0.5})
      farthest = std::max(farthest, std::hypot((x - camera.cx) / camera.fx, (y - camera.cy) / camera.fy));
  }
  return farthest;
}

void CheckDistortion(const Camera& camera, Faults& faults) {
  if (!camera.IsDistorted()) return;
  const auto add = [&](const std::string& what, bool is_impossible) {
    faults.push_back({"distortion", what, is_impossible});
  };
  const auto& k = camera.distortion;
  const double corner = FarthestCorner(camera);
  const std::optional<double> undistorted = UndistortedRadius(k, corner);
  const double tangential = 3 * corner * std::max(std::abs(k[2]), std::abs(k[3]));
  if (!undistorted) {
    add("folds inside the image: its k1, k2, k3 bring two directions to one pixel; write [k1, k2, p1, p2, "
        "k3] of "
        "this image's size",
        true);
  } else if (std::max(*undistorted / corner, corner / *undistorted) > kMostMoved ||
             tangential > kMostMoved - 1) {
    add("moves the image's corners more than threefold; write [k1, k2, p1, p2, k3] as OpenCV has them", true);
  } else if (std::abs(k[0]) > kUnusualK1) {
    add(fmt::format("has k1 = {:g}, which hardly any lens has; write [k1, k2, p1, p2, k3] as OpenCV has them",
                    k[0]),
        false);
  }
}

}  // namespace

std::vector<CameraFault> FindCameraFaults(const Camera& camera) {
  Faults faults;
  CheckSize("width", camera.width, faults);
  CheckSize("height", camera.height, faults);
  CheckFocalLength("fx", camera.fx, camera.width, faults);
  CheckFocalLength("fy", camera.fy, camera.height, faults);
  CheckRatio(camera, faults);
  CheckPrincipalPoint("cx", camera.cx, camera.width, faults);
  CheckPrincipalPoint("cy", camera.cy, camera.height, faults);
  if (faults.empty()) CheckDistortion(camera, faults);
  return faults;
}

}  // namespace armature
