// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/simulation/segments.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "datasets/simulation/visible_objects.h"
#include "geometry/random.h"
#include "geometry/rotation.h"

namespace armature {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kNearDepth = 0.1;  // metres before the camera
constexpr int kPixelStep = 2;       // between two pixels whose object is looked for
constexpr double kRayStep = 5;      // pixels between two points of a line that are looked at
constexpr double kInFront = 0.01;   // metres that they are moved towards the camera, off their own surface

// A line's part before the camera and inside of the image; depths along the optical axis.
struct ProjectedLine {
  Segment segment;
  double inverse_z1 = 0, inverse_z2 = 0;
};

std::optional<ProjectedLine> ProjectLine(const SurfaceLine& line, const Camera& camera,
                                         const Eigen::Isometry3d& T_camera_world) {
  Vector3d a = T_camera_world * line.p1, b = T_camera_world * line.p2;
  if (a.z() < kNearDepth && b.z() < kNearDepth) return std::nullopt;
  if (a.z() < kNearDepth) a += (kNearDepth - a.z()) / (b.z() - a.z()) * (b - a);
  if (b.z() < kNearDepth) b += (kNearDepth - b.z()) / (a.z() - b.z()) * (a - b);
  const Segment whole{camera.Project(a), camera.Project(b)};
  const Box image{-0.5, -0.5, static_cast<double>(camera.width), static_cast<double>(camera.height)};
  const std::optional<Segment> inside = Clipped(whole, image);
  if (!inside || whole.length() <= 0) return std::nullopt;
  // 1/z is linear along the projected line.
  const auto inverse_z = [&](const Vector2d& pixel) {
    const double t = (pixel - whole.p1).norm() / whole.length();
    return (1 - t) / a.z() + t / b.z();
  };
  return ProjectedLine{*inside, inverse_z(inside->p1), inverse_z(inside->p2)};
}

// Lines of smooth surfaces are seen where one face looks at the camera and the other one away; those of
// faces that both look away never are.
bool CanBeSeen(const SurfaceLine& line, const Vector3d& camera_world) {
  const Vector3d to_camera = camera_world - 0.5 * (line.p1 + line.p2);
  const bool first = line.normal1.dot(to_camera) > 0, second = line.normal2.dot(to_camera) > 0;
  return line.is_sharp ? first || second : first != second;
}

// The stretches of a line that nothing hides, shares 0..1 of it.
struct Stretch {
  double from = 0, to = 0;
};

std::vector<Stretch> VisibleStretches(const ProjectedLine& line, const RayScene& rays, const Camera& camera,
                                      const Eigen::Isometry3d& T_world_camera) {
  const Segment& segment = line.segment;
  const int count = std::max(2, static_cast<int>(std::lround(segment.length() / kRayStep)));
  std::vector<Vector3d> points;
  for (int i = 0; i < count; ++i) {
    const double t = (i + 0.5) / count;
    const double z = 1 / (line.inverse_z1 + t * (line.inverse_z2 - line.inverse_z1));
    const Vector3d point = z * camera.Ray(segment.p1 + t * (segment.p2 - segment.p1));
    points.emplace_back(T_world_camera * ((1 - kInFront / point.norm()) * point));
  }
  std::vector<char> blocked(points.size());
  rays.AreBlocked(T_world_camera.translation(), points, blocked);
  std::vector<Stretch> stretches;
  for (int i = 0; i < count; ++i) {
    if (blocked[static_cast<size_t>(i)] != 0) continue;
    const double from = static_cast<double>(i) / count, to = static_cast<double>(i + 1) / count;
    const bool goes_on = !stretches.empty() && stretches.back().to > from - 0.5 / count;
    if (goes_on)
      stretches.back().to = to;
    else
      stretches.push_back({from, to});
  }
  return stretches;
}

// Where the detector loses the line for some pixels.
std::vector<Segment> Broken(const Segment& segment, const SegmentNoise& noise, Random& random) {
  const auto exponential = [&](double mean) { return -mean * std::log(1 - random.Uniform(0, 1)); };
  const Vector2d along = (segment.p2 - segment.p1).normalized();
  std::vector<Segment> pieces;
  for (double from = 0; from < segment.length();) {
    const double to = std::min(segment.length(), from + exponential(noise.break_px));
    pieces.push_back({segment.p1 + from * along, segment.p1 + to * along});
    from = to + exponential(noise.gap_px);
  }
  return pieces;
}

Segment Shaken(const Segment& segment, const SegmentNoise& noise, Random& random) {
  const Vector2d along = (segment.p2 - segment.p1).normalized(), across(-along.y(), along.x());
  const auto shaken = [&](const Vector2d& end) -> Vector2d {
    return end + random.Normal(0, noise.end_px) * along + random.Normal(0, noise.across_px) * across;
  };
  const Vector2d p1 = shaken(segment.p1);
  return {p1, shaken(segment.p2)};
}

// Whether the detector sees it: the line's own contrast, and the picture's luck.
bool IsFound(double length, double contrast, const SegmentNoise& noise, Random& random) {
  const double luck =
      std::sqrt(noise.persistence) * contrast + std::sqrt(1 - noise.persistence) * random.Normal(0, 1);
  return luck < std::min(noise.steepness * std::log(length / noise.found_px), noise.most);
}

bool IsAlong(const Segment& segment, const Segment& longer, double distance) {
  const double length = longer.length();
  const double at = (longer.p2 - longer.p1).dot(segment.middle() - longer.p1) / length;
  if (at <= 0 || at >= length) return false;
  if (std::abs(SignedDistanceToLine(longer, segment.middle())) >= distance) return false;
  return AcuteAngle(segment, longer) <= 6 * kDegree;  // last: an arc tangent
}

// Where a ray can meet an object, a value a ray.
cv::Mat1b MayShowObjects(const RayScene& rays, const Camera& camera,
                         const Eigen::Isometry3d& T_camera_world) {
  const Box picture{0, 0, static_cast<double>(camera.width), static_cast<double>(camera.height)};
  cv::Mat1b worth((camera.height + kPixelStep - 1) / kPixelStep, (camera.width + kPixelStep - 1) / kPixelStep,
                  uchar{0});
  std::set<int> objects;
  for (const PlacedMesh& mesh : rays.meshes()) objects.insert(mesh.object);
  objects.erase(kRoom);
  for (const int object : objects) {
    const Box extent = ProjectedExtent(rays.meshes(), object, camera, T_camera_world, picture);
    const cv::Point first(static_cast<int>(extent.left()) / kPixelStep,
                          static_cast<int>(extent.top()) / kPixelStep);
    const cv::Point last(static_cast<int>(extent.right()) / kPixelStep + 2,
                         static_cast<int>(extent.bottom()) / kPixelStep + 2);
    if (extent.area() > 0) worth(cv::Rect(first, last) & cv::Rect({0, 0}, worth.size())) = 1;
  }
  return worth;
}

}  // namespace

std::vector<Segment> SimulateSegments(const std::vector<SurfaceLine>& lines, const RayScene& rays,
                                      const Camera& camera, const Eigen::Isometry3d& T_world_camera,
                                      const SegmentNoise& noise, std::uint64_t seed) {
  const Eigen::Isometry3d T_camera_world = T_world_camera.inverse();
  std::vector<Segment> candidates;
  for (size_t i = 0; i < lines.size(); ++i) {
    if (!CanBeSeen(lines[i], T_world_camera.translation())) continue;
    const auto projected = ProjectLine(lines[i], camera, T_camera_world);
    if (!projected || projected->segment.length() < noise.min_length_px) continue;
    Random random(StreamSeed(seed, i));  // whether a line is hidden changes nothing for the others
    const Vector2d p1 = projected->segment.p1, way = projected->segment.p2 - p1;
    for (const Stretch& stretch : VisibleStretches(*projected, rays, camera, T_world_camera)) {
      const Segment seen{p1 + stretch.from * way, p1 + stretch.to * way};
      if (!IsFound(seen.length(), lines[i].contrast, noise, random)) continue;
      for (const Segment& piece : Broken(seen, noise, random)) {
        if (piece.length() < noise.min_length_px) continue;
        const Segment shaken = Shaken(piece, noise, random);
        if (shaken.length() >= noise.min_length_px) candidates.push_back(shaken);
      }
    }
  }
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Segment& a, const Segment& b) { return a.length() > b.length(); });
  std::vector<Segment> segments;
  for (const Segment& candidate : candidates) {
    const bool is_lost = std::any_of(segments.begin(), segments.end(), [&](const Segment& longer) {
      return IsAlong(candidate, longer, noise.own_px);
    });
    if (!is_lost) segments.push_back(candidate);
  }
  return segments;
}

cv::Mat1i SeeObjects(const RayScene& rays, const Camera& camera, const Eigen::Isometry3d& T_world_camera) {
  const cv::Mat1b worth = MayShowObjects(rays, camera, T_world_camera.inverse());
  cv::Mat1i objects(camera.height, camera.width, kRoom);
  std::vector<int> columns;
  std::vector<Vector3d> directions;
  for (int y = 0; y < camera.height; y += kPixelStep) {
    columns.clear();
    directions.clear();
    for (int x = 0; x < camera.width; x += kPixelStep) {
      if (!worth(y / kPixelStep, x / kPixelStep)) continue;
      columns.push_back(x);
      directions.push_back((T_world_camera.linear() * camera.Ray(Vector2d(x, y))).normalized());
    }
    std::vector<RayHit> hits(directions.size());
    rays.Nearest(T_world_camera.translation(), directions, hits);
    for (int row = y; row < std::min(y + kPixelStep, objects.rows); ++row) {
      for (size_t i = 0; i < hits.size(); ++i) {
        const int end = std::min(columns[i] + kPixelStep, objects.cols);
        std::fill(&objects(row, columns[i]), &objects(row, 0) + end, hits[i].object);
      }
    }
  }
  return objects;
}

}  // namespace armature
