// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/sample.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "datasets/random.h"
#include "datasets/rasterizer.h"
#include "datasets/room.h"
#include "datasets/sequence_folder.h"
#include "datasets/simulated_detections.h"
#include "datasets/simulated_odometry.h"
#include "geometry/rotation.h"

namespace armature {
namespace {

using Eigen::Vector3d;

constexpr double kFps = 10;
constexpr int kPathFrames = 24;
const Camera kCamera{640, 480, 525, 525, 319.5, 239.5};

std::vector<PlacedFurniture> SampleFurniture() {
  const Colour beech(0.72, 0.55, 0.36), dark(0.3, 0.2, 0.14), white(0.88, 0.88, 0.86), blue(0.25, 0.35, 0.5);
  const Furniture table =
      SolidTable({.width = 1.35, .depth = 0.8, .height = 0.74}, beech, dark, "sample:table");
  const Furniture plain = SolidChair({}, dark, dark * 1.3, "sample:chair");
  const Furniture wide =
      SolidChair({.width = 0.46, .height = 0.92, .slats = 4}, white, blue, "sample:wide-chair");
  const Furniture laptop = SolidLaptop({}, "sample:laptop");
  return {Placed("table", table, 0.1, 0.55, 6), Placed("chair-left", plain, -1.25, -0.05, 42),
          Placed("chair-right", wide, 1.3, -0.1, -55), Placed("chair-rear", wide, -1.5, 1.45, 20),
          Placed("laptop", laptop, 0.25, 0.5, -12, 0.74)};
}

// On an arc around the table at 1.4 m height, held by hand: pitched down, and not quite level.
Eigen::Isometry3d CameraPose(int frame) {
  const double along = static_cast<double>(frame) / (kPathFrames - 1);
  const double angle = (-112 + 44 * along) * kDegree;
  const Vector3d position(2.95 * std::cos(angle), 0.35 + 2.95 * std::sin(angle),
                          1.4 + 0.02 * std::sin(9 * along));
  const Vector3d target(0.05, 0.35, 0.55);
  const Vector3d forward = (target - position).normalized();
  const Vector3d right = forward.cross(Vector3d::UnitZ()).normalized();
  Eigen::Matrix3d R_world_level;
  R_world_level << right, forward.cross(right), forward;
  const double roll = (1.5 + std::sin(5 * along)) * kDegree;
  Eigen::Isometry3d T_world_camera = Eigen::Isometry3d::Identity();
  T_world_camera.translation() = position;
  T_world_camera.linear() = R_world_level * Eigen::AngleAxisd(roll, Vector3d::UnitZ()).toRotationMatrix();
  return T_world_camera;
}

// A sensor's noise: triangular, of about two grey levels, alike in the three colours.
void AddNoise(Random& random, cv::Mat3b* image) {
  for (cv::Vec3b& pixel : *image) {
    const double noise = random.Uniform(-2.5, 2.5) + random.Uniform(-2.5, 2.5);
    for (int c = 0; c < 3; ++c) pixel[c] = cv::saturate_cast<unsigned char>(pixel[c] + noise);
  }
}

std::vector<GeneratedObject> TrueObjects(const std::vector<PlacedFurniture>& furniture) {
  std::vector<GeneratedObject> objects;
  objects.reserve(furniture.size());
  for (const PlacedFurniture& piece : furniture) {
    objects.push_back({piece.id, piece.furniture.category, piece.furniture.instance, piece.T_world_object,
                       piece.furniture.size});
  }
  return objects;
}

}  // namespace

void WriteSample(const std::filesystem::path& folder, const SampleOptions& options) {
  SequenceFolder sequence(folder);
  const RoomShape shape;
  const std::vector<PlacedFurniture> furniture = SampleFurniture();
  const RoomLight light(shape, furniture);
  std::vector<Polygon> polygons = RoomPolygons(shape, 5);
  for (const Polygon& polygon : FurniturePolygons(furniture)) polygons.push_back(polygon);

  const Camera fine = TwiceAsFine(kCamera);
  Random image_noise(options.seed);
  DetectionSimulator detector(options.seed + 1);
  OdometrySimulator odometry(options.seed + 2, 0.37);
  for (int i = 0; i < std::min(options.frames, kPathFrames); ++i) {
    GeneratedFrame frame;
    frame.timestamp = i / kFps;
    frame.T_world_camera = CameraPose(i);
    frame.T_odom_camera = odometry.Next(frame.T_world_camera);
    const VisibleSurfaces surfaces = Rasterize(polygons, fine, frame.T_world_camera);
    cv::Mat3b image = Shade(surfaces, polygons, fine, frame.T_world_camera, light);
    AddNoise(image_noise, &image);
    frame.image = image;
    frame.detections = detector.Detect(surfaces, polygons, furniture, kCamera, frame.T_world_camera);
    sequence.AddFrame(frame);
  }
  sequence.Finish("sample", kFps, kCamera, TrueObjects(furniture),
                  "Armature's built-in sample: drawn by `armature generate --sample`, not photographed");
}

}  // namespace armature
