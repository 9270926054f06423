// SPDX-License-Identifier: BSD-3-Clause
// Objects as they were seen, beside their nearest CAD models.
#pragma once

#include <cstddef>
#include <opencv2/core.hpp>
#include <optional>
#include <string>
#include <vector>

#include "eval/report/report_data.h"
#include "eval/report/sequence_runs.h"

namespace armature {

// Where an object was seen.
struct ObjectSight {
  size_t image = 0, detection = 0;  // of the sequence
  Box box;                          // undistorted pixels
};

// The run's trusted observation of the object with the largest box times matches, one that does not touch the
// image's border where there is such. None: it was never seen.
std::optional<ObjectSight> BestSight(const LoadedRun& run, const Sequence& sequence,
                                     const std::string& object);

// The part of the image around the box, with some margin.
cv::Rect CropAround(const Box& box, const cv::Size& image);

// A strip an object of the first run that retrieval.csv has models for. Where the library is not given or
// lacks a surface, models have no picture. `remarks`: what could not be shown.
std::vector<RetrievalStrip> MakeRetrievalStrips(const SequenceRuns& sequence, const InstanceLibrary& library,
                                                std::vector<std::string>& remarks);

}  // namespace armature
