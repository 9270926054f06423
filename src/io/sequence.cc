// SPDX-License-Identifier: BSD-3-Clause
#include "io/sequence.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/console.h"
#include "base/errors.h"
#include "base/statistics.h"
#include "base/text.h"
#include "geometry/camera_faults.h"
#include "io/segments_csv.h"
#include "io/stamps.h"
#include "io/trajectory.h"
#include "io/yaml_support.h"

namespace armature {
namespace {

int PositiveInteger(const YamlMap& map, const std::string& key) {
  const int value = map.Integer(key);
  if (value <= 0) throw InputError(map.At(key, fmt::format("is {}; it has to be greater than 0", value)));
  return value;
}

double PositiveNumber(const YamlMap& map, const std::string& key) {
  const double value = map.Number(key);
  if (value <= 0) throw InputError(map.At(key, fmt::format("is {}; it has to be greater than 0", value)));
  return value;
}

void ReadDistortion(const YamlMap& map, Camera* camera) {
  if (!map.Has("distortion")) return;
  const std::vector<double> values = map.Numbers("distortion");
  if (values.size() != camera->distortion.size()) {
    throw InputError(
        map.At("distortion", fmt::format("has {} values; write the five [k1, k2, p1, p2, k3], 0 where "
                                         "there is none",
                                         values.size())));
  }
  std::copy(values.begin(), values.end(), camera->distortion.begin());
}

Camera ReadCamera(const YamlMap& map) {
  map.CheckKeys({"model", "width", "height", "fx", "fy", "cx", "cy", "distortion"});
  if (map.Has("model") && map.Text("model") != "pinhole") {
    throw InputError(
        map.At("model", fmt::format("is {}; only 'pinhole' is known, undistort other images first",
                                    Quoted(map.Text("model")))));
  }
  Camera camera;
  camera.width = PositiveInteger(map, "width");
  camera.height = PositiveInteger(map, "height");
  camera.fx = PositiveNumber(map, "fx");
  camera.fy = PositiveNumber(map, "fy");
  camera.cx = map.Number("cx");
  camera.cy = map.Number("cy");
  ReadDistortion(map, &camera);
  for (const CameraFault& fault : FindCameraFaults(camera)) {
    const std::string message = map.At(fault.key, fault.what);
    if (fault.is_impossible) throw InputError(message);
    NoteOnce(message, "warning: " + message);
  }
  return camera;
}

double ReadRate(const YamlMap& map) {
  constexpr double kLeast = 1e-5, kMost = 1e4;  // an image a day, the fastest cameras
  const double fps = PositiveNumber(map, "fps");
  if (fps >= kLeast && fps <= kMost) return fps;
  throw InputError(map.At("fps", fmt::format("is {:g}; write how many images there are a second", fps)));
}

std::string ReadName(const YamlMap& map) {
  std::string name = map.Text("name");
  const bool is_plain = !name.empty() && name != "." && name != ".." && name.find('/') == std::string::npos &&
                        name == Trimmed(name);
  if (!is_plain) {
    throw InputError(
        map.At("name", fmt::format("is {}; it names a folder, so write a plain word", Quoted(name))));
  }
  return name;
}

Eigen::Vector3d ReadUp(const YamlMap& map) {
  const std::vector<double> values = map.Numbers("up");
  if (values.size() != 3) {
    throw InputError(map.At("up", fmt::format("has {} values; write the three [x, y, z]", values.size())));
  }
  const Eigen::Vector3d up(values[0], values[1], values[2]);
  if (up.norm() < 1e-6) throw InputError(map.At("up", "has no length; write a direction such as [0, -1, 0]"));
  return up.normalized();
}

double ReadPositive(const YamlMap& map, const std::string& key) {
  const double metres = map.Number(key);
  if (metres > 0 && metres < 1000) return metres;
  throw InputError(map.At(key, fmt::format("is {}; write metres, more than 0", metres)));
}

FloorPrior ReadCameraHeight(const YamlMap& map) {
  map.CheckKeys({"metres", "sigma"});
  return {ReadPositive(map, "metres"), ReadPositive(map, "sigma")};
}

bool IsFile(const std::filesystem::path& file) {
  std::error_code ignored;
  return std::filesystem::is_regular_file(file, ignored);
}

constexpr std::string_view kNoPicture = "-";

// A line of rgb.txt: `timestamp filename`. A file's name may have blanks and '#' in it: what follows a '#' is
// a comment where no file is called so.
ImageEntry ParseEntry(const TextLine& line, const std::filesystem::path& folder, const std::string& where) {
  const size_t blank = line.text.find_first_of(" \t");
  const std::string name = blank == std::string::npos ? "" : Trimmed(line.text.substr(blank));
  if (name.empty() || name[0] == '#') {
    throw InputError(fmt::format("{}: {} is not 'timestamp filename'; write both", where, Quoted(line.text)));
  }
  ImageEntry entry;
  entry.timestamp = ParseNumber(line.text.substr(0, blank), where);
  entry.line = line.number;
  if (name == kNoPicture) return entry;
  entry.file = folder / (IsFile(folder / name) ? name : Trimmed(WithoutComment(name)));
  return entry;
}

void CheckExists(const ImageEntry& entry, const std::string& where) {
  if (entry.file.empty() || IsFile(entry.file)) return;
  throw InputError(fmt::format("{}: image {} does not exist; add the file or remove the line", where,
                               Quoted(entry.file.string())));
}

void CheckFolder(const std::filesystem::path& folder) {
  std::error_code ignored;
  if (std::filesystem::is_directory(folder, ignored)) return;
  const bool exists = std::filesystem::exists(folder, ignored);
  throw InputError(
      fmt::format("{}: {}; name a sequence folder with sequence.yaml, rgb.txt and detections.csv",
                  folder.string(), exists ? "is not a folder" : "does not exist"));
}

std::vector<double> CollectStamps(const std::vector<ImageEntry>& images) {
  std::vector<double> stamps;
  stamps.reserve(images.size());
  for (const ImageEntry& image : images) stamps.push_back(image.timestamp);
  return stamps;
}

// A stamp is in seconds, and images of one sequence are not years apart.
void CheckStamp(const ImageEntry& entry, const ImageEntry* earlier, const std::string& where) {
  constexpr double kLongest = 10 * 365.25 * 24 * 3600.0;  // seconds
  if (const auto unit = GuessStampUnit(entry.timestamp)) {
    throw InputError(fmt::format("{}: stamp {:.15g} is too large for seconds: {}? write seconds", where,
                                 entry.timestamp, *unit));
  }
  if (earlier == nullptr || entry.timestamp - earlier->timestamp < kLongest) return;
  throw InputError(
      fmt::format("{}: stamp {:.15g} is {} after {:.15g} of line {}; stamps are seconds, all "
                  "since the same moment",
                  where, entry.timestamp, DescribeDuration(entry.timestamp - earlier->timestamp),
                  earlier->timestamp, earlier->line));
}

// Images that are a thousand times as far apart as sequence.yaml says have stamps in another unit.
void CheckPace(const std::filesystem::path& list, const std::vector<double>& stamps, double fps) {
  if (stamps.size() < 2) return;
  std::vector<double> steps;
  for (size_t i = 1; i < stamps.size(); ++i) steps.push_back(stamps[i] - stamps[i - 1]);
  const double step = Median(steps);
  for (const auto& [factor, unit] :
       {std::pair{1e3, "milliseconds"}, {1e6, "microseconds"}, {1e9, "nanoseconds"}}) {
    if (step * fps < 0.5 * factor || step * fps > 2 * factor) continue;
    throw InputError(
        fmt::format("{}: an image each {:g} s (median), where 'fps' in sequence.yaml is {:g}: {}? "
                    "write seconds, or correct fps",
                    list.string(), step, fps, unit));
  }
}

// What can be right, as of two sessions, but is told.
void TellLongestGap(const std::filesystem::path& list, const std::vector<ImageEntry>& images) {
  constexpr double kLong = 3600;  // seconds
  double longest = 0;
  const ImageEntry* after = nullptr;
  for (size_t i = 1; i < images.size(); ++i) {
    const double gap = images[i].timestamp - images[i - 1].timestamp;
    if (gap > longest) after = &images[i];
    longest = std::max(longest, gap);
  }
  if (longest < kLong) return;
  Note(fmt::format("{}:{}: {} after the image before, the longest gap; are stamps in seconds?", list.string(),
                   after->line, DescribeDuration(longest)));
}

void LoadSegments(const std::filesystem::path& file, Sequence* sequence) {
  if (std::filesystem::exists(file)) {
    sequence->segments = ReadSegments(file, sequence->images);
    return;
  }
  for (const ImageEntry& image : sequence->images) {
    if (!image.file.empty()) continue;
    throw InputError(fmt::format("{}:{}: there is no picture, and no {} with its lines; name a file",
                                 (sequence->folder / "rgb.txt").string(), image.line, file.string()));
  }
}

void LoadOdometry(const std::filesystem::path& file, const OdometryOptions& options, Sequence* sequence) {
  const std::vector<double> stamps = CollectStamps(sequence->images);
  if (std::filesystem::exists(file)) {
    TrajectoryFile read = ReadTrajectoryFile(file, {.stamps = stamps});
    if (read.repeated > 0) Note(DescribeRepeatedStamps(file, read));
    sequence->odometry = std::move(read.poses);
  }
  OdometryAtImages at_images = PosesAtImages(sequence->odometry, stamps, options);
  sequence->T_odom_camera = std::move(at_images.T_odom_camera);
  sequence->coverage = at_images.coverage;
  if (sequence->odometry.empty() || sequence->coverage.images_with_pose > 0) return;
  throw InputError(fmt::format(
      "{}:{}: no pose is within {:g} ms of an image, and no two at most {:g} s apart are around "
      "one: its stamps go from {}, those of rgb.txt from {}; use the stamps of rgb.txt",
      file.string(), sequence->odometry.front().line, 1e3 * options.tolerance, options.max_gap,
      DescribeStampRange(sequence->odometry.front().timestamp, sequence->odometry.back().timestamp),
      DescribeStampRange(stamps.front(), stamps.back())));
}

}  // namespace

Sequence LoadSequence(const std::filesystem::path& folder, const std::vector<std::string>& categories,
                      const OdometryOptions& odometry, const std::filesystem::path& detections) {
  CheckFolder(folder);
  const SequenceSettings settings = ReadSequenceSettings(folder / "sequence.yaml");
  Sequence sequence;
  sequence.name = settings.name;
  sequence.fps = settings.fps;
  sequence.camera = settings.camera;
  sequence.up = settings.up;
  sequence.odometry_metric = settings.odometry_metric;
  sequence.camera_height = settings.camera_height;
  sequence.folder = folder;
  sequence.images = ReadImageList(folder / "rgb.txt");
  CheckPace(folder / "rgb.txt", CollectStamps(sequence.images), sequence.fps);
  TellLongestGap(folder / "rgb.txt", sequence.images);
  sequence.detections_file = detections;
  sequence.detections = ReadDetections(detections.empty() ? folder / "detections.csv" : detections,
                                       sequence.images, sequence.camera, categories);
  LoadSegments(folder / "segments.csv", &sequence);
  LoadOdometry(folder / "odometry.txt", odometry, &sequence);
  Detail(fmt::format("read {}: {} images, {} poses of odometry", folder.string(), sequence.images.size(),
                     sequence.odometry.size()));
  return sequence;
}

std::string NameDraw(const std::string& scene, int draw) {
  return draw == 1 ? scene : fmt::format("{}-draw{}", scene, draw);
}

std::vector<ImageEntry> ReadImageList(const std::filesystem::path& file) {
  std::vector<ImageEntry> images;
  for (const TextLine& line : ReadTextLines(file, Comments::kOwnLines)) {
    const std::string where = fmt::format("{}:{}", file.string(), line.number);
    const ImageEntry entry = ParseEntry(line, file.parent_path(), where);
    CheckStamp(entry, images.empty() ? nullptr : &images.back(), where);
    CheckExists(entry, where);
    if (!images.empty() && entry.timestamp - images.back().timestamp <= kStampTolerance) {
      throw InputError(
          fmt::format("{}: stamp {:.6f} does not follow {:.6f} of line {} by more than 1 ms; sort the "
                      "images, one a stamp",
                      where, entry.timestamp, images.back().timestamp, images.back().line));
    }
    images.push_back(entry);
  }
  if (images.empty()) {
    throw InputError(fmt::format("{}: lists no image; write lines 'timestamp filename'", file.string()));
  }
  return images;
}

SequenceSettings ReadSequenceSettings(const std::filesystem::path& file) {
  const YamlMap map = YamlMap::Load(file);
  map.CheckKeys({"name", "fps", "camera", "up", "odometry_metric", "camera_height"});
  SequenceSettings settings;
  settings.name = ReadName(map);
  settings.fps = ReadRate(map);
  settings.camera = ReadCamera(map.Map("camera"));
  if (map.Has("up")) settings.up = ReadUp(map);
  if (map.Has("camera_height")) settings.camera_height = ReadCameraHeight(map.Map("camera_height"));
  if (map.Has("odometry_metric")) settings.odometry_metric = map.Boolean("odometry_metric");
  return settings;
}

}  // namespace armature
