// SPDX-License-Identifier: BSD-3-Clause
#include "resection/object_estimate.h"

namespace armature {

std::string_view StatusName(EstimateStatus status) {
  switch (status) {
    case EstimateStatus::kOk:
      return "ok";
    case EstimateStatus::kTooFewEdges:
      return "too_few_edges";
    case EstimateStatus::kBehindCamera:
      return "behind_camera";
    case EstimateStatus::kDiverged:
      return "diverged";
    case EstimateStatus::kOffTheBox:
      return "off_the_box";
    case EstimateStatus::kRepeated:
      return "repeated";
  }
  return "unknown";
}

}  // namespace armature
