// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/frame_pipeline.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "base/stage_clock.h"
#include "category/category_lookup.h"
#include "geometry/rotation.h"
#include "pipeline/object_estimator.h"
#include "pipeline/object_views.h"

namespace armature {
namespace {

// Intersection over union of two boxes that are one detection twice. Neighbouring chairs in a row stay below.
constexpr double kRepeatedOverlap = 0.85;

// Metres from frame to frame by which the camera may rise unknown, for the unit is not known, and still be
// said not to climb.
constexpr double kUnknownClimb = 0.005;

std::vector<std::shared_ptr<const CategoryModel>> Share(std::vector<CategoryModel> models) {
  std::vector<std::shared_ptr<const CategoryModel>> shared;
  for (CategoryModel& model : models)
    shared.push_back(std::make_shared<const CategoryModel>(std::move(model)));
  return shared;
}

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

// The same map with its origin elsewhere.
void MoveBy(const Eigen::Vector3d& shift, Map& map) {
  for (Eigen::Isometry3d& T_world_camera : map.T_world_camera) T_world_camera.pretranslate(shift);
  for (MapObject& object : map.objects) object.T_world_object.pretranslate(shift);
}

// For each detection whether it says what another has said: of the same category, in nearly the same place.
// The one with the highest score stays. Detectors do it, and merged lists of detections.
std::vector<bool> FindRepeated(const std::vector<Detection>& detections) {
  std::vector<size_t> order(detections.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](size_t a, size_t b) { return detections[a].score > detections[b].score; });
  std::vector<bool> repeated(detections.size(), false);
  for (size_t a = 0; a < order.size(); ++a) {
    for (size_t b = 0; b < a; ++b) {
      const Detection &first = detections[order[b]], &later = detections[order[a]];
      if (first.category == later.category && IntersectionOverUnion(first.box, later.box) > kRepeatedOverlap)
        repeated[order[a]] = true;
    }
  }
  return repeated;
}

void MarkHiddenSides(std::vector<ObjectInFrame>& objects) {
  for (ObjectInFrame& object : objects) {
    std::vector<Box> others;
    for (const ObjectInFrame& other : objects) {
      if (&other != &object && other.view.model) others.push_back(other.view.detection.box);
    }
    object.view.hidden_probability = HiddenProbabilities(object.view.detection.box, others);
  }
}

// Large furniture hides small furniture more often than the other way round.
std::vector<ObjectInFrame*> LargestFirst(std::vector<ObjectInFrame>& objects) {
  const auto volume = [](const ObjectInFrame* object) {
    return BoundingBoxSize(WireframeFromVector(object->view.model->mean)).prod();
  };
  std::vector<ObjectInFrame*> order;
  for (ObjectInFrame& object : objects) {
    if (object.view.model) order.push_back(&object);
  }
  std::stable_sort(order.begin(), order.end(),
                   [&](const ObjectInFrame* a, const ObjectInFrame* b) { return volume(a) > volume(b); });
  return order;
}

bool IsOk(const ObjectInFrame& object) { return object.result.estimate.status == EstimateStatus::kOk; }

void AppendFaces(const ObjectInFrame& object, std::vector<ImageFace>& occluders) {
  const auto& [view, track, result] = object;
  const Wireframe wireframe = WireframeFromCoefficients(*view.model, result.estimate.coefficients);
  for (ImageFace& face :
       ProjectFaces(*view.camera, view.model->spec, wireframe, result.estimate.T_camera_object))
    occluders.push_back(std::move(face));
}

std::vector<ObjectObservation> CollectObservations(const FrameInput& input,
                                                   const std::vector<ObjectInFrame>& objects) {
  std::vector<ObjectObservation> observations;
  for (size_t i = 0; i < objects.size(); ++i) {
    const SingleViewResult& result = objects[i].result;
    observations.push_back(
        {input.detections[i], result.initial.T_camera_object, result.initial.coefficients, result.estimate});
  }
  return observations;
}

}  // namespace

FramePipeline::FramePipeline(Options options, Camera camera, std::vector<CategoryModel> categories,
                             std::optional<Eigen::Vector3d> up_odom, bool odometry_is_metric,
                             std::optional<FloorPrior> camera_height)
    : options_(std::move(options)),
      camera_(camera),
      categories_(Share(std::move(categories))),
      up_odom_(up_odom),
      camera_height_(options_.floor.enabled ? camera_height : std::nullopt),
      detector_(MakeLineDetector(options_.lines)),
      floor_(options_.floor, camera_height_),
      tracks_(options_.tracks, odometry_is_metric),
      map_(options_.mapping, options_.association.box, options_.resection) {}

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
  const PreparedInput input = Prepare(given);
  FrameResult frame;
  frame.follows_jump = input.follows_jump;
  frame.unit_changed = input.unit_changed;
  frame.timestamp = input.timestamp;
  frame.segments = std::move(lines.segments);
  frame.times.lines = lines.milliseconds;

  // What is known before an object is looked at: up, the floor, and what its track remembers (3.3's priors).
  std::vector<ObjectInFrame> objects = Predict(input, frame);

  // Each object by itself, but for those in front of it: edges and segments are associated (3.3, Algorithm 1,
  // eqs. 6-15), pose and shape follow from the matches (3.4, eqs. 16-25), in turns.
  std::vector<ImageFace> occluders;
  for (ObjectInFrame* object : LargestFirst(objects)) {
    object->view.occluders = occluders;
    object->result = EstimateObject(object->view, options_.association, options_.resection);
    frame.times.association += object->result.times.association_ms;
    frame.times.optimization += object->result.times.optimization_ms;
    if (options_.association.occlusion && IsOk(*object)) AppendFaces(*object, occluders);
  }
  frame.observations = CollectObservations(input, objects);

  // What the objects say of up, the floor and their tracks; and the factor graph (3.5, eqs. 27-29).
  const StageClock clock(frame.times.mapping);
  Update(input, objects);
  AddToMap(input, frame, std::move(objects));
  return frame;
}

// Positions from the first one on: what follows does not depend on where the odometry's origin is.
FramePipeline::PreparedInput FramePipeline::Prepare(const FrameInput& given) {
  PreparedInput input{given};
  if (!options_.association.hypotheses.use_viewpoint) ForgetViewpoints(input.detections);
  if (!input.T_odom_camera) return input;
  if (!origin_odom_) origin_odom_ = input.T_odom_camera->translation();
  input.T_odom_camera->pretranslate(-*origin_odom_);
  const std::vector<ObjectView> views = ViewBoxes(input.detections);
  const OdometryJumps::Step step =
      jumps_.Follow(input.timestamp, *input.T_odom_camera, tracks_.Scale().IsKnown(),
                    [&](const Eigen::Isometry3d& T_odom_camera) {
                      return tracks_.Agreement(input.timestamp, views, T_odom_camera);
                    });
  input.T_odom_camera = step.T_odom_camera;
  input.follows_jump = step.is_jump;
  input.unit_changed = step.unit_change.has_value();
  if (step.unit_change) map_.Undo(*step.unit_change);
  tracks_.Follow(input.timestamp, step.T_odom_camera);
  return input;
}

// Of the detections only what tracks know of: category and box.
std::vector<ObjectView> FramePipeline::ViewBoxes(const std::vector<Detection>& detections) const {
  std::vector<ObjectView> views;
  for (const Detection& detection : detections) {
    ObjectView& view = views.emplace_back();
    view.camera = &camera_;
    view.model = &LookUpModel(categories_, detection.category);
    view.detection = detection;
  }
  return views;
}

std::vector<ObjectInFrame> FramePipeline::Predict(const FrameInput& input, FrameResult& frame) {
  const StageClock clock(frame.times.mapping);
  const UpEstimate up = PredictUp(input, frame.segments);
  frame.up_camera = up.up_camera;
  frame.up_sigma = up.sigma;
  frame.floor = floor_.Predict(input.timestamp, ClimbSinceLastFrame(input, up));

  std::vector<ObjectInFrame> objects;
  std::vector<ObjectView> views;
  const std::vector<bool> repeated = FindRepeated(input.detections);
  for (size_t i = 0; i < input.detections.size(); ++i) {
    const Detection& detection = input.detections[i];
    const CategoryModel& model = LookUpModel(categories_, detection.category);
    views.push_back(MakeView(detection, frame.segments, frame.up_camera, camera_, model, options_));
    views.back().floor = frame.floor;
    if (repeated[i]) views.back().model = nullptr;
  }
  std::vector<int> tracks(views.size(), kNoTrack);
  if (input.T_odom_camera) tracks = tracks_.Associate(input.timestamp, views, *input.T_odom_camera);
  for (size_t i = 0; i < views.size(); ++i) {
    ObjectInFrame& object = objects.emplace_back();
    object.view = std::move(views[i]);
    if (repeated[i]) object.result.estimate.status = EstimateStatus::kRepeated;
    object.track = tracks[i];  // the map wants to know it also where the prior is not used
    if (options_.tracks.enabled && input.T_odom_camera)
      object.view.track_prior = tracks_.Predict(object.track, *input.T_odom_camera, frame.up_camera);
  }
  MarkHiddenSides(objects);
  return objects;
}

void FramePipeline::Update(const FrameInput& input, std::vector<ObjectInFrame>& objects) {
  UpdateUp(objects);
  for (auto& [view, track, result] : objects) {
    const int predicted = std::exchange(track, kNoTrack);
    if (result.estimate.status != EstimateStatus::kOk) continue;
    if (MatchedEdges(result.estimate.matches) < kLeastLearntEdges) continue;
    floor_.Update(result, *view.model, *view.up_camera);
    if (!input.T_odom_camera) continue;
    track = tracks_.Update(predicted, input.timestamp, view, result, *input.T_odom_camera);
  }
  if (input.T_odom_camera) tracks_.Solve(input.timestamp);
}

void FramePipeline::AddToMap(const FrameInput& input, const FrameResult& frame,
                             std::vector<ObjectInFrame> objects) {
  if (!input.T_odom_camera) return;
  const StageClock clock(map_milliseconds_);
  MapFrame added;
  added.timestamp = input.timestamp;
  added.T_odom_camera = *input.T_odom_camera;
  added.follows_jump = frame.follows_jump;
  added.up_camera = frame.up_camera;
  added.up_sigma = frame.up_sigma;
  added.camera_height = camera_height_;
  for (auto& [view, track, result] : objects) {
    view.track_prior.reset();
    view.occluders.clear();
    added.observations.push_back(
        {std::move(view), track, false, std::move(result.measured.estimate), std::move(result.evidence)});
  }
  map_.Add(std::move(added), tracks_.Scale());
}

std::optional<FramePipeline::FinalMaps> FramePipeline::SolveMaps() const {
  if (map_.frames().empty()) return std::nullopt;
  FinalMaps maps;
  maps.incremental_ms = map_milliseconds_;
  {
    const StageClock clock(maps.solve_ms);
    maps.map = map_.Solve(tracks_.Scale());
  }
  maps.by_odometry = map_.WithAllFrames(PlaceByOdometry(map_.frames(), maps.map, options_.mapping));
  maps.map = map_.WithAllFrames(maps.map);
  for (Map* map : {&maps.map, &maps.by_odometry}) MoveBy(map->MeanScale() * *origin_odom_, *map);
  maps.map.models = maps.by_odometry.models = categories_;
  return maps;
}

std::optional<double> FramePipeline::ClimbSinceLastFrame(const FrameInput& input, const UpEstimate& up) {
  const std::optional<Eigen::Isometry3d> last = std::exchange(last_T_odom_camera_, input.T_odom_camera);
  const ScaleEstimate scale = tracks_.Scale();
  if (!options_.tracks.enabled || !last || !input.T_odom_camera) return std::nullopt;
  const Eigen::Vector3d up_odom = input.T_odom_camera->linear() * up.up_camera;
  const double climb = scale.scale * up_odom.dot(input.T_odom_camera->translation() - last->translation());
  // A camera that only turns does not climb, whatever the unit is.
  if (!scale.IsKnown() && scale.sigma * std::abs(climb) > kUnknownClimb) return std::nullopt;
  return climb;
}

UpEstimate FramePipeline::PredictUp(const FrameInput& input, const std::vector<Segment>& segments) {
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
  return up_estimator_.Predict(camera_, segments, votes, input.T_odom_camera);
}

void FramePipeline::UpdateUp(const std::vector<ObjectInFrame>& objects) {
  std::vector<UpVote> votes;
  for (const ObjectInFrame& object : objects) {
    if (!IsOk(object)) continue;
    const Eigen::Vector3d t = object.result.estimate.T_camera_object.translation();
    // How far the ray may be off: the centre's uncertainty across it, as this image alone leaves it.
    const Eigen::Matrix3d across = Eigen::Matrix3d::Identity() - t * t.transpose() / t.squaredNorm();
    const Eigen::Matrix3d covariance = object.result.measured.covariance.block<3, 3>(3, 3);
    const double off_deg = 2 * std::sqrt((across * covariance * across).trace()) / t.norm() / kDegree;
    const double sigma_deg = std::hypot(options_.up.viewpoint_sigma_deg, off_deg);
    if (const auto vote = MakeUpVote(object.view.detection, t, sigma_deg)) votes.push_back(*vote);
  }
  up_estimator_.Update(votes);
}

}  // namespace armature
