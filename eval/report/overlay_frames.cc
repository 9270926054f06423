// SPDX-License-Identifier: BSD-3-Clause
#include "eval/report/overlay_frames.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/interrupt.h"
#include "category/category_lookup.h"
#include "drawing/overlay.h"
#include "eval/report/encoded_picture.h"
#include "io/image.h"
#include "io/run_summary.h"

namespace armature {
namespace {

constexpr size_t kOverlays = 6;  // a sequence
constexpr int kOverlayWidth = 860;

EstimateStatus StatusFromName(const std::string& name) {
  for (const EstimateStatus status : kAllStatuses) {
    if (StatusName(status) == name) return status;
  }
  return EstimateStatus::kDiverged;  // of another program: no estimate to be drawn
}

std::vector<EdgeMatch> ReadMatches(const RunObservation& row, const CategorySpec& spec) {
  std::vector<EdgeMatch> matches;
  for (const RunMatch& match : row.matches) {
    const auto edge = std::find(spec.edge_names.begin(), spec.edge_names.end(), match.edge);
    if (edge == spec.edge_names.end()) continue;
    matches.push_back({static_cast<int>(edge - spec.edge_names.begin()), match.segment, 0});
  }
  return matches;
}

ObjectEstimate ReadEstimate(const RunObservation& row, const CategoryModel& model) {
  ObjectEstimate estimate;
  const bool is_whole = row.T_camera_object && static_cast<int>(row.shape.size()) <= model.modes();
  estimate.status = is_whole ? StatusFromName(row.status) : EstimateStatus::kTooFewEdges;
  if (!is_whole) return estimate;
  estimate.T_camera_object = *row.T_camera_object;
  estimate.coefficients =
      Eigen::Map<const Eigen::VectorXd>(row.shape.data(), static_cast<Eigen::Index>(row.shape.size()));
  estimate.matches = ReadMatches(row, model.spec);
  return estimate;
}

// How many objects the run found in each image.
std::vector<size_t> FoundInImages(const LoadedRun& run, const Sequence& sequence) {
  std::vector<size_t> counts;
  for (size_t image = 0; image < sequence.images.size(); ++image) {
    size_t found = 0;
    for (size_t d = 0; d < sequence.detections[image].size(); ++d) {
      const RunObservation* row = run.results.Find(sequence.images[image].timestamp, static_cast<int>(d));
      found += row != nullptr && row->ok() ? 1 : 0;
    }
    counts.push_back(found);
  }
  return counts;
}

std::string FormatCaption(const FrameResult& frame) {
  size_t found = 0, matches = 0;
  for (const ObjectObservation& observation : frame.observations) {
    found += observation.estimate.status == EstimateStatus::kOk ? 1 : 0;
    matches += observation.estimate.matches.size();
  }
  return fmt::format("{} of {} detections with an estimate, {} segments on their edges", found,
                     frame.observations.size(), matches);
}

}  // namespace

FrameResult RestoreFrame(const LoadedRun& run, const Sequence& sequence, size_t image,
                         const std::vector<CategoryModel>& models) {
  FrameResult frame;
  frame.timestamp = sequence.images[image].timestamp;
  for (size_t d = 0; d < sequence.detections[image].size(); ++d) {
    ObjectObservation& observation = frame.observations.emplace_back();
    observation.detection = sequence.detections[image][d];
    observation.detection.box = UndistortBox(sequence.camera, observation.detection.box);
    const RunObservation* row = run.results.Find(frame.timestamp, static_cast<int>(d));
    const CategoryModel* model = FindModel(models, observation.detection.category);
    if (row != nullptr && model != nullptr) observation.estimate = ReadEstimate(*row, *model);
  }
  return frame;
}

std::vector<size_t> PickRichestParts(const std::vector<size_t>& counts, size_t parts) {
  std::vector<size_t> places;
  for (size_t part = 0; part < parts; ++part) {
    const size_t first = part * counts.size() / parts, end = (part + 1) * counts.size() / parts;
    const auto from_middle = [&](size_t place) {
      return std::abs(static_cast<double>(2 * place + 1) - static_cast<double>(first + end));
    };
    std::optional<size_t> best;
    for (size_t place = first; place < end; ++place) {
      const bool is_better = !best || counts[place] > counts[*best] ||
                             (counts[place] == counts[*best] && from_middle(place) < from_middle(*best));
      if (counts[place] > 0 && is_better) best = place;
    }
    if (best) places.push_back(*best);
  }
  return places;
}

std::vector<OverlayFrame> MakeOverlayFrames(const SequenceRuns& sequence,
                                            const std::vector<CategoryModel>& models,
                                            std::vector<std::string>& remarks) {
  std::vector<OverlayFrame> frames;
  if (!sequence.images) return frames;
  const Sequence& images = *sequence.images;
  const LoadedRun& run = sequence.runs.front();
  for (const size_t image : PickRichestParts(FoundInImages(run, images), kOverlays)) {
    ThrowIfInterrupted();
    const ImageResult colour = ReadImage(images.images[image].file, images.camera);
    if (!colour.image) {
      remarks.push_back(fmt::format("{}: a frame is not shown: {}", sequence.name, colour.error));
      continue;
    }
    const FrameResult frame = RestoreFrame(run, images, image, models);
    const cv::Mat drawn =
        DrawOverlay(Undistorted(*colour.image, images.camera), frame, models, images.camera);
    const std::string alt = fmt::format("{} at {:.2f} s with wireframes and matched lines of {} objects",
                                        sequence.name, frame.timestamp, frame.observations.size());
    frames.push_back({sequence.name, run.name, frame.timestamp, FormatCaption(frame),
                      JpegPicture(drawn, kOverlayWidth, alt)});
  }
  return frames;
}

}  // namespace armature
