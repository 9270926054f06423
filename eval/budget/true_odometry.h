// SPDX-License-Identifier: BSD-3-Clause
// Odometry with the truth in it.
#pragma once

#include <filesystem>

#include "eval/budget/substituted_truth.h"

namespace armature {

// odometry.txt in metres, by the scale of sim3, and the sequence.yaml that says so. Nothing, and a note,
// where the camera hardly moves: there is no scale to be given. Throws InputError: a malformed or missing
// file, no pose at a time of the truth.
SubstitutedFiles ScaleOdometry(const std::filesystem::path& sequence);

// The true cameras as odometry.txt, metric, and the sequence.yaml that says so. Its frame is that of the
// odometry at the first camera that both have (`up` stays true); without odometry the first camera is the
// origin. Throws as above.
SubstitutedFiles ReplaceOdometry(const std::filesystem::path& sequence);

}  // namespace armature
