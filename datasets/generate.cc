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
#include "datasets/simulation/segments.h"
#include "datasets/simulation/surface_lines.h"
#include "datasets/simulation/true_edges.h"
#include "datasets/simulation/visible_objects.h"
#include "geometry/random.h"
#include "io/image.h"

namespace armature {
namespace {

namespace fs = std::filesystem;

// Streams of random numbers of a scene.
enum Stream : std::uint64_t { kPath = 1, kOdometry, kEffects, kDetections, kSurfaceLines, kSegments };

// A scene, ready to be photographed, or to be looked at line by line.
struct Studio {
  const Scene& scene;
  std::optional<Renderer> renderer;  // none: lines only
  std::optional<RayScene> own_rays;  // where there is no renderer
  std::vector<SurfaceLine> lines;    // where there is no renderer

  Studio(const Scene& photographed, bool lines_only) : scene(photographed) {
    std::vector<PlacedMesh> meshes = SceneMeshes(scene);
    if (lines_only) {
      lines = FindSurfaceLines(meshes, SegmentNoise{}.patterns_per_m2, StreamSeed(scene.seed, kSurfaceLines));
      own_rays.emplace(std::move(meshes));
    } else {
      renderer.emplace(std::move(meshes), scene.lamps, RenderOptions{.light_grid = scene.light_grid});
    }
  }

  const RayScene& rays() const { return renderer ? renderer->rays() : *own_rays; }
};

// The sequence with everything that is known before the first picture.
GeneratedSequence Planned(const Scene& scene, int frames) {
  GeneratedSequence sequence{scene.name, scene.about, scene.fps, scene.camera, std::nullopt, false, {}, {}};
  for (const SceneObject& object : scene.objects) {
    sequence.objects.push_back({object.id, object.instance.category,
                                object.instance.prefix + object.instance.id, object.T_world_object,
                                object.instance.size});
  }
  const auto T_world_camera = CameraPoses(scene.path, scene.frames, StreamSeed(scene.seed, kPath));
  const auto T_odom_camera =
      SimulateOdometry(T_world_camera, scene.fps, scene.odometry, StreamSeed(scene.seed, kOdometry));
  if (scene.odometry.tells_up && scene.odometry.kind != OdometryKind::kNone)  // it is in the odometry's frame
    sequence.up_odom = T_world_camera.front().linear().transpose() * Eigen::Vector3d::UnitZ();
  for (size_t i = 0; i < static_cast<size_t>(frames); ++i) {
    sequence.frames.push_back(
        {static_cast<double>(i) / scene.fps, T_world_camera[i], T_odom_camera[i], {}, {}, {}});
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

// Notes where edges are in the picture and what is seen of the objects; `pixels`: of which they are.
void NoteContent(const Studio& studio, const cv::Mat1i& pixels, GeneratedFrame* frame,
                 std::vector<VisibleObject>* visible) {
  const Scene& scene = studio.scene;
  *visible = VisibleObjects(studio.rays(), pixels, scene.camera, frame->T_world_camera);
  for (size_t i = 0; i < scene.objects.size(); ++i) {
    const SceneObject& object = scene.objects[i];
    frame->edges.push_back(FindTrueEdges(studio.rays(), static_cast<int>(i) + 1, object.instance.wireframe,
                                         object.T_world_object, scene.camera, frame->T_world_camera));
  }
}

cv::Mat3b Photograph(const Studio& studio, int index, GeneratedFrame* frame,
                     std::vector<VisibleObject>* visible) {
  const Scene& scene = studio.scene;
  const Picture picture = studio.renderer->Render(scene.camera, frame->T_world_camera);
  NoteContent(studio, picture.objects, frame, visible);
  return Develop(picture.radiance, scene.effects, StreamSeed(scene.seed, kEffects), index);
}

// The same without the picture.
void FindLines(const Studio& studio, int index, GeneratedFrame* frame, std::vector<VisibleObject>* visible) {
  const Scene& scene = studio.scene;
  NoteContent(studio, SeeObjects(studio.rays(), scene.camera, frame->T_world_camera), frame, visible);
  const std::uint64_t seed = StreamSeed(StreamSeed(scene.seed, kSegments), static_cast<std::uint64_t>(index));
  frame->segments =
      SimulateSegments(studio.lines, studio.rays(), scene.camera, frame->T_world_camera, {}, seed);
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

// All pictures, by all threads; the first exception ends the work. Returns what is seen in each of them.
std::vector<std::vector<VisibleObject>> PhotographAll(const Studio& studio, const fs::path& folder,
                                                      const GenerationProgress& progress,
                                                      GeneratedSequence* sequence) {
  std::exception_ptr failure;
  const int count = static_cast<int>(sequence->frames.size());
  std::vector<std::vector<VisibleObject>> visible(sequence->frames.size());
#pragma omp parallel for schedule(dynamic)
  for (int i = 0; i < count; ++i) {
    bool is_over = false;
#pragma omp critical(generate)
    is_over = failure != nullptr;
    if (is_over) continue;
    std::exception_ptr failed = Tried([&] {
      const auto place = static_cast<size_t>(i);
      GeneratedFrame* frame = &sequence->frames[place];
      if (studio.renderer)
        WritePictureInside(folder / ImageName(i), Photograph(studio, i, frame, &visible[place]));
      else
        FindLines(studio, i, frame, &visible[place]);
    });
#pragma omp critical(generate)
    {
      if (!failed) failed = Tried(progress.on_frame);
      if (!failure) failure = failed;
    }
  }
  if (failure) std::rethrow_exception(failure);
  return visible;
}

// In the order of the frames: what is detected depends on what was.
void DetectAll(const Scene& scene, double detection_noise, std::vector<std::vector<VisibleObject>> visible,
               GeneratedSequence* sequence) {
  DetectableScene detectable{scene.camera, {}, {}};
  for (const SceneObject& object : scene.objects) {
    detectable.objects.push_back(
        {object.id, object.instance.category, object.T_world_object, object.instance.size});
  }
  for (const ClutterPiece& piece : Distractors(scene)) detectable.distractors.push_back({piece.shape});
  std::vector<SeenFrame> seen;
  for (size_t i = 0; i < visible.size(); ++i) {
    const GeneratedFrame& frame = sequence->frames[i];
    seen.push_back({frame.timestamp, frame.T_world_camera, std::move(visible[i])});
  }
  auto detections = SimulateDetections(seen, detectable, scene.detections.Times(detection_noise),
                                       StreamSeed(scene.seed, kDetections));
  for (size_t i = 0; i < detections.size(); ++i) sequence->frames[i].detections = std::move(detections[i]);
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
  if (options.lines_only) made_from += " lines only";
  made_from += OthersModels(scene);
  if (options.draw != 1) made_from += fmt::format(" draw {}", options.draw);
  const std::string stamp = GenerationStamp(made_from);
  const fs::path folder = out / scene.name;
  if (HasStamp(folder, stamp)) return {folder, false};

  OutputFolder output(folder, GeneratedFolders());
  progress.on_start(scene.name, frames);
  GeneratedSequence sequence = Planned(scene, frames);
  sequence.lines_only = options.lines_only;
  auto visible = PhotographAll(Studio(scene, options.lines_only), output.partial(), progress, &sequence);
  DetectAll(scene, options.detection_noise, std::move(visible), &sequence);
  WriteSequenceTables(output.partial(), sequence);
  fs::copy_file(scene_file, output.partial() / "scene.yaml");
  WriteStamp(output.partial(), stamp);
  output.Publish();
  return {folder, true};
}

}  // namespace armature
