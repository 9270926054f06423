// SPDX-License-Identifier: BSD-3-Clause
#include "app/run/photo_command.h"

#include <fmt/format.h>

#include <memory>
#include <opencv2/imgproc.hpp>

#include "app/run/photo_arguments.h"
#include "app/run/photo_report.h"
#include "base/errors.h"
#include "cli/help.h"
#include "drawing/overlay.h"
#include "io/image.h"
#include "io/image_writer.h"
#include "pipeline/frame_pipeline.h"

namespace armature {
namespace {

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
  fmt::print("{}", arguments.json ? PhotoReportJson(frame, models, picture)
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
