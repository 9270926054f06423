// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/frame_pipeline.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "base/stage_clock.h"
#include "geometry/rotation.h"
#include "pipeline/object_estimator.h"
#include "pipeline/object_views.h"

namespace armature {
namespace {

std::vector<Box> CollectBoxes(const std::vector<Detection>& detections) {
  std::vector<Box> boxes;
  for (const Detection& detection : detections) boxes.push_back(detection.box);
  return boxes;
}

void ForgetViewpoints(std::vector<Detection>& detections) {
  for (Detection& detection : detections) {
    detection.azimuth.reset();
    detection.elevation.reset();
    detection.tilt.reset();
  }
}

}  // namespace

FramePipeline::FramePipeline(Options options, Camera camera, std::vector<CategoryModel> categories,
                             std::optional<Eigen::Vector3d> up_odom, bool odometry_is_metric)
    : options_(std::move(options)),
      camera_(camera),
      categories_(std::move(categories)),
      up_odom_(up_odom),
      detector_(MakeLineDetector(options_.lines)),
      floor_(options_.floor),
      tracks_(options_.tracks),
      map_(options_.mapping, options_.association.box, options_.resection, odometry_is_metric) {}

FrameResult FramePipeline::Process(const cv::Mat& gray, const FrameInput& input) {
  return Process(DetectLines(gray, input.detections), input);
}

// One pass over the image for all objects.
DetectedLines FramePipeline::DetectLines(const cv::Mat& gray, const std::vector<Detection>& detections) {
  DetectedLines lines;
  const StageClock clock(lines.milliseconds);
  lines.segments = DetectSegments(*detector_, gray, camera_, CollectBoxes(detections), options_.lines);
  return lines;
}

FrameResult FramePipeline::Process(DetectedLines lines, const FrameInput& given) {
  FrameInput input = given;
  if (!options_.association.hypotheses.use_viewpoint) ForgetViewpoints(input.detections);
  FrameResult result;
  result.timestamp = input.timestamp;
  result.segments = std::move(lines.segments);
  result.times.lines = lines.milliseconds;
  std::vector<ObjectView> views;
  std::vector<int> tracks;
  {  // what is known before an object is looked at
    const StageClock clock(result.times.mapping);
    const UpEstimate up = EstimateUp(input, result.segments);
    result.up_camera = up.up_camera;
    result.up_sigma = up.sigma;
    result.floor = floor_.Predict(input.timestamp, ClimbSinceLastFrame(input, up));
    views = MakeViews(input, result);
    tracks = Recall(input, views);
  }
  const std::vector<SingleViewResult> estimations = EstimateObjects(input, views, result.times);
  for (size_t i = 0; i < views.size(); ++i) {
    result.observations.push_back({input.detections[i], estimations[i].initial.T_camera_object,
                                   estimations[i].initial.coefficients, estimations[i].estimate});
  }
  const StageClock clock(result.times.mapping);
  LearnUp(result, estimations);
  LearnObjects(input, views, estimations, tracks);
  const StageClock map_clock(map_milliseconds_);
  AddToMap(input, result, views, estimations, tracks);
  return result;
}

std::vector<ObjectView> FramePipeline::MakeViews(const FrameInput& input, const FrameResult& frame) const {
  std::vector<ObjectView> views;
  for (const Detection& detection : input.detections) {
    views.push_back(
        MakeView(detection, frame.segments, frame.up_camera, camera_, LookUpModel(detection), options_));
    views.back().floor = frame.floor;
  }
  MarkHiddenSides(views);
  return views;
}

std::vector<int> FramePipeline::Recall(const FrameInput& input, std::vector<ObjectView>& views) const {
  if (!input.T_odom_camera) return std::vector<int>(views.size(), -1);
  std::vector<int> tracks = tracks_.Associate(input.timestamp, views, *input.T_odom_camera);
  if (!options_.tracks.enabled) return tracks;  // the map wants to know them nevertheless
  for (size_t i = 0; i < views.size(); ++i) {
    views[i].memory = tracks_.Recall(tracks[i], *input.T_odom_camera, *views[i].up_camera);
  }
  return tracks;
}

std::vector<SingleViewResult> FramePipeline::EstimateObjects(const FrameInput& input,
                                                             std::vector<ObjectView>& views,
                                                             StageTimes& times) const {
  std::vector<SingleViewResult> estimations(views.size());
  std::vector<ImageFace> occluders;
  for (const size_t i : LargestFirst(input.detections)) {
    EstimatorTimes spent;
    views[i].occluders = occluders;
    estimations[i] = EstimateObject(views[i], options_.association, options_.resection, spent);
    times.association += spent.association_ms;
    times.optimization += spent.optimization_ms;
    const ObjectEstimate& estimate = estimations[i].estimate;
    if (!options_.association.occlusion || estimate.status != EstimateStatus::kOk) continue;
    const CategoryModel& model = *views[i].model;
    const Wireframe wireframe = WireframeFromCoefficients(model, estimate.coefficients);
    for (ImageFace& face : ProjectFaces(camera_, model.spec, wireframe, estimate.T_camera_object)) {
      occluders.push_back(std::move(face));
    }
  }
  return estimations;
}

void FramePipeline::LearnObjects(const FrameInput& input, const std::vector<ObjectView>& views,
                                 const std::vector<SingleViewResult>& estimations, std::vector<int>& tracks) {
  for (size_t i = 0; i < views.size(); ++i) {
    const int track = std::exchange(tracks[i], -1);
    const ObjectEstimate& estimate = estimations[i].estimate;
    if (estimate.status != EstimateStatus::kOk) continue;
    if (MatchedEdges(estimate.matches) < kLeastLearntEdges) continue;
    floor_.Learn(estimations[i], *views[i].model, *views[i].up_camera);
    if (!input.T_odom_camera) continue;
    tracks[i] = tracks_.Learn(track, input.timestamp, views[i], estimations[i], *input.T_odom_camera);
  }
  if (input.T_odom_camera) tracks_.Update(input.timestamp);
}

void FramePipeline::AddToMap(const FrameInput& input, const FrameResult& result,
                             const std::vector<ObjectView>& views,
                             const std::vector<SingleViewResult>& estimations,
                             const std::vector<int>& tracks) {
  if (!input.T_odom_camera) return;
  MapFrame frame;
  frame.timestamp = input.timestamp;
  frame.T_odom_camera = *input.T_odom_camera;
  frame.up_camera = result.up_camera;
  frame.up_sigma = result.up_sigma;
  for (size_t i = 0; i < views.size(); ++i) {
    frame.observations.push_back(
        {views[i], tracks[i], estimations[i].measured.estimate, estimations[i].evidence});
    ObjectView& view = frame.observations.back().view;
    view.memory.reset();
    view.occluders.clear();
  }
  map_.Add(std::move(frame), tracks_.Scale());
}

std::optional<FramePipeline::FinalMaps> FramePipeline::SolveMaps() const {
  if (map_.frames().empty()) return std::nullopt;
  FinalMaps maps;
  maps.incremental_ms = map_milliseconds_;
  {
    const StageClock clock(maps.solve_ms);
    maps.map = map_.Solve(tracks_.Scale());
  }
  maps.by_odometry = PlaceByOdometry(map_.frames(), maps.map, options_.mapping);
  return maps;
}

void FramePipeline::MarkHiddenSides(std::vector<ObjectView>& views) const {
  for (size_t i = 0; i < views.size(); ++i) {
    std::vector<Box> others;
    for (size_t j = 0; j < views.size(); ++j) {
      if (j != i) others.push_back(views[j].detection.box);
    }
    views[i].hidden_probability = HiddenProbabilities(views[i].detection.box, others);
  }
}

std::optional<double> FramePipeline::ClimbSinceLastFrame(const FrameInput& input, const UpEstimate& up) {
  const std::optional<Eigen::Isometry3d> last = std::exchange(last_T_odom_camera_, input.T_odom_camera);
  const ScaleEstimate scale = tracks_.Scale();
  if (!options_.tracks.enabled || !last || !input.T_odom_camera || !scale.IsKnown()) return std::nullopt;
  const Eigen::Vector3d up_odom = input.T_odom_camera->linear() * up.up_camera;
  return scale.scale * up_odom.dot(input.T_odom_camera->translation() - last->translation());
}

UpEstimate FramePipeline::EstimateUp(const FrameInput& input, const std::vector<Segment>& segments) {
  if (options_.up.source == UpSource::kLevel) return {Eigen::Vector3d(0, -1, 0), kLevelSigmaDeg * kDegree};
  if (options_.up.source == UpSource::kAuto && up_odom_ && input.T_odom_camera) {
    return {(input.T_odom_camera->linear().transpose() * *up_odom_).normalized(), 0};
  }
  std::vector<UpVote> votes;
  for (const Detection& detection : input.detections) {
    const BoxSides sides = SidesAtImageBorder(detection.box, camera_);
    const bool whole = std::count(sides.begin(), sides.end(), BoxSide::kOpen) == 0;
    const double sigma_deg = whole ? options_.up.viewpoint_sigma_deg : kOpenBoxSigmaDeg;
    const auto vote =
        MakeUpVote(detection, camera_.Ray(UndistortBox(camera_, detection.box).center()), sigma_deg);
    if (vote) votes.push_back(*vote);
  }
  return up_estimator_.Update(camera_, segments, votes, input.T_odom_camera);
}

void FramePipeline::LearnUp(const FrameResult& result, const std::vector<SingleViewResult>& estimations) {
  std::vector<UpVote> votes;
  for (size_t i = 0; i < estimations.size(); ++i) {
    if (estimations[i].estimate.status != EstimateStatus::kOk) continue;
    const Eigen::Vector3d t = estimations[i].estimate.T_camera_object.translation();
    // How far the ray may be off: the centre's uncertainty across it, as this image alone leaves it.
    const Eigen::Matrix3d across = Eigen::Matrix3d::Identity() - t * t.transpose() / t.squaredNorm();
    const Eigen::Matrix3d covariance = estimations[i].measured.covariance.block<3, 3>(3, 3);
    const double off_deg = 2 * std::sqrt((across * covariance * across).trace()) / t.norm() / kDegree;
    const double sigma_deg = std::hypot(options_.up.viewpoint_sigma_deg, off_deg);
    if (const auto vote = MakeUpVote(result.observations[i].detection, t, sigma_deg)) votes.push_back(*vote);
  }
  up_estimator_.ReviseVotes(votes);
}

const CategoryModel& FramePipeline::LookUpModel(const Detection& detection) const {
  const auto found = std::find_if(categories_.begin(), categories_.end(), [&](const CategoryModel& model) {
    return model.spec.name == detection.category;
  });
  if (found == categories_.end()) std::abort();  // checked where detections are read
  return *found;
}

// Large furniture hides small furniture more often than the other way round.
std::vector<size_t> FramePipeline::LargestFirst(const std::vector<Detection>& detections) const {
  std::vector<size_t> order(detections.size());
  std::iota(order.begin(), order.end(), 0);
  const auto volume = [&](size_t i) {
    return BoundingBoxSize(WireframeFromVector(LookUpModel(detections[i]).mean)).prod();
  };
  std::stable_sort(order.begin(), order.end(), [&](size_t a, size_t b) { return volume(a) > volume(b); });
  return order;
}

}  // namespace armature
