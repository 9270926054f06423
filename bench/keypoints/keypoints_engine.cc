// SPDX-License-Identifier: BSD-3-Clause
#include "bench/keypoints/keypoints_engine.h"

#include <fmt/format.h>

#include <map>
#include <utility>

#include "base/stage_clock.h"
#include "bench/keypoints/forward_pass.h"
#include "bench/keypoints/heat_maps.h"
#include "bench/keypoints/keypoint_input.h"
#include "bench/keypoints/keypoint_resection.h"

namespace armature {
namespace {

constexpr double kLeastScore = 0.1;  // of a keypoint that counts as seen

std::unique_ptr<ForwardPass> MakePass(KeypointsMode mode, const KeypointCategories& categories) {
  if (mode == KeypointsMode::kPublished) return MakePublishedPass();
  if (mode == KeypointsMode::kWait) return MakeWaitingPass();
  std::map<std::string, int> keypoints;
  for (const auto& [name, category] : categories) {
    keypoints[name] = static_cast<int>(category.keypoints.size());
  }
  return MakeHourglassPass(keypoints);
}

std::vector<SeenKeypoint> SeenIn(const KeypointInput& object) {
  std::vector<SeenKeypoint> seen;
  const std::vector<Peak> peaks = ReadPeaks(object.maps, object.crop);
  for (size_t i = 0; i < peaks.size(); ++i) {
    if (peaks[i].score < kLeastScore) continue;
    seen.push_back({static_cast<int>(i), UndistortPixel(*object.view.camera, peaks[i].pixel)});
  }
  return seen;
}

class KeypointsEngine : public Engine {
 public:
  KeypointsEngine(KeypointsMode mode, const Options& options, std::vector<CategoryModel> models)
      : resection_(options.resection),
        categories_(MakeKeypointCategories(std::move(models))),
        pass_(MakePass(mode, categories_)) {}

  std::string Description() const override {
    return fmt::format(
        "Keypoints by a network, one forward pass an object. Detection: the crop and the forward pass, {}. "
        "Association: the heat maps' peaks. Optimization: pose and shape from them, by the solver and the "
        "terms that lines have. No mapping. The heat maps are drawn before any clock starts (the mean shape "
        "where box and viewpoint prior put it, turned by about 10 degrees, 1.5 px of noise), so that an "
        "accuracy would mean nothing and none is given.",
        pass_->Description());
  }

  bool IsStateless() const override { return true; }

  void Start(const BenchSequence& sequence) override { inputs_ = MakeKeypointInputs(sequence, categories_); }

  FrameOutcome Process(const BenchFrame& frame) override {
    FrameOutcome outcome;
    double& detection_ms = outcome.stage(BenchStage::kDetection).emplace(0);
    double& association_ms = outcome.stage(BenchStage::kAssociation).emplace(0);
    double& optimization_ms = outcome.stage(BenchStage::kOptimization).emplace(0);
    for (const KeypointInput& object : inputs_.at(&frame)) {
      ++outcome.objects;
      {
        const StageClock clock(detection_ms);
        const cv::Mat picture = CropPicture(frame.gray, object.crop, kPassInput);
        outcome.added_ms += pass_->Run(picture, object.view.detection.category);
      }
      std::vector<SeenKeypoint> seen;
      {
        const StageClock clock(association_ms);
        seen = SeenIn(object);
      }
      const StageClock clock(optimization_ms);
      ResectKeypoints(object.view, *object.keypoints, seen, PoseFromBox(object.view), resection_);
    }
    detection_ms += outcome.added_ms;
    return outcome;
  }

 private:
  ResectionOptions resection_;
  KeypointCategories categories_;
  std::unique_ptr<ForwardPass> pass_;
  KeypointInputs inputs_;
};

}  // namespace

std::unique_ptr<Engine> MakeKeypointsEngine(KeypointsMode mode, const Options& options,
                                            std::vector<CategoryModel> models) {
  return std::make_unique<KeypointsEngine>(mode, options, std::move(models));
}

}  // namespace armature
