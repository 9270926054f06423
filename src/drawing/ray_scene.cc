// SPDX-License-Identifier: BSD-3-Clause
#include "drawing/ray_scene.h"

#include <embree3/rtcore.h>
#include <fmt/core.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <map>

namespace armature {
namespace {

using Eigen::Vector3d;

constexpr double kClearance = 1e-3;  // metres around the ends of a segment that may be blocked
constexpr int kPacket = 8;           // rays that are followed at once

// How many rays a packet takes of those that are left.
int LanesLeft(size_t rays) { return static_cast<int>(std::min<size_t>(kPacket, rays)); }

// Embree fails only if it is used wrongly or memory runs out.
void AbortOnError(void*, RTCError code, const char* text) {
  if (code == RTC_ERROR_NONE) return;
  fmt::print(stderr, "embree: error {}: {}\n", static_cast<int>(code), text == nullptr ? "" : text);
  std::abort();
}

RTCDevice OpenDevice() {
  RTCDevice device = rtcNewDevice("threads=1");  // the tree, and so the hits, never depend on timing
  if (device == nullptr) AbortOnError(nullptr, rtcGetDeviceError(nullptr), "no device");
  rtcSetDeviceErrorFunction(device, AbortOnError, nullptr);
  return device;
}

RTCScene NewScene(RTCDevice device) {
  RTCScene scene = rtcNewScene(device);
  rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);  // no ray slips through between two quads
  return scene;
}

RTCGeometry QuadGeometry(RTCDevice device, const Part& part, const Eigen::Isometry3d& T_world_mesh) {
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_QUAD);
  const size_t count = part.quads.size();
  auto* vertex = static_cast<float*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), 4 * count));
  auto* index = static_cast<unsigned*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT4, 4 * sizeof(unsigned), count));
  for (const Quad& quad : part.quads) {
    for (const Vector3d& corner : quad.corners) {
      const Eigen::Vector3f world = (T_world_mesh * corner).cast<float>();
      vertex = std::copy(world.begin(), world.end(), vertex);
    }
  }
  for (unsigned i = 0; i < 4 * count; ++i) index[i] = i;
  rtcCommitGeometry(geometry);
  return geometry;
}

// The same ray in each lane of a packet.
void SetRay(int lane, const Vector3d& origin, const Vector3d& direction, double near, double far,
            RTCRay8* ray) {
  ray->org_x[lane] = static_cast<float>(origin.x());
  ray->org_y[lane] = static_cast<float>(origin.y());
  ray->org_z[lane] = static_cast<float>(origin.z());
  ray->dir_x[lane] = static_cast<float>(direction.x());
  ray->dir_y[lane] = static_cast<float>(direction.y());
  ray->dir_z[lane] = static_cast<float>(direction.z());
  ray->tnear[lane] = static_cast<float>(near);
  ray->tfar[lane] = static_cast<float>(far);
  ray->time[lane] = 0;
  ray->mask[lane] = ~0u;
  ray->id[lane] = 0;
  ray->flags[lane] = 0;
}

RTCRay SingleRay(const Vector3d& origin, const Vector3d& direction, double near, double far) {
  RTCRay ray{};
  ray.org_x = static_cast<float>(origin.x());
  ray.org_y = static_cast<float>(origin.y());
  ray.org_z = static_cast<float>(origin.z());
  ray.dir_x = static_cast<float>(direction.x());
  ray.dir_y = static_cast<float>(direction.y());
  ray.dir_z = static_cast<float>(direction.z());
  ray.tnear = static_cast<float>(near);
  ray.tfar = static_cast<float>(far);
  ray.mask = ~0u;
  return ray;
}

}  // namespace

struct RayScene::Implementation {
  struct PartOfMesh {
    int mesh = 0, part = 0;
  };

  std::vector<PlacedMesh> meshes;
  RTCDevice device = OpenDevice();
  RTCScene everything = NewScene(device);
  std::map<int, RTCScene> objects;  // one scene an object
  std::vector<PartOfMesh> parts;    // by Embree's number of a geometry, the same in all scenes

  explicit Implementation(std::vector<PlacedMesh> placed) : meshes(std::move(placed)) {
    for (size_t m = 0; m < meshes.size(); ++m) Add(static_cast<int>(m));
    rtcCommitScene(everything);
    for (auto& [object, scene] : objects) rtcCommitScene(scene);
  }

  ~Implementation() {
    for (auto& [object, scene] : objects) rtcReleaseScene(scene);
    rtcReleaseScene(everything);
    rtcReleaseDevice(device);
  }

  void Add(int m) {
    const PlacedMesh& placed = meshes[static_cast<size_t>(m)];
    RTCScene& scene = objects.try_emplace(placed.object, nullptr).first->second;
    if (scene == nullptr) scene = NewScene(device);
    for (size_t p = 0; p < placed.mesh.parts.size(); ++p) {
      const Part& part = placed.mesh.parts[p];
      if (part.quads.empty()) continue;
      RTCGeometry geometry = QuadGeometry(device, part, placed.T_world_mesh);
      const auto id = static_cast<unsigned>(parts.size());
      rtcAttachGeometryByID(everything, geometry, id);
      rtcAttachGeometryByID(scene, geometry, id);
      rtcReleaseGeometry(geometry);
      parts.push_back({m, static_cast<int>(p)});
    }
  }

  RayHit Hit(unsigned geometry, unsigned primitive, float distance, float u, float v) const {
    if (geometry == RTC_INVALID_GEOMETRY_ID) return {};
    const auto [mesh, part] = parts[geometry];
    return {mesh, part, static_cast<int>(primitive), meshes[static_cast<size_t>(mesh)].object, distance,
            u,    v};
  }

  RayHit NearestIn(RTCScene scene, const Vector3d& origin, const Vector3d& direction) const {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRayHit query{};
    query.ray = SingleRay(origin, direction, 0, std::numeric_limits<double>::infinity());
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(scene, &context, &query);
    return Hit(query.hit.geomID, query.hit.primID, query.ray.tfar, query.hit.u, query.hit.v);
  }
};

RayScene::RayScene(std::vector<PlacedMesh> meshes)
    : implementation_(std::make_unique<Implementation>(std::move(meshes))) {}
RayScene::~RayScene() = default;
RayScene::RayScene(RayScene&&) noexcept = default;
RayScene& RayScene::operator=(RayScene&&) noexcept = default;

const std::vector<PlacedMesh>& RayScene::meshes() const { return implementation_->meshes; }

RayHit RayScene::Nearest(const Vector3d& origin, const Vector3d& direction) const {
  return implementation_->NearestIn(implementation_->everything, origin, direction);
}

void RayScene::Nearest(const Vector3d& origin, std::span<const Vector3d> directions,
                       std::span<RayHit> hits) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  const size_t count = directions.size();
  for (size_t first = 0; first < count; first += kPacket) {
    alignas(32) RTCRayHit8 query;
    alignas(32) int valid[kPacket] = {};
    for (int lane = 0; lane < LanesLeft(count - first); ++lane) {
      valid[lane] = -1;
      SetRay(lane, origin, directions[first + static_cast<size_t>(lane)], 0,
             std::numeric_limits<double>::infinity(), &query.ray);
      query.hit.geomID[lane] = RTC_INVALID_GEOMETRY_ID;
      query.hit.instID[0][lane] = RTC_INVALID_GEOMETRY_ID;
    }
    rtcIntersect8(valid, implementation_->everything, &context, &query);
    for (int lane = 0; lane < LanesLeft(count - first); ++lane) {
      hits[first + static_cast<size_t>(lane)] =
          implementation_->Hit(query.hit.geomID[lane], query.hit.primID[lane], query.ray.tfar[lane],
                               query.hit.u[lane], query.hit.v[lane]);
    }
  }
}

RayHit RayScene::HitNearestOfObject(int object, const Vector3d& origin, const Vector3d& direction) const {
  const auto scene = implementation_->objects.find(object);
  if (scene == implementation_->objects.end()) return {};
  return implementation_->NearestIn(scene->second, origin, direction);
}

bool RayScene::IsBlocked(const Vector3d& a, const Vector3d& b) const {
  char blocked = 0;
  AreBlocked(a, {&b, 1}, {&blocked, 1});
  return blocked != 0;
}

void RayScene::AreBlocked(const Vector3d& a, std::span<const Vector3d> b, std::span<char> blocked) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  const size_t count = b.size();
  for (size_t first = 0; first < count; first += kPacket) {
    alignas(32) RTCRay8 ray;
    alignas(32) int valid[kPacket] = {};
    for (int lane = 0; lane < LanesLeft(count - first); ++lane) {
      const Vector3d ab = b[first + static_cast<size_t>(lane)] - a;
      const double length = ab.norm();
      valid[lane] = length > 2 * kClearance ? -1 : 0;
      SetRay(lane, a, ab / length, kClearance, length - kClearance, &ray);
    }
    rtcOccluded8(valid, implementation_->everything, &context, &ray);
    for (int lane = 0; lane < LanesLeft(count - first); ++lane) {
      blocked[first + static_cast<size_t>(lane)] = valid[lane] != 0 && ray.tfar[lane] < 0;
    }
  }
}

}  // namespace armature
