// SPDX-License-Identifier: BSD-3-Clause
// Prints where the furniture of a sequence is: example CATEGORIES SEQUENCE. README.md has the same.
#include <cstdio>
#include <opencv2/imgcodecs.hpp>

#include "io/category_yaml.h"
#include "io/sequence.h"
#include "pipeline/frame_pipeline.h"

int main(int, char** arguments) {
  using namespace armature;
  const std::vector<CategoryModel> models = LoadCategories(arguments[1]);
  const Sequence sequence = LoadSequence(arguments[2], {"chair", "table", "laptop"});
  FramePipeline pipeline(Options{}, sequence.camera, models, sequence.up, sequence.odometry_metric,
                         sequence.camera_height);
  for (size_t i = 0; i < sequence.images.size(); ++i) {
    const auto& [timestamp, file, line] = sequence.images[i];
    const cv::Mat gray = cv::imread(file, cv::IMREAD_GRAYSCALE);
    pipeline.Process(gray, {timestamp, sequence.detections[i], sequence.T_odom_camera[i]});
  }
  const auto maps = pipeline.SolveMaps();  // none without odometry
  for (const MapObject& object : maps.value().map.objects) {
    const Eigen::Vector3d at = object.T_world_object.translation(), size = object.Size();
    std::printf("%s at (%.2f, %.2f, %.2f) m, %.2f m high\n", object.id.c_str(), at.x(), at.y(), at.z(),
                size.y());
  }
}
