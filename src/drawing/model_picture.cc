// SPDX-License-Identifier: BSD-3-Clause
#include "drawing/model_picture.h"

#include <algorithm>
#include <cmath>

#include "drawing/map_models.h"
#include "drawing/map_shading.h"
#include "drawing/sampling.h"
#include "geometry/camera.h"

namespace armature {
namespace {

using Eigen::Vector3d;

constexpr double kFilled = 0.94;   // of the picture, by the largest model
constexpr double kClosest = 1.5;   // times a model's radius that its middle is away, at least
constexpr double kFloorBelow = 5;  // metres: of no floor anything is seen

// The camera turned so that its axis goes through the object's origin.
Eigen::Isometry3d Centred(const Eigen::Isometry3d& T_camera_object, double least_distance) {
  const Vector3d ray = T_camera_object.translation();
  const Eigen::Quaterniond to_axis = Eigen::Quaterniond::FromTwoVectors(ray, Vector3d::UnitZ());
  Eigen::Isometry3d centred = Eigen::Isometry3d::Identity();
  centred.linear() = to_axis.toRotationMatrix() * T_camera_object.linear();
  centred.translation().z() = std::max(ray.norm(), least_distance);
  return centred;
}

double ComputeRadius(const std::vector<TriangleMesh>& meshes) {
  double radius = 0;
  for (const TriangleMesh& mesh : meshes)
    radius = std::max(radius, mesh.vertices.colwise().norm().maxCoeff());
  return radius;
}

// With the longest focal length under which all vertices are in the picture.
Camera FittingCamera(const std::vector<TriangleMesh>& meshes, const Eigen::Isometry3d& T_camera_object,
                     const ModelPictureOptions& options) {
  Eigen::Array2d furthest(1e-6, 1e-6);
  for (const TriangleMesh& mesh : meshes) {
    for (const auto& vertex : mesh.vertices.colwise()) {
      const Vector3d p = T_camera_object * Vector3d(vertex);
      furthest = furthest.max((p.head<2>() / p.z()).array().abs());
    }
  }
  const double f = kFilled * std::min(options.width / furthest.x(), options.height / furthest.y()) / 2;
  return {options.width, options.height, f, f, (options.width - 1) / 2.0, (options.height - 1) / 2.0, {}};
}

// The lamp of a map stands over its ground.
MapGround FarGround() {
  MapGround ground;
  ground.T_world_ground.linear() =
      Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitZ(), Vector3d::UnitY()).toRotationMatrix();
  ground.T_world_ground.translation().y() = -kFloorBelow;
  ground.area = Eigen::AlignedBox2d(Eigen::Vector2d(-1, -1), Eigen::Vector2d(1, 1));
  return ground;
}

// World: the object's frame.
class ModelPainter {
 public:
  ModelPainter(const TriangleMesh& mesh, const Camera& camera, const Eigen::Isometry3d& T_object_camera,
               int samples)
      : camera_(camera),
        T_object_camera_(T_object_camera),
        places_(SpreadPlaces(samples)),
        shading_(MapBodies(MakeScene(mesh), FarGround()), FarGround()) {}

  cv::Vec3b PixelAt(int x, int y) const {
    PixelLight light(shading_, Hash(x, y, 0, 1));
    Colour sum(0, 0, 0);
    for (const Eigen::Vector2d& place : places_)
      sum += SampleAt(Eigen::Vector2d(x, y) + place - Eigen::Vector2d(0.5, 0.5), light);
    const Colour mean = 255 * sum / static_cast<double>(places_.size());
    return {cv::saturate_cast<unsigned char>(mean[2]), cv::saturate_cast<unsigned char>(mean[1]),
            cv::saturate_cast<unsigned char>(mean[0])};
  }

 private:
  static MapScene MakeScene(const TriangleMesh& mesh) {
    MapScene scene;
    scene.objects.emplace_back().cad = mesh;
    return scene;
  }

  Colour SampleAt(const Eigen::Vector2d& pixel, PixelLight& light) const {
    const Vector3d direction = (T_object_camera_.linear() * camera_.Ray(pixel)).normalized();
    const RayHit hit = shading_.rays().Nearest(T_object_camera_.translation(), direction);
    if (hit.mesh <= 0) return {1, 1, 1};  // nothing, or the ground
    const Vector3d point = T_object_camera_.translation() + hit.distance * direction;
    return EncodeColour(light.At(hit, point, direction) * shading_.ColourAt(hit, point));
  }

  Camera camera_;
  Eigen::Isometry3d T_object_camera_;
  std::vector<Eigen::Vector2d> places_;  // of a pixel's rays
  MapShading shading_;
};

}  // namespace

std::vector<cv::Mat> DrawModels(const std::vector<TriangleMesh>& meshes,
                                const Eigen::Isometry3d& T_camera_object,
                                const ModelPictureOptions& options) {
  const Eigen::Isometry3d T_view_object = Centred(T_camera_object, kClosest * ComputeRadius(meshes));
  const Camera camera = FittingCamera(meshes, T_view_object, options);
  std::vector<cv::Mat> pictures;
  for (const TriangleMesh& mesh : meshes) {
    const ModelPainter painter(mesh, camera, T_view_object.inverse(), options.samples);
    cv::Mat3b picture(options.height, options.width);
#pragma omp parallel for schedule(dynamic)
    for (int y = 0; y < options.height; ++y) {
      for (int x = 0; x < options.width; ++x) picture(y, x) = painter.PixelAt(x, y);
    }
    pictures.push_back(picture);
  }
  return pictures;
}

}  // namespace armature
