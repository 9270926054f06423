// SPDX-License-Identifier: BSD-3-Clause
#include "io/run_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "base/errors.h"
#include "base/interrupt.h"
#include "category/category_lookup.h"
#include "io/image.h"
#include "io/options_yaml.h"
#include "io/placed_objects.h"
#include "io/shape_evidence_csv.h"
#include "io/trajectory.h"
#include "lines/line_detector.h"
#include "pipeline/object_views.h"

namespace armature {
namespace {

namespace fs = std::filesystem;

constexpr double kSameStamp = 1e-3;  // seconds

const CategoryModel& LookUpModelFor(const std::vector<CategoryModel>& models, const std::string& category,
                                    const fs::path& file) {
  const CategoryModel* model = FindModel(models, category);
  if (model != nullptr) return *model;
  throw InputError(fmt::format("{}: category '{}' has no model; name the run's models with --categories",
                               file.string(), category));
}

std::vector<MapObject> ReadObjects(const fs::path& run, const std::vector<CategoryModel>& models) {
  const fs::path file = run / "objects.csv";
  const std::map<std::string, StoredEvidence> evidence = ReadShapeEvidence(run / "shape_evidence.csv");
  std::vector<MapObject> objects;
  for (const PlacedObject& placed : ReadPlacedObjects(file)) {
    const CategoryModel& model = LookUpModelFor(models, placed.category, file);
    const auto of_shape = evidence.find(placed.id);
    if (static_cast<int>(placed.shape.size()) != model.modes() || of_shape == evidence.end() ||
        of_shape->second.evidence.vector.size() != model.modes() ||
        of_shape->second.model_checksum != ModelChecksum(model)) {
      throw InputError(
          fmt::format("{}: the shape of '{}' is not one of {} coefficients with its evidence; name "
                      "the models that the run was made with (--categories), or run it again",
                      file.string(), placed.id, model.modes()));
    }
    objects.push_back({placed.id, &model, placed.T_world_object,
                       Eigen::Map<const Eigen::VectorXd>(placed.shape.data(), model.modes()), 0,
                       placed.observations, of_shape->second.evidence});
    if (placed.size.norm() > 0)
      objects.back().log_size = std::log(placed.size.norm() / objects.back().Size().norm());
  }
  return objects;
}

// -1: no object, or one that is not in the map.
int FindIndex(const std::string& id, const std::vector<MapObject>& objects) {
  const auto found =
      std::find_if(objects.begin(), objects.end(), [&](const MapObject& object) { return object.id == id; });
  return found == objects.end() ? -1 : static_cast<int>(found - objects.begin());
}

size_t ImageAt(double timestamp, const Sequence& sequence) {
  const auto image = std::find_if(
      sequence.images.begin(), sequence.images.end(),
      [&](const ImageEntry& entry) { return std::abs(entry.timestamp - timestamp) < kSameStamp; });
  if (image != sequence.images.end()) return static_cast<size_t>(image - sequence.images.begin());
  throw InputError(
      fmt::format("{}: has no image at {:.6f} s, where the run has a camera; name the run's sequence",
                  sequence.folder.string(), timestamp));
}

}  // namespace

Map ReadRunMap(const RunResults& run, const std::vector<CategoryModel>& models) {
  Map map;
  for (const CategoryModel& model : models)
    map.models.push_back(std::make_shared<const CategoryModel>(model));
  map.objects = ReadObjects(run.folder, models);
  for (MapObject& object : map.objects) object.model = &LookUpModel(map.models, object.model->spec.name);
  if (map.objects.empty()) return map;
  for (const TimedPose& camera : ReadTumTrajectory(run.folder / "trajectory.txt")) {
    map.timestamps.push_back(camera.timestamp);
    map.T_world_camera.push_back(camera.pose);
  }
  map.phi.resize(map.timestamps.size());
  for (const auto& [key, observation] : run.observations) {
    const auto camera =
        std::lower_bound(map.timestamps.begin(), map.timestamps.end(), observation.timestamp - kSameStamp);
    if (camera == map.timestamps.end() || *camera > observation.timestamp + kSameStamp) continue;
    std::vector<int>& phi = map.phi[static_cast<size_t>(camera - map.timestamps.begin())];
    phi.resize(std::max(phi.size(), static_cast<size_t>(observation.index) + 1), -1);
    phi[static_cast<size_t>(observation.index)] = FindIndex(observation.object, map.objects);
  }
  return map;
}

Options ReadRunOptions(const fs::path& run) {
  Options options;
  const std::vector<OptionEntry> table = OptionTable(options);
  ApplyYaml(run / "config.yaml", table);
  CheckOptions(table);
  return options;
}

ViewsOfCameras MakeViews(const Map& map, const std::vector<size_t>& cameras, const Sequence& sequence,
                         const std::vector<CategoryModel>& models, const Options& options) {
  const Eigen::Vector3d up_world = EstimateUp(map);
  const std::unique_ptr<LineDetector> detector = MakeLineDetector(options.lines);
  ViewsOfCameras views;
  for (const size_t camera : cameras) {
    if (views.contains(camera)) continue;
    ThrowIfInterrupted();
    const size_t image = ImageAt(map.timestamps[camera], sequence);
    const ImageResult colour = ReadImage(sequence.images[image].file, sequence.camera);
    if (!colour.image) throw InputError(colour.error);
    cv::Mat gray;
    cv::cvtColor(*colour.image, gray, cv::COLOR_BGR2GRAY);
    std::vector<Box> boxes;
    for (const Detection& detection : sequence.detections[image]) boxes.push_back(detection.box);
    const std::vector<Segment> segments =
        DetectSegments(*detector, gray, sequence.camera, boxes, options.lines);
    const Eigen::Vector3d up_camera = map.T_world_camera[camera].linear().transpose() * up_world;
    for (const Detection& detection : sequence.detections[image]) {
      views[camera].push_back(MakeView(detection, segments, up_camera, sequence.camera,
                                       LookUpModelFor(models, detection.category, sequence.folder), options));
    }
  }
  return views;
}

}  // namespace armature
