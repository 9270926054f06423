// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/generate.h"

#include <fmt/format.h>

#include <algorithm>
#include <exception>

#include "base/text.h"
#include "datasets/cad/collection_files.h"
#include "datasets/generation_stamp.h"
#include "datasets/render/camera_effects.h"
#include "datasets/render/renderer.h"
#include "datasets/scene/camera_path.h"
#include "datasets/scene/room_mesh.h"
#include "datasets/scene/scene_yaml.h"
#include "datasets/sequence_tables.h"
#include "datasets/simulation/detections.h"
#include "datasets/simulation/odometry.h"
#include "datasets/simulation/true_edges.h"
#include "datasets/simulation/visible_objects.h"
#include "geometry/random.h"
#include "io/image.h"

namespace armature {
namespace {

namespace fs = std::filesystem;

// Streams of random numbers of a scene.
enum Stream : std::uint64_t { kPath = 1, kOdometry, kEffects, kDetections };

// A scene, ready to be photographed.
struct Studio {
  const Scene& scene;
  Renderer renderer;
  std::vector<DetectableObject> objects;
  DetectionNoise noise;

  Studio(const Scene& photographed, double detection_noise)
      : scene(photographed),
        renderer(SceneMeshes(scene), scene.lamps, {.light_grid = scene.light_grid}),
        noise(scene.detections.Times(detection_noise)) {
    for (const SceneObject& object : scene.objects)
      objects.push_back({object.id, object.instance.category, object.T_world_object});
  }
};

// The sequence with everything that is known before the first picture.
GeneratedSequence Planned(const Scene& scene, int frames) {
  GeneratedSequence sequence{scene.name, scene.about, scene.fps, scene.camera, std::nullopt, {}, {}};
  for (const SceneObject& object : scene.objects) {
    sequence.objects.push_back({object.id, object.instance.category,
                                object.instance.prefix + object.instance.id, object.T_world_object,
                                object.instance.size});
  }
  const auto T_world_camera = CameraPoses(scene.path, scene.frames, StreamSeed(scene.seed, kPath));
  const auto T_odom_camera =
      SimulateOdometry(T_world_camera, scene.odometry, StreamSeed(scene.seed, kOdometry));
  if (scene.odometry.tells_up)
    sequence.up_odom = T_world_camera.front().linear().transpose() * Eigen::Vector3d::UnitZ();
  for (size_t i = 0; i < static_cast<size_t>(frames); ++i) {
    sequence.frames.push_back(
        {static_cast<double>(i) / scene.fps, T_world_camera[i], T_odom_camera[i], {}, {}});
  }
  return sequence;
}

// What the pictures show beside the scene's text: models of collections on disk.
std::string OthersModels(const Scene& scene) {
  std::string models;
  for (const SceneObject& object : scene.objects) {
    if (object.instance.collection != CadInstance().collection)
      models += fmt::format(" {} {}", object.instance.id, CadPlyText(object.instance.mesh));
  }
  return models;
}

// Takes the picture and notes what is in it.
cv::Mat3b Photograph(const Studio& studio, int index, GeneratedFrame* frame) {
  const Scene& scene = studio.scene;
  const RayScene& rays = studio.renderer.rays();
  const Picture picture = studio.renderer.Render(scene.camera, frame->T_world_camera);
  auto visible = VisibleObjects(rays, picture.objects, scene.camera, frame->T_world_camera);
  std::erase_if(visible, [&](const VisibleObject& seen) {  // distractors
    return seen.object > static_cast<int>(studio.objects.size());
  });
  const std::uint64_t seed =
      StreamSeed(StreamSeed(scene.seed, kDetections), static_cast<std::uint64_t>(index));
  frame->detections =
      SimulateDetections(visible, studio.objects, scene.camera, frame->T_world_camera, studio.noise, seed);
  for (size_t i = 0; i < scene.objects.size(); ++i) {
    const SceneObject& object = scene.objects[i];
    frame->edges.push_back(FindTrueEdges(rays, static_cast<int>(i) + 1, object.instance.wireframe,
                                         object.T_world_object, scene.camera, frame->T_world_camera));
  }
  return Develop(picture.radiance, scene.effects, StreamSeed(scene.seed, kEffects), index);
}

// The exception that the work ended with, none if it went well. No exception may leave a parallel region.
template <typename Work>
std::exception_ptr Tried(const Work& work) {
  try {
    work();
    return nullptr;
  } catch (...) {
    return std::current_exception();
  }
}

// All pictures, by all threads; the first exception ends the work.
void PhotographAll(const Studio& studio, const fs::path& folder, const GenerationProgress& progress,
                   GeneratedSequence* sequence) {
  std::exception_ptr failure;
  const int count = static_cast<int>(sequence->frames.size());
#pragma omp parallel for schedule(dynamic)
  for (int i = 0; i < count; ++i) {
    bool is_over = false;
#pragma omp critical(generate)
    is_over = failure != nullptr;
    if (is_over) continue;
    std::exception_ptr failed = Tried([&] {
      const cv::Mat3b image = Photograph(studio, i, &sequence->frames[static_cast<size_t>(i)]);
      WritePictureInside(folder / ImageName(i), image);
    });
#pragma omp critical(generate)
    {
      if (!failed) failed = Tried(progress.on_frame);
      if (!failure) failure = failed;
    }
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace

Generated GenerateCad(const fs::path& folder, const CollectionOptions& options,
                      const std::vector<CadInstance>& collection) {
  const std::string stamp = GenerationStamp(
      fmt::format("cad {} {} {} {}", options.chairs, options.tables, options.laptops, options.seed));
  if (HasStamp(folder, stamp)) return {folder, false};
  OutputFolder output(folder, GeneratedFolders());
  WriteCollection(collection, output.partial());
  WriteStamp(output.partial(), stamp);
  output.Publish();
  return {folder, true};
}

Generated GenerateSequence(const fs::path& scene_file, const std::vector<CadInstance>& collection,
                           const fs::path& out, const SequenceOptions& options,
                           const GenerationProgress& progress) {
  const Scene scene = ReadScene(scene_file, collection, options.draw);
  const int frames = options.frames > 0 ? std::min(options.frames, scene.frames) : scene.frames;
  std::string made_from =
      fmt::format("sequence {} {} {}", frames, options.detection_noise, ReadTextFile(scene_file));
  made_from += OthersModels(scene);
  if (options.draw != 1) made_from += fmt::format(" draw {}", options.draw);
  const std::string stamp = GenerationStamp(made_from);
  const fs::path folder = out / scene.name;
  if (HasStamp(folder, stamp)) return {folder, false};

  OutputFolder output(folder, GeneratedFolders());
  progress.on_start(scene.name, frames);
  GeneratedSequence sequence = Planned(scene, frames);
  const Studio studio(scene, options.detection_noise);
  PhotographAll(studio, output.partial(), progress, &sequence);
  WriteSequenceTables(output.partial(), sequence);
  fs::copy_file(scene_file, output.partial() / "scene.yaml");
  WriteStamp(output.partial(), stamp);
  output.Publish();
  return {folder, true};
}

}  // namespace armature
