// SPDX-License-Identifier: BSD-3-Clause
#include "app/retrieve/place_models.h"

#include <fmt/format.h>

#include "base/errors.h"
#include "drawing/map_picture.h"
#include "io/atomic_write.h"
#include "io/image.h"
#include "io/mesh_file.h"
#include "io/ply_text.h"
#include "retrieval/sightings.h"

namespace armature {
namespace {

// In the object frame of the map's object.
TriangleMesh FindSurface(const RetrievedInstance& nearest, const CategoryInstances& library,
                         const MapObject& object, const std::filesystem::path& root) {
  const std::string& geometry = library.geometries[static_cast<size_t>(nearest.instance)];
  if (geometry.empty()) throw InputError("the library has no surface of it");
  Eigen::Affine3d T_object_geometry = library.MakeTransform(nearest.instance);
  if (nearest.fit) {
    T_object_geometry = object.T_world_object.inverse() * nearest.fit->T_world_object *
                        Eigen::Scaling(nearest.fit->scale) * T_object_geometry;
  }
  return Moved(T_object_geometry, ReadGeometry(root / geometry));
}

// The nearest whose surface can be read; a line for each that comes before it.
TriangleMesh NearestSurface(const ObjectInstances& found, const MapObject& object,
                            const std::filesystem::path& root, std::vector<std::string>& missing) {
  for (const RetrievedInstance& instance : found.instances) {
    try {
      return FindSurface(instance, *found.library, object, root);
    } catch (const InputError& error) {
      missing.push_back(fmt::format("{}: {} cannot be placed, the next nearest is: {}", object.id,
                                    found.library->ids[static_cast<size_t>(instance.instance)],
                                    error.what()));
    }
  }
  missing.push_back(
      fmt::format("{}: no retrieved model can be placed, only its wireframe is shown", object.id));
  return {};
}

}  // namespace

PlacedScene PlaceModels(const RunRetrieval& retrieval, const std::filesystem::path& root) {
  PlacedScene placed;
  placed.scene.T_world_camera = retrieval.map.T_world_camera;
  placed.scene.up_world = EstimateUp(retrieval.map);
  for (const ObjectInstances& found : retrieval.objects) {
    const MapObject& object = retrieval.map.objects[found.object];
    MapSceneObject& scene = placed.scene.objects.emplace_back();
    scene.id = object.id;
    scene.category = object.model->spec.name;
    scene.T_world_object = object.T_world_object;
    scene.wireframe = object.MakeWireframe();
    scene.cad = NearestSurface(found, object, root, placed.missing);
  }
  return placed;
}

void WriteScene(const MapScene& scene, const std::filesystem::path& folder) {
  const cv::Mat picture = DrawMap(scene);  // takes seconds, and may be interrupted
  // The comment is that of PCL, which wrote these files once: the same map is still the same bytes.
  AtomicWrite(folder / "map.ply", PlyText(SceneMesh(scene), PlyColours::kOfVertices, "PCL generated"));
  WritePicture(folder / "map.png", picture);
}

}  // namespace armature
