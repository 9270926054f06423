// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <chrono>
#include <thread>

#include "bench/keypoints/forward_pass.h"
#include "geometry/random.h"

namespace armature {
namespace {

constexpr double kJitter = 0.05;

class WaitingPass : public ForwardPass {
 public:
  std::string Description() const override {
    return fmt::format("a wait of the paper's {} ms an object on a Titan X, {:g} % more or less",
                       kPublishedPassMs, 100 * kJitter);
  }

  double Run(const cv::Mat&, const std::string&) override {
    using Clock = std::chrono::steady_clock;
    const auto start = Clock::now();
    const std::chrono::duration<double, std::milli> wait(kPublishedPassMs *
                                                         random_.Uniform(1 - kJitter, 1 + kJitter));
    std::this_thread::sleep_until(start + std::chrono::duration_cast<Clock::duration>(wait));
    return 0;
  }

 private:
  Random random_{1};
};

class PublishedPass : public ForwardPass {
 public:
  std::string Description() const override {
    return fmt::format("the paper's {} ms an object on a Titan X, added and not waited for",
                       kPublishedPassMs);
  }
  double Run(const cv::Mat&, const std::string&) override { return kPublishedPassMs; }
};

}  // namespace

std::unique_ptr<ForwardPass> MakePublishedPass() { return std::make_unique<PublishedPass>(); }

std::unique_ptr<ForwardPass> MakeWaitingPass() { return std::make_unique<WaitingPass>(); }

}  // namespace armature
