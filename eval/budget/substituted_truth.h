// SPDX-License-Identifier: BSD-3-Clause
// What of a sequence can be replaced by the truth, to see what its error costs.
#pragma once

#include <map>
#include <string>

#include "base/enum_names.h"

namespace armature {

enum class SubstitutedTruth {
  kScale,       // of the odometry
  kCameras,     // in place of the odometry
  kDetections,  // no false alarms, wrong categories, second boxes of an object
  kViewpoints,  // of the detections of true objects
  kLines,       // the visible edges, and no other lines
  kIdentities,  // as detections, and each object is a category of its own
  kShapes       // as identities, and each category has its object's size
};

template <>
struct EnumNames<SubstitutedTruth> {
  static constexpr NamedValue<SubstitutedTruth> kTable[] = {
      {SubstitutedTruth::kScale, "scale"},           {SubstitutedTruth::kCameras, "cameras"},
      {SubstitutedTruth::kDetections, "detections"}, {SubstitutedTruth::kViewpoints, "viewpoints"},
      {SubstitutedTruth::kLines, "lines"},           {SubstitutedTruth::kIdentities, "identities"},
      {SubstitutedTruth::kShapes, "shapes"}};
};

// Files of a sequence folder that take the place of its own: content by name in the folder.
using SubstitutedFiles = std::map<std::string, std::string>;

}  // namespace armature
