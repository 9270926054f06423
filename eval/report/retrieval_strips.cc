// SPDX-License-Identifier: BSD-3-Clause
#include "eval/report/retrieval_strips.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "base/errors.h"
#include "base/interrupt.h"
#include "drawing/model_picture.h"
#include "eval/report/encoded_picture.h"
#include "eval/report/retrieved_models.h"
#include "io/image.h"

namespace armature {
namespace {

constexpr double kClippedMargin = 2;  // pixels from the border: the box may go on behind it
constexpr double kCropMargin = 0.12;  // of the box, on each side
constexpr int kCropWidth = 260;       // pixels, at most
constexpr size_t kShownModels = 5;

bool IsClipped(const Box& box, const Camera& camera) {
  return box.left() < kClippedMargin || box.top() < kClippedMargin ||
         box.right() > camera.width - 1 - kClippedMargin || box.bottom() > camera.height - 1 - kClippedMargin;
}

// True objects by the ids of the map's that are matched to them.
std::map<std::string, const TrueObject*> TrueObjects(const SequenceRuns& sequence, const ShownMap& map) {
  std::map<std::string, const TrueObject*> of_map;
  if (!sequence.truth) return of_map;
  for (const EvaluatedObject& evaluated : map.evaluated) {
    for (const TrueObject& truth : sequence.truth->truth.objects) {
      if (evaluated.error && truth.id == evaluated.true_id) of_map[evaluated.map_id] = &truth;
    }
  }
  return of_map;
}

RetrievalStrip::Model DescribeModel(const RetrievedModel& retrieved, const std::string& true_model) {
  RetrievalStrip::Model model;
  model.name = retrieved.name;
  if (retrieved.cost) model.detail = fmt::format("cost {:.2f}, ", *retrieved.cost);
  model.detail += fmt::format("distance {:.2f}", retrieved.distance);
  model.is_true = retrieved.name == true_model;
  return model;
}

// Seen as the object of the map is from the camera.
void AddPictures(const PlacedObject& object, const TimedPose& camera, const InstanceLibrary& library,
                 RetrievalStrip& strip, std::vector<std::string>& remarks) {
  std::vector<TriangleMesh> meshes;
  std::vector<RetrievalStrip::Model*> models;
  for (RetrievalStrip::Model& model : strip.models) {
    try {
      auto surface = LoadModelSurface(library, object.category, model.name);
      if (!surface) continue;
      meshes.push_back(std::move(*surface));
      models.push_back(&model);
    } catch (const InputError& error) {
      remarks.push_back(fmt::format("{}: a model is not drawn: {}", strip.sequence, error.what()));
    }
  }
  if (meshes.empty()) return;
  const std::vector<cv::Mat> pictures = DrawModels(meshes, camera.pose.inverse() * object.T_world_object);
  for (size_t i = 0; i < models.size(); ++i) {
    models[i]->picture =
        JpegPicture(pictures[i], pictures[i].cols,
                    fmt::format("CAD model {} as {} is seen", models[i]->name, strip.object));
  }
}

ReportPicture QueryPicture(const ObjectSight& sight, const Sequence& images, const std::string& object,
                           std::vector<std::string>& remarks) {
  const ImageResult colour = ReadImage(images.images[sight.image].file, images.camera);
  if (!colour.image) {
    remarks.push_back(fmt::format("{}: {} is not shown: {}", images.name, object, colour.error));
    return {};
  }
  const cv::Mat image = Undistorted(*colour.image, images.camera);
  return JpegPicture(image(CropAround(sight.box, image.size())), kCropWidth,
                     fmt::format("{} at {:.2f} s", object, images.images[sight.image].timestamp));
}

void LookAtObject(const SequenceRuns& sequence, const PlacedObject& object, const InstanceLibrary& library,
                  RetrievalStrip& strip, std::vector<std::string>& remarks) {
  if (!sequence.images) return;
  const LoadedRun& run = sequence.runs.front();
  const auto sight = BestSight(run, *sequence.images, object.id);
  if (!sight) return;
  strip.query = QueryPicture(*sight, *sequence.images, object.id, remarks);
  if (const TimedPose* camera = CameraAt(*run.map, sequence.images->images[sight->image].timestamp))
    AddPictures(object, *camera, library, strip, remarks);
}

}  // namespace

std::optional<ObjectSight> BestSight(const LoadedRun& run, const Sequence& sequence,
                                     const std::string& object) {
  std::optional<ObjectSight> best;
  double best_score = 0;
  for (size_t image = 0; image < sequence.images.size(); ++image) {
    for (size_t d = 0; d < sequence.detections[image].size(); ++d) {
      const RunObservation* row = run.results.Find(sequence.images[image].timestamp, static_cast<int>(d));
      if (row == nullptr || !row->ok() || row->object != object) continue;
      const Box& seen = sequence.detections[image][d].box;
      // Any whole one is better than any clipped one; few matches tell that something stands in front.
      const double score = seen.width * seen.height * static_cast<double>(1 + row->matches.size()) *
                           (IsClipped(seen, sequence.camera) ? 1e-9 : 1);
      if (score <= best_score) continue;
      best_score = score;
      best = {image, d, UndistortBox(sequence.camera, seen)};
    }
  }
  return best;
}

cv::Rect CropAround(const Box& box, const cv::Size& image) {
  const double margin = kCropMargin * std::max(box.width, box.height);
  const cv::Point low(static_cast<int>(std::floor(box.left() - margin)),
                      static_cast<int>(std::floor(box.top() - margin)));
  const cv::Point high(static_cast<int>(std::ceil(box.right() + margin)),
                       static_cast<int>(std::ceil(box.bottom() + margin)));
  return cv::Rect(low, high) & cv::Rect({0, 0}, image);
}

std::vector<RetrievalStrip> MakeRetrievalStrips(const SequenceRuns& sequence, const InstanceLibrary& library,
                                                std::vector<std::string>& remarks) {
  std::vector<RetrievalStrip> strips;
  const LoadedRun& run = sequence.runs.front();
  if (!run.map) return strips;
  const auto retrieved = ReadRetrieval(run.results.folder);
  const auto true_objects = TrueObjects(sequence, *run.map);
  for (const PlacedObject& object : run.map->objects) {
    ThrowIfInterrupted();
    const auto models = retrieved.find(object.id);
    if (models == retrieved.end()) continue;
    RetrievalStrip& strip =
        strips.emplace_back(RetrievalStrip{sequence.name, run.name, object.id, {}, {}, {}});
    const auto truth = true_objects.find(object.id);
    if (truth != true_objects.end()) strip.true_model = truth->second->instance;
    for (size_t i = 0; i < std::min(models->second.size(), kShownModels); ++i)
      strip.models.push_back(DescribeModel(models->second[i], strip.true_model));
    LookAtObject(sequence, object, library, strip, remarks);
  }
  return strips;
}

}  // namespace armature
