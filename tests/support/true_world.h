// SPDX-License-Identifier: BSD-3-Clause
// A sequence's ground truth with a chair and a table, their CAD annotations, and runs on it with known
// errors.
#pragma once

#include <fmt/format.h>

#include <functional>
#include <string>
#include <vector>

#include "base/number_format.h"
#include "category/category_lookup.h"
#include "eval/views/run_evaluation.h"
#include "geometry/rotation.h"
#include "geometry/viewpoint.h"
#include "io/category_yaml.h"
#include "support/category_examples.h"
#include "support/temp_folder.h"
#include "truth/true_scene.h"

namespace armature::testing {

inline std::string PoseText(const Eigen::Isometry3d& pose, const std::string& separator) {
  const Eigen::Quaterniond q = CanonicalQuaternion(pose.linear());
  const Eigen::Vector3d t = pose.translation();
  return fmt::format("{:.12f}{}{:.12f}{}{:.12f}{}{:.12f}{}{:.12f}{}{:.12f}{}{:.12f}", t.x(), separator, t.y(),
                     separator, t.z(), separator, q.x(), separator, q.y(), separator, q.z(), separator,
                     q.w());
}

inline std::vector<CategorySpec> ShippedSpecs() { return CollectSpecs(LoadCategories(CategoryFolder())); }

// An object seen from azimuth and elevation at the place, by a camera that is the world's frame.
inline Eigen::Isometry3d SeenFrom(double azimuth_deg, double elevation_deg, const Eigen::Vector3d& place) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = RotationFromViewpoint({azimuth_deg * kDegree, elevation_deg * kDegree, 0}, place);
  pose.translation() = place;
  return pose;
}

// Two frames, at 0 and 0.2 s; in both detection 0 is of the chair and 1 of the table, at 0.2 s detection 2 is
// a false alarm.
class TrueWorld {
 public:
  TrueWorld() {
    WriteSequence();
    WriteCad();
    models = LoadCategories(CategoryFolder());
    specs = CollectSpecs(models);
    cad = CadLibrary(folder / "cad", specs);
    sequence = LoadSequenceTruth(folder / "sequence", specs);
  }

  using Change =
      std::function<Eigen::Isometry3d(const std::string& category, const Eigen::Isometry3d& truth)>;
  // The name under which an edge is reported.
  using Rename = std::function<std::string(const std::string& category, const std::string& edge)>;

  // A run whose poses are the true ones after `change`, and whose matches are all visible true edges,
  // renamed.
  std::filesystem::path WriteRun(const std::string& name, const Change& change, const Rename& rename) const {
    std::string observations =
        "timestamp,index,status,object,cost,edges_matched,tx,ty,tz,qx,qy,qz,qw,shape\n";
    std::string associations = "timestamp,index,edge,segment_x1,segment_y1,segment_x2,segment_y2,cost\n";
    const TrueScene scene(sequence, models, cad);
    for (const auto& [key, object] : sequence.truth.detections) {
      const double timestamp = static_cast<double>(key.first) / 1e6;
      const CategorySpec& spec = scene.spec(object);
      const Eigen::Isometry3d pose =
          change(spec.name, *sequence.truth.TrueCameraObject(timestamp, key.second));
      observations += fmt::format("{:.6f},{},ok,,1,5,{},\n", timestamp, key.second, PoseText(pose, ","));
      const auto camera = FindStamp(sequence.truth.T_world_camera, timestamp);
      const auto edges = scene.EdgesSeen(object, sequence.truth.T_world_camera[*camera]);
      for (size_t e = 0; e < edges->size(); ++e) {
        if ((*edges)[e].visible_length() < kLeastVisiblePixels) continue;
        const Segment& line = (*edges)[e].line;
        associations += fmt::format("{:.6f},{},{},{},{},{},{},0.5\n", timestamp, key.second,
                                    rename(spec.name, spec.edge_names[e]), line.p1.x(), line.p1.y(),
                                    line.p2.x(), line.p2.y());
      }
    }
    return WriteRunFiles(name, observations, associations);
  }

  std::filesystem::path WriteRunFiles(const std::string& name, const std::string& observations,
                                      const std::string& associations) const {
    folder.Write(name + "/observations.csv", observations);
    folder.Write(name + "/associations.csv", associations);
    return folder.Write(name + "/summary.json", "{\"sequence\": \"world\", \"complete\": true}\n")
        .parent_path();
  }

  RunEvaluation Evaluate(const std::filesystem::path& run) const {
    return EvaluateRun(LoadRun(run), sequence, models, cad);
  }

  TempFolder folder;
  std::vector<CategoryModel> models;
  std::vector<CategorySpec> specs;  // of the models
  CadLibrary cad;
  SequenceTruth sequence;

 private:
  void WriteSequence() const {
    folder.Write(
        "sequence/sequence.yaml",
        "name: world\nfps: 5\ncamera:\n  model: pinhole\n  width: 640\n  height: 480\n  fx: 500\n  fy: 500\n"
        "  cx: 319.5\n  cy: 239.5\n  distortion: [0, 0, 0, 0, 0]\n");
    Eigen::Isometry3d second = Eigen::Isometry3d::Identity();
    second.translation().x() = 0.2;
    folder.Write(
        "sequence/groundtruth.txt",
        fmt::format("0.0 {}\n0.2 {}\n", PoseText(Eigen::Isometry3d::Identity(), " "), PoseText(second, " ")));
    folder.Write("sequence/objects_gt.csv",
                 fmt::format("id,category,instance,tx,ty,tz,qx,qy,qz,qw,size_x,size_y,size_z\n"
                             "chair0,chair,keypointnet:abc,{},0.4,0.8,0.4\n"
                             "table0,table,shapeassembly:17,{},1.2,0.74,0.6\n",
                             PoseText(SeenFrom(30, 20, {-0.7, 0, 3}), ","),
                             PoseText(SeenFrom(-20, 20, {0.7, 0, 3}), ",")));
    folder.Write("sequence/detections_gt.csv",
                 "timestamp,index,id\n0.0,0,chair0\n0.0,1,table0\n0.2,0,chair0\n0.2,1,table0\n0.2,2,\n");
  }

  void WriteCad() const {
    std::string header = "model_id,sane", row = "abc,1";
    const auto point = [&](const std::string& name, double x, double y, double z) {
      header += fmt::format(",{0}_x,{0}_y,{0}_z", name);
      row += fmt::format(",{},{},{}", x, y, z);
    };
    // Back at +z, left of the object at +x; half the object's size and off the origin.
    const auto chair = [&](const std::string& name, double x, double y, double z) {
      point(name, x / 2 + 1, y / 2 + 2, z / 2 + 3);
    };
    chair("s0", 0.2, 0.4, 0.2), chair("s1", -0.2, 0.4, 0.2), chair("s2", 0.2, 0, 0.2),
        chair("s3", -0.2, 0, 0.2);
    chair("s4", 0.2, 0, -0.2), chair("s5", -0.2, 0, -0.2), chair("s17", 0.2, -0.4, -0.2);
    chair("s18", 0.2, -0.4, 0.2), chair("s19", -0.2, -0.4, 0.2), chair("s20", -0.2, -0.4, -0.2);
    folder.Write("cad/keypointnet_chair_kp10.csv", header + "\n" + row + "\n");
    header = "partnet_anno_id,duplicate_model", row = "17,0";
    const double x[4] = {-1, 1, 1, -1}, z[4] = {-1, -1, 1, 1};
    for (int i = 0; i < 4; ++i) {
      point(fmt::format("t{}", i), 0.6 * x[i], 0.37, 0.3 * z[i]);
      point(fmt::format("lt{}", i), 0.5 * x[i], 0.35, 0.25 * z[i]);
      point(fmt::format("lb{}", i), 0.5 * x[i], -0.37, 0.25 * z[i]);
    }
    folder.Write("cad/shapeassembly_table_kp12.csv", header + "\n" + row + "\n");
  }
};

inline Eigen::Isometry3d Unchanged(const std::string&, const Eigen::Isometry3d& truth) { return truth; }
inline std::string SameName(const std::string&, const std::string& edge) { return edge; }

// The object turned by 180 degrees about its y axis.
inline Eigen::Isometry3d HalfTurn(const std::string&, const Eigen::Isometry3d& truth) {
  return truth * Eigen::AngleAxisd(180 * kDegree, Eigen::Vector3d::UnitY());
}

}  // namespace armature::testing
