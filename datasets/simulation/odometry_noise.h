// SPDX-License-Identifier: BSD-3-Clause
// How a monocular odometry corrupts the true motion.
#pragma once

#include <optional>

#include "base/enum_names.h"

namespace armature {

enum class OdometryKind {
  kMonocular,  // as the fields below say
  kNone        // no poses at all
};

template <>
struct EnumNames<OdometryKind> {
  static constexpr NamedValue<OdometryKind> kTable[] = {{OdometryKind::kMonocular, "monocular"},
                                                        {OdometryKind::kNone, "none"}};
};

struct OdometryNoise {
  OdometryKind kind = OdometryKind::kMonocular;
  double scale = 0.4;                // odometry's units a metre, at the start
  double scale_drift = 0.05;         // of the last motion's scale against the first's, share; grows evenly
  double heading_drift_deg = 3;      // about the vertical, at the end; grows evenly
  double translation_noise = 0.01;   // sigma each axis, share of each motion's length
  double rotation_noise_deg = 0.02;  // sigma each axis, each motion
  bool tells_up = true;              // whether the direction of gravity is known, as a flying robot knows it

  // While it is lost there are no poses: once, from a time [s] on, or for a share of all time. Never in the
  // first image.
  std::optional<double> lost_at{};
  double lost_share = 0;
  double lost_seconds = 1;  // of the one stretch; mean of many
  double scale_jump =
      0;  // of the scale after a lost stretch against that before, share; up or down by chance

  // Sigma of the log of the scale over each 90 degrees that the camera turns about itself: nothing is
  // triangulated there.
  double turn_scale_drift = 0;
};

}  // namespace armature
