// SPDX-License-Identifier: BSD-3-Clause
// A room with furniture of the shipped categories, a camera's way through it, and what the front end would
// hand to the map: segments, boxes, single-view estimates and an odometry that drifts. No images.
//
// The world's y axis points down; the first camera is its origin, as it is the map's.
#pragma once

#include <cmath>
#include <deque>
#include <optional>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "association/box_constraints.h"
#include "geometry/rotation.h"
#include "geometry/se3.h"
#include "io/category_yaml.h"
#include "mapping/map_frame.h"
#include "support/category_examples.h"
#include "support/padded_box.h"

namespace armature::testing {

inline CategoryModel LoadModel(const std::string& category) {
  return LoadCategory(CategoryFolder() / (category + ".yaml"));
}

struct TrueFurniture {
  const CategoryModel* model = nullptr;
  Eigen::Isometry3d T_world_object = Eigen::Isometry3d::Identity();  // metres
  Eigen::VectorXd coefficients;                                      // standard deviations
};

// Errors of what is seen, standard deviations, and of the odometry.
struct WorldNoise {
  double segment_pixels = 0;     // of a segment's ends
  double depth = 0;              // of a single view, share of the distance
  double yaw_deg = 0;            // of a single view
  double shape = 0;              // of a single view, standard deviations of the category
  double unit = 1;               // metres a unit of odometry
  double scale_drift = 0;        // relative, per metre travelled: the odometry's steps grow
  double heading_drift_deg = 0;  // degrees per metre travelled
  unsigned seed = 1;
};

class MapWorld {
 public:
  MapWorld() {
    for (const char* category : {"chair", "table", "laptop"}) models_.push_back(LoadModel(category));
  }
  MapWorld(const MapWorld&) = delete;
  MapWorld& operator=(const MapWorld&) = delete;

  Camera camera{856, 480, 580, 580, 427.5, 239.5, {}};
  double floor = 1.4;    // metres below the first camera
  double seconds = 0.2;  // between frames
  double reach = 5;      // metres: what is farther is not detected
  std::vector<TrueFurniture> furniture;
  std::vector<Eigen::Isometry3d> T_world_camera;

  const CategoryModel& Model(const std::string& category) const {
    for (const CategoryModel& model : models_) {
      if (model.spec.name == category) return model;
    }
    throw std::logic_error("no such category: " + category);
  }

  // Upright on the floor, or standing `above` it; x to the right of the first camera, z ahead of it. At yaw 0
  // the front looks the way that the first camera looks.
  void Put(const std::string& category, double x, double z, double yaw_deg, double shape = 0,
           double above = 0) {
    TrueFurniture piece;
    piece.model = &Model(category);
    piece.coefficients = Eigen::VectorXd::Zero(piece.model->modes());
    piece.coefficients.head<2>() << shape, -0.5 * shape;
    piece.T_world_object.linear() =
        Eigen::Vector3d(-1, -1, 1).asDiagonal() * ExpSO3({0, yaw_deg * kDegree, 0});
    const Wireframe wireframe = WireframeFromCoefficients(*piece.model, piece.coefficients);
    double lowest = 1e9;
    for (int edge = 0; edge < wireframe.edges(); ++edge) {
      lowest = std::min({lowest, wireframe.End(edge, 0).y(), wireframe.End(edge, 1).y()});
    }
    piece.T_world_object.translation() << x, floor + lowest - above, z;
    furniture.push_back(piece);
  }

  // A camera at (x, z), 1.4 m above the floor, that looks at a point on the floor plan, down by the pitch.
  void Look(double x, double z, double at_x, double at_z, double pitch = 0.25) {
    const Eigen::Vector3d down(0, 1, 0);
    const Eigen::Vector3d level = Eigen::Vector3d(at_x - x, 0, at_z - z).normalized();
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.linear().col(2) = std::cos(pitch) * level + std::sin(pitch) * down;
    pose.linear().col(0) = down.cross(level);
    pose.linear().col(1) = pose.linear().col(2).cross(pose.linear().col(0));
    pose.translation() << x, 0, z;
    T_world_camera.push_back(pose);
  }

  // The true observations of each frame are in the order of `furniture`, without those that cannot be seen;
  // tracks are indices of `furniture`.
  std::vector<MapFrame> Frames(const WorldNoise& noise) const {
    std::mt19937 random(noise.seed);
    std::vector<MapFrame> frames;
    double travelled = 0;
    for (size_t i = 0; i < T_world_camera.size(); ++i) {
      MapFrame frame;
      frame.timestamp = 100 + seconds * static_cast<double>(i);
      frame.up_camera = T_world_camera[i].linear().transpose() * Eigen::Vector3d(0, -1, 0);
      frame.up_sigma = 0;
      frame.T_odom_camera = T_world_camera[i];
      if (i > 0) {
        Eigen::Isometry3d step = T_world_camera[i - 1].inverse() * T_world_camera[i];
        const double length = step.translation().norm();
        step.translation() *= (1 + noise.scale_drift * travelled) / noise.unit;
        travelled += length;
        step.linear() = step.linear() * ExpSO3(noise.heading_drift_deg * kDegree * length * frame.up_camera);
        frame.T_odom_camera = frames.back().T_odom_camera * step;
      }
      AddObservations(i, noise, random, frame);
      frames.push_back(std::move(frame));
    }
    return frames;
  }

  // What a single view that is off by `wrong` (a step in the object's frame) would say of a true object.
  MapObservation Observe(const ObjectView& view, const PoseAndShape& truth, const Vector6d& wrong,
                         const Eigen::VectorXd& wrong_shape, const std::vector<EdgeMatch>& matches) const {
    MapObservation observation;
    observation.view = view;
    observation.measured = {truth.T_camera_object * ExpSE3(wrong), truth.coefficients + wrong_shape};
    ProjectedWireframe projected;
    ProjectWireframe(camera, view.model->spec,
                     WireframeFromCoefficients(*view.model, observation.measured.coefficients),
                     observation.measured.T_camera_object, Image(), {}, projected);
    observation.evidence = EvidenceAt(
        {view, view.sides, matches, projected, observation.measured, BoxOptions{}, ResectionOptions{}});
    return observation;
  }

 private:
  Box Image() const { return {0, 0, camera.width - 1.0, camera.height - 1.0}; }

  void AddObservations(size_t i, const WorldNoise& noise, std::mt19937& random, MapFrame& frame) const {
    for (size_t o = 0; o < furniture.size(); ++o) {
      const PoseAndShape truth{T_world_camera[i].inverse() * furniture[o].T_world_object,
                               furniture[o].coefficients};
      std::optional<MapObservation> observation = See(i, o, truth, noise, random);
      if (!observation) continue;
      observation->track = static_cast<int>(o);
      frame.observations.push_back(std::move(*observation));
    }
  }

  std::optional<MapObservation> See(size_t camera_index, size_t object, const PoseAndShape& truth,
                                    const WorldNoise& noise, std::mt19937& random) const {
    const Eigen::Vector3d t = truth.T_camera_object.translation();
    if (t.z() < 0.8 || t.norm() > reach || !Image().Contains(camera.Project(t))) return std::nullopt;
    const CategoryModel& model = *furniture[object].model;
    ProjectedWireframe projected;
    ProjectWireframe(camera, model.spec, WireframeFromCoefficients(model, truth.coefficients),
                     truth.T_camera_object, Image(), OccludersOf(camera_index, object), projected);
    ObjectView view = MakeView(model, projected, truth.T_camera_object.linear(), UpAt(camera_index));
    std::normal_distribution<double> normal;
    std::vector<EdgeMatch> matches;
    for (int edge = 0; edge < model.spec.edges(); ++edge) {
      const ProjectedEdge& seen = projected.edges[static_cast<size_t>(edge)];
      if (seen.length < 15 || seen.visible_share < 0.5) continue;
      Segment segment = seen.line;
      for (double* value : {&segment.p1.x(), &segment.p1.y(), &segment.p2.x(), &segment.p2.y()}) {
        *value += noise.segment_pixels * normal(random);
      }
      view.segments.push_back(segment);
      matches.push_back({edge, segment, 0});
    }
    if (matches.size() < 4) return std::nullopt;
    Vector6d wrong = Vector6d::Zero();
    wrong(1) = noise.yaw_deg * kDegree * normal(random);
    wrong.tail<3>() = truth.T_camera_object.linear().transpose() * (noise.depth * normal(random) * t);
    Eigen::VectorXd wrong_shape(truth.coefficients.size());
    for (double& value : wrong_shape) value = noise.shape * normal(random);
    return Observe(view, truth, wrong, wrong_shape, matches);
  }

  Eigen::Vector3d UpAt(size_t i) const {
    return T_world_camera[i].linear().transpose() * Eigen::Vector3d(0, -1, 0);
  }

  std::vector<ImageFace> OccludersOf(size_t camera_index, size_t object) const {
    std::vector<ImageFace> occluders;
    for (size_t o = 0; o < furniture.size(); ++o) {
      if (o == object) continue;
      const TrueFurniture& other = furniture[o];
      const Wireframe wireframe = WireframeFromCoefficients(*other.model, other.coefficients);
      for (ImageFace& face : ProjectFaces(camera, other.model->spec, wireframe,
                                          T_world_camera[camera_index].inverse() * other.T_world_object)) {
        occluders.push_back(std::move(face));
      }
    }
    return occluders;
  }

  // With the box around the projection, without segments.
  ObjectView MakeView(const CategoryModel& model, const ProjectedWireframe& projected,
                      const Eigen::Matrix3d& R_camera_object, const Eigen::Vector3d& up_camera) const {
    ObjectView view;
    view.camera = &camera;
    view.model = &model;
    view.up_camera = up_camera;
    view.detection.category = model.spec.name;
    view.detection.box = Intersection(PaddedBox(camera, model.spec, projected, R_camera_object), Image());
    view.sides = SidesAtImageBorder(view.detection.box, camera);
    return view;
  }

  std::deque<CategoryModel> models_;  // stays where it is
};

// Two chairs and a table; the camera goes past them in an arc.
inline void FurnishRoom(MapWorld& world, int cameras = 40) {
  world.Put("chair", -0.8, 2.6, 160, 0.6);
  world.Put("chair", 0.9, 2.3, -130, -0.4);
  world.Put("table", 0.1, 3.6, 20, 0.3);
  for (int i = 0; i < cameras; ++i) {
    const double share = i / (cameras - 1.0);
    world.Look(-1.2 * share + 0.4 * std::sin(6 * share), 0.9 * share, 0.1, 2.8);
  }
}

}  // namespace armature::testing
