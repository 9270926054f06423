// SPDX-License-Identifier: BSD-3-Clause
// A valid sequence folder of two images, to be spoilt by a test.
#pragma once

#include <opencv2/imgcodecs.hpp>

#include "support/temp_folder.h"

namespace armature::testing {

inline const char* const kTinySequenceYaml =
    "name: tiny\nfps: 5\ncamera:\n  model: pinhole\n  width: 64\n  height: 48\n  fx: 60\n  fy: 61\n  cx: "
    "31.5\n"
    "  cy: 23.5\n  distortion: [0.1, 0, 0, 0, 0]\nup: [0, -2, 0]\n";

// The same with another name.
inline std::string TinySequenceYaml(const std::string& name) {
  const std::string yaml = kTinySequenceYaml;
  return "name: " + name + yaml.substr(yaml.find('\n'));
}

inline const char* const kTinyDetectionsHeader =
    "timestamp,category,x,y,width,height,score,azimuth_deg,elevation_deg,tilt_deg\n";

inline void WriteTinySequence(const TempFolder& folder) {
  const cv::Mat image(48, 64, CV_8UC3, cv::Scalar(90, 120, 150));
  std::filesystem::create_directories(folder / "rgb");
  cv::imwrite((folder / "rgb/0.png").string(), image);
  cv::imwrite((folder / "rgb/1.png").string(), image);
  folder.Write("sequence.yaml", kTinySequenceYaml);
  folder.Write("rgb.txt", "# timestamp filename\n0.0 rgb/0.png\n0.2 rgb/1.png\n");
  folder.Write("detections.csv", std::string(kTinyDetectionsHeader) +
                                     "0.2,chair,5,6,20,30,0.9,90,-45,\n0.2,table,-5,6,20,30,0.5,,,\n");
  folder.Write("odometry.txt", "0.2004 1 2 3 0 0 0 1\n0.4 1 2 3 0 0 0 1\n");
}

}  // namespace armature::testing
