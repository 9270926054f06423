// SPDX-License-Identifier: BSD-3-Clause
#include "app/run/photo_report.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>

#include "base/number_format.h"
#include "category/category_lookup.h"
#include "geometry/rotation.h"
#include "geometry/viewpoint.h"
#include "io/text_table.h"

namespace armature {
namespace {

using Json = nlohmann::ordered_json;

// An object's estimate in the units that are printed.
struct Placed {
  bool ok = false;
  Viewpoint viewpoint;
  double distance = 0;              // metres, to the object's centre
  Eigen::Vector3d size{0, 0, 0};    // metres
  size_t edges = 0, all_edges = 0;  // matched, of the category
};

Placed Measure(const ObjectObservation& observation, const CategoryModel& model) {
  const ObjectEstimate& estimate = observation.estimate;
  Placed placed;
  placed.ok = estimate.status == EstimateStatus::kOk;
  std::set<int> edges;
  for (const EdgeMatch& match : estimate.matches) edges.insert(match.edge);
  placed.edges = edges.size();
  placed.all_edges = model.spec.edge_names.size();
  if (!placed.ok) return placed;
  const Eigen::Vector3d centre = estimate.T_camera_object.translation();
  placed.viewpoint = ViewpointFromRotation(estimate.T_camera_object.linear(), centre);
  placed.distance = centre.norm();
  placed.size = BoundingBoxSize(WireframeFromCoefficients(model, estimate.coefficients));
  return placed;
}

std::vector<Cell> Row(size_t index, const ObjectObservation& observation, const Placed& placed) {
  std::vector<Cell> row = {CountCell(static_cast<long>(index)), TextCell(observation.detection.category),
                           TextCell(std::string(StatusName(observation.estimate.status)))};
  const Cell matched = TextCell(fmt::format("{} of {}", placed.edges, placed.all_edges));
  if (!placed.ok) {
    for (int i = 0; i < 4; ++i) row.push_back(NoCell());
    row.push_back(matched);
    row.push_back(NoCell());
    return row;
  }
  row.push_back(NumberCell(placed.viewpoint.azimuth / kDegree, 1));
  row.push_back(NumberCell(placed.viewpoint.elevation / kDegree, 1));
  row.push_back(NumberCell(placed.distance, 2));
  row.push_back(
      TextCell(fmt::format("{:.2f} x {:.2f} x {:.2f}", placed.size.x(), placed.size.y(), placed.size.z())));
  row.push_back(matched);
  row.push_back(NumberCell(observation.estimate.rms_pixels, 2));
  return row;
}

Json PoseJson(const Eigen::Isometry3d& pose) {
  const Eigen::Quaterniond q = CanonicalQuaternion(pose.linear());
  const Eigen::Vector3d t = pose.translation();
  return {{"translation", {t.x(), t.y(), t.z()}}, {"quaternion_xyzw", {q.x(), q.y(), q.z(), q.w()}}};
}

Json ObjectJson(size_t index, const ObjectObservation& observation, const Placed& placed) {
  const ObjectEstimate& estimate = observation.estimate;
  Json json = {{"index", index},
               {"category", observation.detection.category},
               {"status", StatusName(estimate.status)},
               {"edges_matched", placed.edges},
               {"edges", placed.all_edges}};
  if (!placed.ok) return json;
  json["azimuth_deg"] = placed.viewpoint.azimuth / kDegree;
  json["elevation_deg"] = placed.viewpoint.elevation / kDegree;
  json["tilt_deg"] = placed.viewpoint.tilt / kDegree;
  json["distance_m"] = placed.distance;
  json["size_m"] = {placed.size.x(), placed.size.y(), placed.size.z()};
  json["rms_pixels"] = estimate.rms_pixels;
  json["cost"] = estimate.cost;
  json["ambiguous"] = estimate.ambiguous;
  json["T_camera_object"] = PoseJson(estimate.T_camera_object);
  json["shape"] = std::vector<double>(estimate.coefficients.begin(), estimate.coefficients.end());
  return json;
}

}  // namespace

std::string PhotoReportText(const FrameResult& frame, const std::vector<CategoryModel>& models,
                            const std::string& picture) {
  Table table;
  table.columns = {"box",          "category", "status",        "azimuth [deg]", "elevation [deg]",
                   "distance [m]", "size [m]", "matched edges", "rms [pixels]"};
  for (size_t i = 0; i < frame.observations.size(); ++i) {
    const ObjectObservation& observation = frame.observations[i];
    table.rows.push_back(
        Row(i, observation, Measure(observation, LookUpModel(models, observation.detection.category))));
  }
  table.notes = {
      "azimuth, elevation: of the camera seen from the object, 0 in front of it; size: width x height x "
      "depth",
      "of the wireframe; rms: of the matched segments' ends from their edges."};
  return FormatTable(table, TableFormat::kText) + fmt::format("\nPicture: {}\n", picture);
}

std::string PhotoReportJson(const FrameResult& frame, const std::vector<CategoryModel>& models,
                            const std::string& picture) {
  Json objects = Json::array();
  for (size_t i = 0; i < frame.observations.size(); ++i) {
    const ObjectObservation& observation = frame.observations[i];
    const Placed placed = Measure(observation, LookUpModel(models, observation.detection.category));
    objects.push_back(ObjectJson(i, observation, placed));
  }
  Json json;
  json["picture"] = picture;
  json["up_camera"] = {frame.up_camera.x(), frame.up_camera.y(), frame.up_camera.z()};
  json["objects"] = objects;
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace armature
