// SPDX-License-Identifier: BSD-3-Clause
// Detectors to stand in for.
#pragma once

#include "base/enum_names.h"
#include "datasets/simulation/detection_noise.h"

namespace armature {

enum class DetectorSetting {
  kSimulated,  // errors that are independent from frame to frame: the defaults of DetectionNoise
  kNetwork     // fitted to a real network; datasets/README.md says how
};

template <>
struct EnumNames<DetectorSetting> {
  static constexpr NamedValue<DetectorSetting> kTable[] = {{DetectorSetting::kSimulated, "simulated"},
                                                           {DetectorSetting::kNetwork, "network"}};
};

DetectorNoise MakeDetectorNoise(DetectorSetting setting);

}  // namespace armature
