// SPDX-License-Identifier: BSD-3-Clause
// sequence.yaml
#include <fmt/format.h>

#include "base/errors.h"
#include "base/text.h"
#include "io/sequence.h"
#include "io/yaml_support.h"

namespace armature {
namespace {

int PositiveInteger(const YamlMap& map, const std::string& key) {
  const int value = map.Integer(key);
  if (value <= 0) throw InputError(map.At(key, fmt::format("is {}; it has to be greater than 0", value)));
  return value;
}

double PositiveNumber(const YamlMap& map, const std::string& key) {
  const double value = map.Number(key);
  if (value <= 0) throw InputError(map.At(key, fmt::format("is {}; it has to be greater than 0", value)));
  return value;
}

void ReadDistortion(const YamlMap& map, Camera* camera) {
  if (!map.Has("distortion")) return;
  const std::vector<double> values = map.Numbers("distortion");
  if (values.size() != camera->distortion.size()) {
    throw InputError(
        map.At("distortion", fmt::format("has {} values; write the five [k1, k2, p1, p2, k3], 0 where "
                                         "there is none",
                                         values.size())));
  }
  std::copy(values.begin(), values.end(), camera->distortion.begin());
}

Camera ReadCamera(const YamlMap& map) {
  map.CheckKeys({"model", "width", "height", "fx", "fy", "cx", "cy", "distortion"});
  if (map.Has("model") && map.Text("model") != "pinhole") {
    throw InputError(
        map.At("model", fmt::format("is {}; only 'pinhole' is known, undistort other images first",
                                    Quoted(map.Text("model")))));
  }
  Camera camera;
  camera.width = PositiveInteger(map, "width");
  camera.height = PositiveInteger(map, "height");
  camera.fx = PositiveNumber(map, "fx");
  camera.fy = PositiveNumber(map, "fy");
  camera.cx = map.Number("cx");
  camera.cy = map.Number("cy");
  ReadDistortion(map, &camera);
  return camera;
}

std::string ReadName(const YamlMap& map) {
  std::string name = map.Text("name");
  const bool is_plain = !name.empty() && name != "." && name != ".." && name.find('/') == std::string::npos;
  if (!is_plain) {
    throw InputError(
        map.At("name", fmt::format("is {}; it names a folder, so write a plain word", Quoted(name))));
  }
  return name;
}

Eigen::Vector3d ReadUp(const YamlMap& map) {
  const std::vector<double> values = map.Numbers("up");
  if (values.size() != 3) {
    throw InputError(map.At("up", fmt::format("has {} values; write the three [x, y, z]", values.size())));
  }
  const Eigen::Vector3d up(values[0], values[1], values[2]);
  if (up.norm() < 1e-6) throw InputError(map.At("up", "has no length; write a direction such as [0, -1, 0]"));
  return up.normalized();
}

}  // namespace

SequenceSettings ReadSequenceSettings(const std::filesystem::path& file) {
  const YamlMap map = YamlMap::Load(file);
  map.CheckKeys({"name", "fps", "camera", "up", "odometry_metric"});
  SequenceSettings settings;
  settings.name = ReadName(map);
  settings.fps = PositiveNumber(map, "fps");
  settings.camera = ReadCamera(map.Map("camera"));
  if (map.Has("up")) settings.up = ReadUp(map);
  if (map.Has("odometry_metric")) settings.odometry_metric = map.Boolean("odometry_metric");
  return settings;
}

}  // namespace armature
