// SPDX-License-Identifier: BSD-3-Clause
// What stands in for the keypoint network's forward pass: each takes its time in another way, none sees
// anything.
#pragma once

#include <map>
#include <memory>
#include <opencv2/core.hpp>
#include <string>

namespace armature {

constexpr int kPassInput = 256;           // pixels, of the square picture
constexpr double kPublishedPassMs = 285;  // an object, keypoint network of Parkhiya et al. 2018 on a Titan X
                                          // with 12 GB: the paper, section 4, "3 x 285 ms"

class ForwardPass {
 public:
  virtual ~ForwardPass() = default;
  // What takes the time, to follow "forward pass: ".
  virtual std::string Description() const = 0;
  // `picture`: 8 bit, three channels, kPassInput x kPassInput. Returns the milliseconds that count though
  // they were not waited for.
  virtual double Run(const cv::Mat& picture, const std::string& category) = 0;
};

// Adds the published time.
std::unique_ptr<ForwardPass> MakePublishedPass();

// Waits for the published time, up to 5 % more or less.
std::unique_ptr<ForwardPass> MakeWaitingPass();

// Runs a stacked hourglass. `keypoints`: how many each category has; each has a network of its own.
std::unique_ptr<ForwardPass> MakeHourglassPass(const std::map<std::string, int>& keypoints);

}  // namespace armature
