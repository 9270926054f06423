// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/sequence_tables.h"

#include <fmt/format.h>

#include "base/csv_fields.h"
#include "base/number_format.h"
#include "datasets/cad/cad_instance.h"
#include "geometry/rotation.h"
#include "io/atomic_write.h"
#include "io/segments_csv.h"
#include "io/trajectory.h"

namespace armature {
namespace {

namespace fs = std::filesystem;

std::string Degrees(const std::optional<double>& radians) {
  return radians ? Fixed(*radians / kDegree, 2) : "";
}

std::string DetectionRow(const std::string& stamp, const Detection& detection) {
  const Box& box = detection.box;
  return fmt::format("{},{},{},{},{},{},{},{},{},{}\n", stamp, CsvField(detection.category), Fixed(box.x, 2),
                     Fixed(box.y, 2), Fixed(box.width, 2), Fixed(box.height, 2), Fixed(detection.score, 2),
                     Degrees(detection.azimuth), Degrees(detection.elevation), Degrees(detection.tilt));
}

std::string ObjectRow(const GeneratedObject& object) {
  const Eigen::Quaterniond q = CanonicalQuaternion(object.T_world_object.linear());
  const Eigen::Vector3d t = object.T_world_object.translation();
  return fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{}\n", object.id, object.category, object.instance,
                     Fixed(t.x(), 6), Fixed(t.y(), 6), Fixed(t.z(), 6), Fixed(q.x(), 9), Fixed(q.y(), 9),
                     Fixed(q.z(), 9), Fixed(q.w(), 9), Fixed(object.size.x(), 6), Fixed(object.size.y(), 6),
                     Fixed(object.size.z(), 6));
}

std::string EdgeRows(const std::string& stamp, const GeneratedObject& object,
                     const std::vector<TrueEdge>& edges) {
  const std::vector<std::string> names = EdgeNames(object.category);
  std::string rows;
  for (const TrueEdge& edge : edges) {
    const Segment& line = edge.line;
    rows += fmt::format("{},{},{},{},{},{},{},{}\n", stamp, CsvField(object.id),
                        CsvField(names[static_cast<size_t>(edge.edge)]), Fixed(line.p1.x(), 2),
                        Fixed(line.p1.y(), 2), Fixed(line.p2.x(), 2), Fixed(line.p2.y(), 2),
                        Fixed(edge.visible, 3));
  }
  return rows;
}

std::string SettingsText(const GeneratedSequence& sequence) {
  const Camera& camera = sequence.camera;
  std::string text = fmt::format(
      "# {}\nname: {}\nfps: {}\ncamera:\n  model: pinhole\n  width: {}\n  height: {}\n  fx: {}\n  fy: {}\n  "
      "cx: {}\n  cy: {}\n  distortion: [{}]\n",
      sequence.about, sequence.name, sequence.fps, camera.width, camera.height, camera.fx, camera.fy,
      camera.cx, camera.cy, fmt::join(camera.distortion, ", "));
  if (sequence.up_odom) {
    const Eigen::Vector3d& up = *sequence.up_odom;
    text += fmt::format("up: [{}, {}, {}]\n", Fixed(up.x(), 6), Fixed(up.y(), 6), Fixed(up.z(), 6));
  }
  return text;
}

void WriteLines(const fs::path& folder, const GeneratedSequence& sequence) {
  std::vector<double> stamps;
  std::vector<std::vector<Segment>> segments;
  for (const GeneratedFrame& frame : sequence.frames) {
    stamps.push_back(frame.timestamp);
    segments.push_back(frame.segments);
  }
  WriteSegments(folder / "segments.csv", stamps, segments);
}

// What a run reads.
void WriteInputs(const fs::path& folder, const GeneratedSequence& sequence) {
  std::string images = "# timestamp filename\n";
  std::string detections = "timestamp,category,x,y,width,height,score,azimuth_deg,elevation_deg,tilt_deg\n";
  std::string odometry =
      "# T_odom_camera, arbitrary scale; the first camera is the origin\n# timestamp tx ty tz qx qy qz qw\n";
  bool has_odometry = false;
  for (size_t i = 0; i < sequence.frames.size(); ++i) {
    const GeneratedFrame& frame = sequence.frames[i];
    const std::string stamp = Fixed(frame.timestamp, 6);
    images += fmt::format("{} {}\n", stamp, sequence.lines_only ? "-" : ImageName(static_cast<int>(i)));
    if (frame.T_odom_camera) {
      odometry += TumLine({.timestamp = frame.timestamp, .pose = *frame.T_odom_camera}) + "\n";
      has_odometry = true;
    }
    for (const SimulatedDetection& found : frame.detections)
      detections += DetectionRow(stamp, found.detection);
  }
  WriteFile(folder / "sequence.yaml", SettingsText(sequence));
  WriteFile(folder / "rgb.txt", images);
  WriteFile(folder / "detections.csv", detections);
  if (has_odometry) WriteFile(folder / "odometry.txt", odometry);
  if (sequence.lines_only) WriteLines(folder, sequence);
}

// What only the evaluation reads.
void WriteTruth(const fs::path& folder, const GeneratedSequence& sequence) {
  std::string cameras = "# T_world_camera, metres; for evaluation only\n# timestamp tx ty tz qx qy qz qw\n";
  std::string objects =
      "# T_world_object, exact; for evaluation "
      "only\nid,category,instance,tx,ty,tz,qx,qy,qz,qw,size_x,size_y,size_z\n";
  std::string detections =
      "# which object each detection is of (no id: a false alarm); for evaluation only\ntimestamp,index,id\n";
  std::string edges =
      "# edges in the images, by ray casting; for evaluation only\ntimestamp,id,edge,x1,y1,x2,y2,visible\n";
  for (const GeneratedObject& object : sequence.objects) objects += ObjectRow(object);
  for (const GeneratedFrame& frame : sequence.frames) {
    const std::string stamp = Fixed(frame.timestamp, 6);
    cameras += TumLine({.timestamp = frame.timestamp, .pose = frame.T_world_camera}) + "\n";
    for (size_t i = 0; i < frame.detections.size(); ++i)
      detections += fmt::format("{},{},{}\n", stamp, i, CsvField(frame.detections[i].id));
    for (size_t i = 0; i < frame.edges.size(); ++i)
      edges += EdgeRows(stamp, sequence.objects[i], frame.edges[i]);
  }
  WriteFile(folder / "groundtruth.txt", cameras);
  WriteFile(folder / "objects_gt.csv", objects);
  WriteFile(folder / "detections_gt.csv", detections);
  WriteFile(folder / "edges_gt.csv", edges);
}

}  // namespace

std::string ImageName(int frame) { return fmt::format("rgb/{:04}.jpg", frame); }

void WriteSequenceTables(const fs::path& folder, const GeneratedSequence& sequence) {
  WriteInputs(folder, sequence);
  WriteTruth(folder, sequence);
}

}  // namespace armature
