// SPDX-License-Identifier: BSD-3-Clause
#include "eval/retrieval/retrieval_surfaces.h"

#include <filesystem>

#include "io/mesh_file.h"

namespace armature {
namespace {

constexpr std::uint64_t kSurfaceSeed = 1;

}  // namespace

bool HasSurface(const InstanceLibrary& library, const CategoryInstances& instances, int instance) {
  const std::string& geometry = instances.geometries[static_cast<size_t>(instance)];
  return !geometry.empty() && HasGeometry(library.root / geometry);
}

std::optional<SurfacePoints> FindSurface(const InstanceLibrary& library, const CategoryInstances& instances,
                                         int instance, const Eigen::Vector3d& scale, int points) {
  if (!HasSurface(library, instances, instance)) return std::nullopt;
  const std::filesystem::path geometry = library.root / instances.geometries[static_cast<size_t>(instance)];
  const Eigen::Affine3d T = Eigen::Scaling(scale) * instances.MakeTransform(instance);
  return SurfacePoints(SampleSurface(Moved(T, ReadGeometry(geometry)), points, kSurfaceSeed));
}

const SurfacePoints* LibrarySurfaces::Of(const CategoryInstances& instances, int instance) {
  const auto [entry, is_new] = surfaces_.try_emplace({instances.category, instance});
  if (is_new) entry->second = FindSurface(library_, instances, instance, Eigen::Vector3d::Ones(), points_);
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
