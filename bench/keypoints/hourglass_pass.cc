// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "bench/keypoints/forward_pass.h"
#include "bench/keypoints/hourglass_network.h"

namespace armature {
namespace {

class HourglassPass : public ForwardPass {
 public:
  explicit HourglassPass(const std::map<std::string, int>& keypoints) {
    for (const auto& [category, maps] : keypoints) {
      HourglassNetwork& network =
          networks_.try_emplace(category, HourglassOptions{.maps = maps, .input = kPassInput}).first->second;
      cost_ = network.cost();
      network.Forward(cv::Mat::zeros(kPassInput, kPassInput, CV_8UC3));  // allocates and fuses its layers
    }
  }

  std::string Description() const override {
    return fmt::format(
        "a two-stack stacked hourglass ({:.2f} M parameters, {:.2f} G multiply-adds, random weights, one "
        "network a category) run on this machine's CPU by OpenCV's dnn module",
        1e-6 * static_cast<double>(cost_.parameters), 1e-9 * static_cast<double>(cost_.multiply_adds));
  }

  double Run(const cv::Mat& picture, const std::string& category) override {
    networks_.at(category).Forward(picture);
    return 0;
  }

 private:
  std::map<std::string, HourglassNetwork> networks_;
  NetworkCost cost_;  // of any; they differ by a few parameters a keypoint
};

}  // namespace

std::unique_ptr<ForwardPass> MakeHourglassPass(const std::map<std::string, int>& keypoints) {
  return std::make_unique<HourglassPass>(keypoints);
}

}  // namespace armature
