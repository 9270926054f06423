// SPDX-License-Identifier: BSD-3-Clause
#include "app/run/photo_command.h"

#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <memory>
#include <opencv2/imgproc.hpp>
#include <string>
#include <vector>

#include "app/run/photo_report.h"
#include "association/detection.h"
#include "base/console.h"
#include "base/errors.h"
#include "base/nearest_name.h"
#include "base/text.h"
#include "cli/help.h"
#include "drawing/overlay.h"
#include "geometry/camera.h"
#include "geometry/camera_faults.h"
#include "geometry/rotation.h"
#include "io/image.h"
#include "pipeline/frame_pipeline.h"

namespace armature {
namespace {

std::string Where(const std::string& argument, const std::string& text) {
  return argument + " " + Quoted(text);
}

[[noreturn]] void ThrowCount(const std::string& where, size_t count, const std::string& format) {
  throw InputError(fmt::format("{}: has {} values; write {}", where, count, format));
}

std::vector<double> Numbers(const std::string& argument, const std::string& text, size_t count,
                            const std::string& format) {
  const std::vector<std::string> fields = SplitFields(text);
  const std::string where = Where(argument, text);
  if (fields.size() != count) ThrowCount(where, fields.size(), format);
  std::vector<double> numbers;
  numbers.reserve(count);
  for (const std::string& field : fields) numbers.push_back(ParseNumber(field, where));
  return numbers;
}

void CheckBox(const Box& box, const Camera& camera, const std::string& where) {
  if (box.width <= 0 || box.height <= 0) {
    throw InputError(fmt::format("{}: the box is {} x {} pixels; width and height have to be greater than 0",
                                 where, box.width, box.height));
  }
  const Box image{-0.5, -0.5, static_cast<double>(camera.width), static_cast<double>(camera.height)};
  if (Intersection(box, image).area() > 0) return;
  throw InputError(fmt::format("{}: the box is outside the {} x {} image; correct it", where, camera.width,
                               camera.height));
}

// "fx,fy,cx,cy" in pixels, and "k1,k2,p1,p2,k3" or nothing. Throws InputError naming the argument.
Camera ParseCamera(const std::string& intrinsics, const std::string& distortion, int width, int height) {
  const std::vector<double> k = Numbers("--camera", intrinsics, 4, "fx,fy,cx,cy in pixels");
  if (k[0] <= 0 || k[1] <= 0) {
    throw InputError(fmt::format("{}: fx and fy have to be greater than 0", Where("--camera", intrinsics)));
  }
  Camera camera{width, height, k[0], k[1], k[2], k[3]};
  if (!distortion.empty()) {
    const std::vector<double> values =
        Numbers("--distortion", distortion, 5, "k1,k2,p1,p2,k3, 0 where there is none");
    std::copy(values.begin(), values.end(), camera.distortion.begin());
  }
  for (const CameraFault& fault : FindCameraFaults(camera)) {
    const bool is_distortion = fault.key == "distortion";
    const std::string message = fmt::format(
        "{}: {} {}", is_distortion ? Where("--distortion", distortion) : Where("--camera", intrinsics),
        fault.key, fault.what);
    if (fault.is_impossible) throw InputError(message);
    Note("warning: " + message);
  }
  return camera;
}

// "category,x,y,width,height[,azimuth_deg]": the box in pixels from the top-left corner, at least partly in
// the image. Throws InputError naming the argument.
Detection ParseDetection(const std::string& text, const Camera& camera,
                         const std::vector<std::string>& categories) {
  const std::vector<std::string> fields = SplitFields(text);
  const std::string where = Where("--box", text);
  if (fields.size() < 5 || fields.size() > 6) {
    ThrowCount(where, fields.size(), "category,x,y,width,height[,azimuth_deg]");
  }
  Detection detection;
  detection.category = fields[0];
  if (std::find(categories.begin(), categories.end(), detection.category) == categories.end()) {
    throw InputError(
        fmt::format("{}: {}", where, UnknownNameMessage("category", detection.category, categories)));
  }
  detection.box = {ParseNumber(fields[1], where), ParseNumber(fields[2], where),
                   ParseNumber(fields[3], where), ParseNumber(fields[4], where)};
  CheckBox(detection.box, camera, where);
  if (fields.size() == 6) {
    const double degrees = ParseNumber(fields[5], where);
    if (std::abs(degrees) > 360)
      throw InputError(fmt::format("{}: the azimuth is {:g}; write degrees, -360..360", where, degrees));
    detection.azimuth = degrees * kDegree;
  }
  return detection;
}

// "x,y,z", a direction in the camera frame (x right, y down, z forward); unit length. Throws InputError.
Eigen::Vector3d ParseUp(const std::string& text) {
  const std::vector<double> values = Numbers("--up", text, 3, "x,y,z in the camera frame, such as 0,-1,0");
  const Eigen::Vector3d up(values[0], values[1], values[2]);
  if (up.norm() < 1e-6) {
    throw InputError(fmt::format("{}: has no length; write a direction such as 0,-1,0", Where("--up", text)));
  }
  return up.normalized();
}

cv::Mat LoadPhoto(const std::filesystem::path& file) {
  const ImageResult result = ReadImage(file);
  if (!result.image) throw InputError(result.error);
  return *result.image;
}

// `up` (camera frame) is handed on as that of a sequence whose odometry's frame is the camera's.
FrameResult Process(const cv::Mat& image, const std::vector<Detection>& detections, const Camera& camera,
                    const std::optional<Eigen::Vector3d>& up, Options options,
                    const std::vector<CategoryModel>& models) {
  FrameInput input;
  input.detections = detections;
  if (up) {
    options.up.source = UpSource::kAuto;  // what is given here counts, whatever the preset says
    input.T_odom_camera = Eigen::Isometry3d::Identity();
  }
  cv::Mat gray;
  cv::cvtColor(image, gray, cv::COLOR_BGR2GRAY);
  FramePipeline pipeline(std::move(options), camera, models, up);
  return pipeline.Process(gray, input);
}

CommandHelp PhotoHelp() {
  return {
      .description =
          "Finds pose and shape of the objects whose boxes are given, in one picture of a camera of known "
          "intrinsics, and draws what was found. Distances come from the metric size of furniture, so "
          "they are as good as the object is usual.",
      .files = {{"OUT", "the picture, dimmed, with segments, boxes, wireframes and matched segments"}},
      .exit_status = {},
      .examples = {{"the first frame of a generated sequence",
                    "armature photo datasets/generated/seq1/rgb/0000.jpg --camera 580,580,427.5,239.5 "
                    "--box chair,364,175,163,253,57 --out runs/photo.png"}}};
}

}  // namespace

int RunPhoto(const PhotoArguments& arguments) {
  CheckPictureName(arguments.out);
  const Options options = LoadOptions(arguments.configuration);
  const std::vector<CategoryModel> models = LoadModels(arguments.configuration);
  std::optional<Eigen::Vector3d> up;
  if (!arguments.up.empty()) up = ParseUp(arguments.up);
  const cv::Mat image = LoadPhoto(arguments.image);
  const Camera camera = ParseCamera(arguments.camera, arguments.distortion, image.cols, image.rows);
  std::vector<Detection> detections;
  for (const std::string& box : arguments.boxes) {
    detections.push_back(ParseDetection(box, camera, CategoryNames(models)));
  }

  const FrameResult frame = Process(image, detections, camera, up, options, models);
  WritePicture(arguments.out, DrawOverlay(Undistorted(image, camera), frame, models, camera));
  const std::string picture = arguments.out.string();
  PrintResult(arguments.json ? PhotoReportJson(frame, models, picture)
                             : PhotoReportText(frame, models, picture));
  return 0;
}

void AddPhotoCommand(CLI::App& app, int& exit_status) {
  const auto arguments = std::make_shared<PhotoArguments>();
  PhotoArguments& a = *arguments;
  CLI::App* photo = app.add_subcommand("photo", "Find and place the objects of one photograph");
  Describe(*photo, PhotoHelp());
  BeginSection(*photo, "Input");
  photo->add_option("IMAGE", a.image, "photograph")->required()->type_name("FILE");
  photo->add_option("--camera", a.camera, "intrinsics, pixels")->required()->type_name("fx,fy,cx,cy");
  photo->add_option("--distortion", a.distortion, "of the lens, as OpenCV")->type_name("k1,k2,p1,p2,k3");
  photo
      ->add_option(
          "--box", a.boxes,
          "an object: category, box in pixels from the top-left corner and, if known, the azimuth; may be "
          "repeated")
      ->required()
      ->type_name("category,x,y,width,height[,azimuth_deg]")
      ->allow_extra_args(false);
  photo
      ->add_option("--up", a.up,
                   "up direction in the camera frame, 0,-1,0 for a level camera (else estimated)")
      ->type_name("x,y,z");
  BeginSection(*photo, "Output");
  photo->add_option("--out", a.out, "picture to write: .png or .jpg")->required()->type_name("FILE");
  photo->add_flag("--json", a.json, "print JSON instead of a table");
  AddConfigurationArguments(*photo, a.configuration);
  photo->callback([arguments, &exit_status] { exit_status = RunPhoto(*arguments); });
}

}  // namespace armature
