// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/simulation/detection_noise.h"

#include <algorithm>

namespace armature {

DetectionNoise DetectionNoise::Times(double factor) const {
  DetectionNoise times = *this;
  for (double* value : {&times.box, &times.false_alarms, &times.lasting_alarms, &times.azimuth_deg,
                        &times.elevation_deg, &times.tilt_deg, &times.elevation_bias_deg})
    *value *= factor;
  for (double* share : {&times.missed, &times.turned, &times.part, &times.spanning, &times.duplicates,
                        &times.mistaken, &times.distractors, &times.no_viewpoint, &times.astray})
    *share = std::min(1.0, *share * factor);
  return times;
}

DetectorNoise DetectorNoise::Times(double factor) const {
  DetectorNoise times{any.Times(factor), {}};
  for (const auto& [category, noise] : of) times.of[category] = noise.Times(factor);
  return times;
}

}  // namespace armature
