// SPDX-License-Identifier: BSD-3-Clause
#include "eval/report/scene_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "base/errors.h"
#include "category/category_lookup.h"
#include "drawing/map_scene.h"
#include "eval/report/retrieved_models.h"

namespace armature {
namespace {

using Eigen::Vector3d;

constexpr Eigen::Index kMostTriangles = 20000;  // of one surface: the page has to stay small
constexpr double kCameraSpacing = 0.4;          // metres along the path
constexpr double kCameraDepth = 0.12;           // metres, of a pyramid
constexpr size_t kLeastCameras = 12;            // of a path with as many
constexpr size_t kMostPoints = 1000;            // of a path

std::vector<Vector3d> MakePath(const std::vector<TimedPose>& cameras) {
  const size_t step = std::max<size_t>(1, (cameras.size() + kMostPoints - 1) / kMostPoints);
  std::vector<Vector3d> path;
  for (size_t i = 0; i < cameras.size(); i += step) path.push_back(cameras[i].pose.translation());
  return path;
}

std::array<Vector3d, 5> Pyramid(const Eigen::Isometry3d& T_world_camera) {
  std::array<Vector3d, 5> points{T_world_camera.translation()};
  constexpr std::array<std::array<double, 2>, 4> kCorners{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
  for (size_t i = 0; i < 4; ++i)
    points[i + 1] =
        T_world_camera * (kCameraDepth * Vector3d(0.66 * kCorners[i][0], 0.5 * kCorners[i][1], 1));
  return points;
}

// Along the path; of a camera that only turns some all the same.
std::vector<Eigen::Isometry3d> ShownCameras(const std::vector<TimedPose>& cameras) {
  std::vector<Eigen::Isometry3d> poses, spread;
  for (const TimedPose& camera : cameras) poses.push_back(camera.pose);
  const std::vector<Eigen::Isometry3d> spaced = SpacedCameras(poses, kCameraSpacing);
  if (spaced.size() >= kLeastCameras) return spaced;
  const size_t step = std::max<size_t>(1, poses.size() / kLeastCameras);
  for (size_t i = 0; i < poses.size(); i += step) spread.push_back(poses[i]);
  return spread;
}

std::vector<std::array<Vector3d, 5>> MakePyramids(const std::vector<TimedPose>& cameras) {
  std::vector<std::array<Vector3d, 5>> pyramids;
  for (const Eigen::Isometry3d& pose : ShownCameras(cameras)) pyramids.push_back(Pyramid(pose));
  return pyramids;
}

std::vector<SceneView::Line> MakeWireframe(const PlacedObject& object, const CategoryModel& model) {
  const Eigen::Map<const Eigen::VectorXd> shape(object.shape.data(),
                                                static_cast<Eigen::Index>(object.shape.size()));
  const Wireframe wireframe = WireframeFromCoefficients(model, shape);
  std::vector<SceneView::Line> lines;
  for (int edge = 0; edge < wireframe.edges(); ++edge) {
    lines.emplace_back(object.T_world_object * wireframe.End(edge, 0),
                       object.T_world_object * wireframe.End(edge, 1));
  }
  return lines;
}

std::vector<SceneView::Line> MakeBox(const TrueObject& object) {
  const auto corner = [&](int number) {
    const Vector3d signs(number & 1 ? 0.5 : -0.5, number & 2 ? 0.5 : -0.5, number & 4 ? 0.5 : -0.5);
    return Vector3d(object.T_world_object * object.size.cwiseProduct(signs));
  };
  std::vector<SceneView::Line> lines;
  for (int from = 0; from < 8; ++from) {
    for (const int axis : {1, 2, 4}) {
      if ((from & axis) == 0) lines.emplace_back(corner(from), corner(from | axis));
    }
  }
  return lines;
}

const TrueObject* FindTrueObject(const SequenceRuns& sequence, const std::string& id) {
  for (const TrueObject& truth : sequence.truth->truth.objects) {
    if (truth.id == id) return &truth;
  }
  return nullptr;
}

// Moved as its object was.
Eigen::Isometry3d FitInShownWorld(const RetrievedModel& model, const PlacedObject& own,
                                  const PlacedObject& shown) {
  return shown.T_world_object * own.T_world_object.inverse() * *model.T_world_object;
}

// What a scene is made from.
struct SceneParts {
  const SequenceRuns& sequence;
  const InstanceLibrary& library;
  std::map<std::string, std::vector<RetrievedModel>> retrieved;
  std::vector<PlacedObject> own;  // the map in the run's own world
};

// In the shown world: at its fit, else at the object's pose. Without triangles: it has no surface, or too
// many.
TriangleMesh PlacedSurface(const SceneParts& parts, size_t object, const RetrievedModel& model,
                           std::vector<std::string>& remarks) {
  const PlacedObject& shown = parts.sequence.runs.front().map->objects[object];
  const auto surface = LoadModelSurface(parts.library, shown.category, model.name);
  if (!surface) return {};
  if (surface->size() > kMostTriangles) {
    remarks.push_back(fmt::format("{}: {} has {} triangles and is left out of the 3D view",
                                  parts.sequence.name, model.name, surface->size()));
    return {};
  }
  Eigen::Affine3d T_world_model = shown.T_world_object;
  if (model.T_world_object)
    T_world_model = FitInShownWorld(model, parts.own[object], shown) * Eigen::Scaling(model.scale);
  return Moved(T_world_model, *surface);
}

// The nearest of the retrieved models that can be placed, as `armature retrieve --place` does.
void PlaceNearest(const SceneParts& parts, size_t number, SceneView::Object& object,
                  std::vector<std::string>& remarks) {
  const auto found = parts.retrieved.find(object.id);
  if (found == parts.retrieved.end()) return;
  for (const RetrievedModel& model : found->second) {
    try {
      object.cad = PlacedSurface(parts, number, model, remarks);
    } catch (const InputError& error) {
      remarks.push_back(fmt::format("{}: a model is left out: {}", parts.sequence.name, error.what()));
    }
    if (object.cad.size() == 0) continue;
    object.model = model.name;
    return;
  }
}

void AddTrueBoxes(const SequenceRuns& sequence, SceneView& scene) {
  for (const EvaluatedObject& evaluated : sequence.runs.front().map->evaluated) {
    const TrueObject* truth = FindTrueObject(sequence, evaluated.true_id);
    if (truth == nullptr) continue;
    auto object = std::find_if(scene.objects.begin(), scene.objects.end(), [&](const SceneView::Object& o) {
      return !evaluated.map_id.empty() && o.id == evaluated.map_id;
    });
    if (object == scene.objects.end()) {
      object = scene.objects.insert(object, SceneView::Object{});
      object->id = truth->id + " (not found)";
      object->category = truth->category;
    }
    object->true_box = MakeBox(*truth);
  }
}

}  // namespace

std::optional<SceneView> MakeSceneView(const SequenceRuns& sequence, const std::vector<CategoryModel>& models,
                                       const InstanceLibrary& library, std::vector<std::string>& remarks) {
  const LoadedRun& run = sequence.runs.front();
  if (!run.map) return std::nullopt;
  const SceneParts parts{sequence, library, ReadRetrieval(run.results.folder),
                         ReadPlacedObjects(run.results.folder / "objects.csv")};
  SceneView scene;
  scene.sequence = sequence.name;
  scene.run = run.name;
  scene.up = sequence.up;
  scene.path = MakePath(run.map->T_world_camera);
  scene.cameras = MakePyramids(run.map->T_world_camera);
  for (size_t i = 0; i < run.map->objects.size(); ++i) {
    const PlacedObject& object = run.map->objects[i];
    const CategoryModel* model = FindModel(models, object.category);  // there is one: LoadSequenceRuns
    SceneView::Object& shown = scene.objects.emplace_back();
    shown.id = object.id;
    shown.category = object.category;
    shown.model = object.instance;
    shown.wireframe = MakeWireframe(object, *model);
    PlaceNearest(parts, i, shown, remarks);
  }
  if (sequence.truth) {
    scene.true_path = MakePath(sequence.truth->truth.T_world_camera);
    AddTrueBoxes(sequence, scene);
  }
  return scene;
}

}  // namespace armature
