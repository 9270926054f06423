// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/sequence_folder.h"

#include <fmt/format.h>

#include <fstream>
#include <optional>
#include <stdexcept>

#include "geometry/rotation.h"
#include "io/errors.h"
#include "io/image_writer.h"
#include "io/number_format.h"
#include "io/trajectory.h"

namespace armature {
namespace {

namespace fs = std::filesystem;

const fs::path& CheckedAbsent(const fs::path& folder) {
  std::error_code ignored;
  if (fs::exists(folder, ignored) && !fs::is_empty(folder, ignored)) {
    throw InputError(fmt::format("{}: exists; choose another folder or remove it", folder.string()));
  }
  return folder;
}

std::string Degrees(const std::optional<double>& radians) {
  return radians ? Fixed(*radians / kDegree, 2) : "";
}

std::string DetectionRow(double timestamp, const Detection& detection) {
  const Box& box = detection.box;
  return fmt::format("{},{},{},{},{},{},{},{},{},{}\n", Fixed(timestamp, 6), detection.category,
                     Fixed(box.x, 2), Fixed(box.y, 2), Fixed(box.width, 2), Fixed(box.height, 2),
                     Fixed(detection.score, 2), Degrees(detection.azimuth), Degrees(detection.elevation),
                     Degrees(detection.tilt));
}

std::string ObjectRow(const GeneratedObject& object) {
  const Eigen::Quaterniond q = CanonicalQuaternion(object.T_world_object.linear());
  const Eigen::Vector3d t = object.T_world_object.translation();
  return fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{}\n", object.id, object.category, object.instance,
                     Fixed(t.x(), 6), Fixed(t.y(), 6), Fixed(t.z(), 6), Fixed(q.x(), 9), Fixed(q.y(), 9),
                     Fixed(q.z(), 9), Fixed(q.w(), 9), Fixed(object.size.x(), 6), Fixed(object.size.y(), 6),
                     Fixed(object.size.z(), 6));
}

std::string SettingsText(const std::string& name, double fps, const Camera& camera,
                         const std::string& about) {
  return fmt::format(
      "# {}\nname: {}\nfps: {}\ncamera:\n  model: pinhole\n  width: {}\n  height: {}\n  fx: {}\n  fy: {}\n  "
      "cx: {}\n"
      "  cy: {}\n  distortion: [{}]\n",
      about, name, fps, camera.width, camera.height, camera.fx, camera.fy, camera.cx, camera.cy,
      fmt::join(camera.distortion, ", "));
}

}  // namespace

SequenceFolder::SequenceFolder(const fs::path& folder)
    : folder_(CheckedAbsent(folder)),
      images_("# timestamp filename\n"),
      detections_("timestamp,category,x,y,width,height,score,azimuth_deg,elevation_deg,tilt_deg\n"),
      true_detections_("# which object each detection is of; for evaluation only\ntimestamp,index,id\n"),
      odometry_(
          "# T_odom_camera, arbitrary scale; the first camera is the origin\n# timestamp tx ty tz qx qy qz "
          "qw\n"),
      groundtruth_("# T_world_camera, metres; for evaluation only\n# timestamp tx ty tz qx qy qz qw\n") {}

void SequenceFolder::AddFrame(const GeneratedFrame& frame) {
  const std::string name = fmt::format("rgb/{:04}.jpg", frames_++);
  WritePicture(folder_.partial() / name, frame.image);
  const std::string stamp = Fixed(frame.timestamp, 6);
  images_ += fmt::format("{} {}\n", stamp, name);
  odometry_ += TumLine({.timestamp = frame.timestamp, .pose = frame.T_odom_camera}) + "\n";
  groundtruth_ += TumLine({.timestamp = frame.timestamp, .pose = frame.T_world_camera}) + "\n";
  for (size_t index = 0; index < frame.detections.size(); ++index) {
    detections_ += DetectionRow(frame.timestamp, frame.detections[index].detection);
    true_detections_ += fmt::format("{},{},{}\n", stamp, index, frame.detections[index].id);
  }
}

void SequenceFolder::Finish(const std::string& name, double fps, const Camera& camera,
                            const std::vector<GeneratedObject>& objects, const std::string& about) {
  std::string rows =
      "# T_world_object, exact; for evaluation only\n"
      "id,category,instance,tx,ty,tz,qx,qy,qz,qw,size_x,size_y,size_z\n";
  for (const GeneratedObject& object : objects) rows += ObjectRow(object);
  Write("sequence.yaml", SettingsText(name, fps, camera, about));
  Write("rgb.txt", images_);
  Write("detections.csv", detections_);
  Write("detections_gt.csv", true_detections_);
  Write("odometry.txt", odometry_);
  Write("groundtruth.txt", groundtruth_);
  Write("objects_gt.csv", rows);
  folder_.Publish();
}

void SequenceFolder::Write(const std::string& name, const std::string& content) const {
  std::ofstream stream(folder_.partial() / name, std::ios::binary);
  stream << content;
  stream.close();
  if (!stream)
    throw std::runtime_error(fmt::format("{}: cannot be written", (folder_.partial() / name).string()));
}

}  // namespace armature
