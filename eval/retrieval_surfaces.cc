// SPDX-License-Identifier: BSD-3-Clause
#include "eval/retrieval_surfaces.h"

#include <filesystem>

#include "io/mesh_file.h"

namespace armature {
namespace {

constexpr std::uint64_t kSurfaceSeed = 1;

// Of "FILE" or "FILE#ID".
bool IsThere(const std::filesystem::path& root, const std::string& geometry) {
  return !geometry.empty() && std::filesystem::exists(root / geometry.substr(0, geometry.rfind('#')));
}

}  // namespace

std::optional<SurfacePoints> SurfaceOf(const InstanceLibrary& library, const CategoryInstances& instances,
                                       int instance, const Eigen::Vector3d& scale, int points) {
  const std::string& geometry = instances.geometries[static_cast<size_t>(instance)];
  if (!IsThere(library.root, geometry)) return std::nullopt;
  const Eigen::Affine3d T = Eigen::Scaling(scale) * instances.TransformOf(instance);
  return SurfacePoints(SampleSurface(Moved(T, ReadGeometry(library.root / geometry)), points, kSurfaceSeed));
}

const SurfacePoints* LibrarySurfaces::Of(const CategoryInstances& instances, int instance) {
  const auto [entry, is_new] = surfaces_.try_emplace({instances.category, instance});
  if (is_new) entry->second = SurfaceOf(library_, instances, instance, Eigen::Vector3d::Ones(), points_);
  return entry->second ? &*entry->second : nullptr;
}

std::optional<SurfaceDistance> DistancesFromTruth::To(int instance) {
  const auto [entry, is_new] = distances_.try_emplace(instance);
  if (is_new && truth_) {
    if (const SurfacePoints* surface = surfaces_.Of(instances_, instance))
      entry->second = CompareSurfaces(*surface, *truth_, kSurfaceThreshold);
  }
  return entry->second;
}

}  // namespace armature
