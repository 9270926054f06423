// SPDX-License-Identifier: BSD-3-Clause
#include "app/run/photo_arguments.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/errors.h"
#include "base/nearest_name.h"
#include "base/text.h"
#include "geometry/rotation.h"

namespace armature {
namespace {

std::string Where(const std::string& argument, const std::string& text) {
  return argument + " " + Quoted(text);
}

[[noreturn]] void ThrowCount(const std::string& where, size_t count, const std::string& format) {
  throw InputError(fmt::format("{}: has {} values; write {}", where, count, format));
}

std::vector<double> Numbers(const std::string& argument, const std::string& text, size_t count,
                            const std::string& format) {
  const std::vector<std::string> fields = SplitFields(text);
  const std::string where = Where(argument, text);
  if (fields.size() != count) ThrowCount(where, fields.size(), format);
  std::vector<double> numbers;
  numbers.reserve(count);
  for (const std::string& field : fields) numbers.push_back(ParseNumber(field, where));
  return numbers;
}

void CheckBox(const Box& box, const Camera& camera, const std::string& where) {
  if (box.width <= 0 || box.height <= 0) {
    throw InputError(fmt::format("{}: the box is {} x {} pixels; width and height have to be greater than 0",
                                 where, box.width, box.height));
  }
  const Box image{-0.5, -0.5, static_cast<double>(camera.width), static_cast<double>(camera.height)};
  if (Intersection(box, image).area() > 0) return;
  throw InputError(fmt::format("{}: the box is outside the {} x {} image; correct it", where, camera.width,
                               camera.height));
}

}  // namespace

Camera ParseCamera(const std::string& intrinsics, const std::string& distortion, int width, int height) {
  const std::vector<double> k = Numbers("--camera", intrinsics, 4, "fx,fy,cx,cy in pixels");
  if (k[0] <= 0 || k[1] <= 0) {
    throw InputError(fmt::format("{}: fx and fy have to be greater than 0", Where("--camera", intrinsics)));
  }
  Camera camera{width, height, k[0], k[1], k[2], k[3]};
  if (distortion.empty()) return camera;
  const std::vector<double> values =
      Numbers("--distortion", distortion, 5, "k1,k2,p1,p2,k3, 0 where there is none");
  std::copy(values.begin(), values.end(), camera.distortion.begin());
  return camera;
}

Detection ParseDetection(const std::string& text, const Camera& camera,
                         const std::vector<std::string>& categories) {
  const std::vector<std::string> fields = SplitFields(text);
  const std::string where = Where("--box", text);
  if (fields.size() < 5 || fields.size() > 6) {
    ThrowCount(where, fields.size(), "category,x,y,width,height[,azimuth_deg]");
  }
  Detection detection;
  detection.category = fields[0];
  if (std::find(categories.begin(), categories.end(), detection.category) == categories.end()) {
    throw InputError(
        fmt::format("{}: {}", where, UnknownNameMessage("category", detection.category, categories)));
  }
  detection.box = {ParseNumber(fields[1], where), ParseNumber(fields[2], where),
                   ParseNumber(fields[3], where), ParseNumber(fields[4], where)};
  CheckBox(detection.box, camera, where);
  if (fields.size() == 6) detection.azimuth = ParseNumber(fields[5], where) * kDegree;
  return detection;
}

Eigen::Vector3d ParseUp(const std::string& text) {
  const std::vector<double> values = Numbers("--up", text, 3, "x,y,z in the camera frame, such as 0,-1,0");
  const Eigen::Vector3d up(values[0], values[1], values[2]);
  if (up.norm() < 1e-6) {
    throw InputError(fmt::format("{}: has no length; write a direction such as 0,-1,0", Where("--up", text)));
  }
  return up.normalized();
}

}  // namespace armature
