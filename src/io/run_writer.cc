// SPDX-License-Identifier: BSD-3-Clause
#include "io/run_writer.h"

#include <fmt/format.h>

#include <cerrno>
#include <set>

#include "base/csv_fields.h"
#include "base/errors.h"
#include "base/number_format.h"
#include "base/write_failure.h"
#include "category/category_lookup.h"
#include "io/atomic_write.h"
#include "io/shape_evidence_csv.h"

namespace armature {
namespace {

constexpr size_t kMostSkippedListed = 100;

void CheckWritten(const std::ofstream& stream, const std::filesystem::path& file) {
  if (!stream) throw InputError(WriteFailure(file, errno));
}

// tx,ty,tz,qx,qy,qz,qw
std::string PoseFields(const Eigen::Isometry3d& pose) {
  const Eigen::Vector3d t = pose.translation();
  const Eigen::Quaterniond q = CanonicalQuaternion(pose.linear());
  return fmt::format("{},{},{},{},{},{},{}", Fixed(t.x(), 6), Fixed(t.y(), 6), Fixed(t.z(), 6),
                     Fixed(q.x(), 9), Fixed(q.y(), 9), Fixed(q.z(), 9), Fixed(q.w(), 9));
}

std::string ShapeField(const Eigen::VectorXd& coefficients) {
  std::vector<std::string> values;
  for (const double value : coefficients) values.push_back(Fixed(value, 6));
  return fmt::format("{}", fmt::join(values, ";"));
}

// The upper triangle, row by row.
std::string CovarianceField(const PoseAndSizeCovariance& covariance) {
  std::vector<std::string> values;
  for (int i = 0; i < covariance.rows(); ++i) {
    for (int j = i; j < covariance.cols(); ++j) values.push_back(fmt::format("{:.6e}", covariance(i, j)));
  }
  return fmt::format("{}", fmt::join(values, ";"));
}

// Several collinear segments may explain one edge.
size_t EdgesMatched(const std::vector<EdgeMatch>& matches) {
  std::set<int> edges;
  for (const EdgeMatch& match : matches) edges.insert(match.edge);
  return edges.size();
}

std::vector<TimedPose> MakeTrajectory(const Map& map) {
  std::vector<TimedPose> poses;
  for (size_t i = 0; i < map.timestamps.size(); ++i) {
    poses.push_back({.timestamp = map.timestamps[i], .pose = map.T_world_camera[i]});
  }
  return poses;
}

std::string ObjectsText(const std::vector<MapObject>& objects) {
  std::string text =
      "id,category,instance,tx,ty,tz,qx,qy,qz,qw,size_x,size_y,size_z,observations,shape,probability,"
      "covariance\n";
  for (const MapObject& object : objects) {
    const Eigen::Vector3d size = object.Size();
    text += fmt::format("{},{},,{},{},{},{},{},{},{},{}\n", CsvField(object.id),
                        CsvField(object.model->spec.name), PoseFields(object.T_world_object),
                        Fixed(size.x(), 6), Fixed(size.y(), 6), Fixed(size.z(), 6), object.observations,
                        ShapeField(object.coefficients),
                        object.uncertainty ? Fixed(object.uncertainty->probability, 4) : "",
                        object.uncertainty ? CovarianceField(object.uncertainty->covariance) : "");
  }
  return text;
}

}  // namespace

RunWriter::RunWriter(const std::filesystem::path& folder, std::vector<CategoryModel> models)
    : folder_(folder),
      models_(std::move(models)),
      associations_(File("associations.csv")),
      timings_(File("timings.csv")) {
  associations_ << "timestamp,index,edge,segment_x1,segment_y1,segment_x2,segment_y2,cost\n";
  timings_
      << "timestamp,objects,segments,load_ms,lines_ms,association_ms,optimization_ms,mapping_ms,total_ms\n";
}

void RunWriter::WriteConfig(const std::string& yaml) { WriteFile(File("config.yaml"), yaml); }

void RunWriter::WriteMaps(const Map& map, const Map& by_odometry) {
  WriteTumTrajectory(File("trajectory.txt"), MakeTrajectory(map));
  WriteTumTrajectory(File("odometry_scaled.txt"), MakeTrajectory(by_odometry));
  WriteFile(File("objects.csv"), ObjectsText(map.objects));
  WriteFile(File("objects_odometry.csv"), ObjectsText(by_odometry.objects));
  WriteFile(File("shape_evidence.csv"), ShapeEvidenceText(map.objects));
  size_t camera = 0;
  for (ObservationRow& row : observations_) {
    while (camera < map.timestamps.size() && map.timestamps[camera] < row.timestamp) ++camera;
    if (camera >= map.timestamps.size() || map.timestamps[camera] != row.timestamp) continue;
    const int object = map.phi[camera][row.index];
    if (object >= 0) row.object = map.objects[static_cast<size_t>(object)].id;
  }
}

void RunWriter::AddFrame(const FrameResult& frame) {
  for (size_t index = 0; index < frame.observations.size(); ++index) {
    AddObservation(frame.timestamp, index, frame.observations[index]);
    WriteAssociations(frame.timestamp, index, frame.observations[index]);
    const auto status = static_cast<size_t>(frame.observations[index].estimate.status);
    ++counts_.observations.at(status);
  }
  WriteTimings(frame);
  statistics_.Add(frame.times);
  ++counts_.frames;
  counts_.detections += static_cast<long>(frame.observations.size());
  counts_.segments += static_cast<long>(frame.segments.size());
  CheckWritten(associations_, File("associations.csv"));
  CheckWritten(timings_, File("timings.csv"));
}

void RunWriter::AddObservation(double timestamp, size_t index, const ObjectObservation& observation) {
  const ObjectEstimate& estimate = observation.estimate;
  const bool has_pose = estimate.status == EstimateStatus::kOk;
  observations_.push_back(
      {timestamp, index, fmt::format("{},{},{}", Fixed(timestamp, 6), index, StatusName(estimate.status)), "",
       fmt::format("{},{},{},{},{},{}", estimate.matches.empty() ? "" : Fixed(estimate.cost, 6),
                   EdgesMatched(estimate.matches), has_pose ? PoseFields(estimate.T_camera_object) : ",,,,,,",
                   has_pose ? ShapeField(estimate.coefficients) : "",
                   has_pose ? (estimate.ambiguous ? "1" : "0") : "",
                   estimate.probability ? Fixed(*estimate.probability, 4) : "")});
}

void RunWriter::WriteObservations() {
  std::string text =
      "timestamp,index,status,object,cost,edges_matched,tx,ty,tz,qx,qy,qz,qw,shape,ambiguous,probability\n";
  for (const ObservationRow& row : observations_) {
    text += fmt::format("{},{},{}\n", row.before_object, CsvField(row.object), row.after_object);
  }
  WriteFile(File("observations.csv"), text);
}

void RunWriter::WriteAssociations(double timestamp, size_t index, const ObjectObservation& observation) {
  const CategorySpec& spec = LookUpModel(models_, observation.detection.category).spec;
  for (const EdgeMatch& match : observation.estimate.matches) {
    const Segment& segment = match.segment;
    associations_ << fmt::format("{},{},{},{},{},{},{},{}\n", Fixed(timestamp, 6), index,
                                 CsvField(spec.edge_names.at(static_cast<size_t>(match.edge))),
                                 Fixed(segment.p1.x(), 3), Fixed(segment.p1.y(), 3), Fixed(segment.p2.x(), 3),
                                 Fixed(segment.p2.y(), 3), Fixed(match.cost, 4));
  }
}

void RunWriter::WriteTimings(const FrameResult& frame) {
  const StageTimes& times = frame.times;
  timings_ << fmt::format("{},{},{},{},{},{},{},{},{}\n", Fixed(frame.timestamp, 6),
                          frame.observations.size(), frame.segments.size(), Fixed(times.load, 4),
                          Fixed(times.lines, 4), Fixed(times.association, 4), Fixed(times.optimization, 4),
                          Fixed(times.mapping, 4), Fixed(times.total(), 4));
}

void RunWriter::AddSkippedImage(double timestamp, const std::string& reason) {
  ++counts_.skipped_images;
  if (counts_.skipped.size() < kMostSkippedListed) counts_.skipped.push_back({timestamp, reason});
}

void RunWriter::Finish(const RunSummary& summary) {
  WriteObservations();
  associations_.close();
  timings_.close();
  CheckWritten(associations_, File("associations.csv"));
  CheckWritten(timings_, File("timings.csv"));
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start_;
  WriteFile(File("summary.json"), SummaryJson(summary, counts_, statistics_, wall.count()));
  folder_.Publish();
}

}  // namespace armature
