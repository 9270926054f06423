// SPDX-License-Identifier: BSD-3-Clause
// `armature photo` from end to end.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>

#include "geometry/rotation.h"
#include "geometry/viewpoint.h"
#include "io/sequence.h"
#include "support/program.h"
#include "support/shared_data.h"
#include "truth/ground_truth.h"

namespace armature {
namespace {

using testing::AllFiles;
using testing::ExpectBadInput;
using testing::ProgramResult;
using testing::RunOk;
using testing::TempFolder;

std::string BoxArgument(const Detection& detection) {
  const Box& box = detection.box;
  return fmt::format("{},{},{},{},{},{}", detection.category, box.x, box.y, box.width, box.height,
                     *detection.azimuth / kDegree);
}

TEST(AppPhoto, PlacesTheFurnitureOfOnePicture) {
  const TempFolder folder;
  RunOk({"generate", "--only", "sample", "--without-cad", "--frames", "1", "--out", folder.path()});
  const Sequence sequence = LoadSequence(folder / "sample", {"chair", "table", "laptop"});
  const GroundTruth truth = LoadGroundTruth(folder / "sample");
  const Eigen::Vector3d up =
      truth.T_world_camera.front().pose.linear().transpose() * Eigen::Vector3d::UnitZ();
  std::vector<std::string> arguments = {"photo",    sequence.images.front().file,
                                        "--camera", "525,525,319.5,239.5",
                                        "--up",     fmt::format("{},{},{}", up.x(), up.y(), up.z()),
                                        "--out",    folder / "new/picture.png",
                                        "--json"};
  for (const Detection& detection : sequence.detections.front()) {
    arguments.insert(arguments.end(), {"--box", BoxArgument(detection)});
  }
  const auto json = nlohmann::json::parse(RunOk(arguments).out);
  EXPECT_EQ(cv::imread(folder / "new/picture.png").size(), cv::Size(640, 480));
  EXPECT_NEAR(json["up_camera"][1], up.y(), 1e-6);

  ASSERT_EQ(json["objects"].size(), sequence.detections.front().size());
  int right = 0;
  for (const auto& object : json["objects"]) {
    const Eigen::Isometry3d T_true = truth.TrueCameraObject(0, object["index"]).value();
    if (object["status"] != "ok") continue;
    const Viewpoint viewpoint = ViewpointFromRotation(T_true.linear(), T_true.translation());
    const int order = object["category"] == "table" ? 2 : 1;
    const double azimuth = object["azimuth_deg"].get<double>() * kDegree;
    const bool is_turned_right =
        std::abs(AzimuthDifference(azimuth, viewpoint.azimuth, order)) < 15 * kDegree;
    const bool is_as_far =
        std::abs(object["distance_m"].get<double>() / T_true.translation().norm() - 1) < 0.2;
    if (is_turned_right && is_as_far) ++right;
  }
  EXPECT_GE(right, 3) << json.dump();
}

class AppPhotoInput : public ::testing::Test {
 protected:
  AppPhotoInput() {
    const cv::Mat image(48, 64, CV_8UC3, cv::Scalar(90, 120, 150));
    cv::imwrite((folder_ / "photo.png").string(), image);
  }

  std::vector<std::string> Arguments(const std::string& camera, const std::string& box) const {
    return {"photo", (folder_ / "photo.png").string(), "--camera", camera, "--box", box,
            "--out", (folder_ / "out.png").string()};
  }

  void ExpectRefused(const std::string& camera, const std::string& box, const std::vector<std::string>& texts,
                     const std::vector<std::string>& more = {}) const {
    const std::set<std::string> before = AllFiles(folder_.path());
    std::vector<std::string> arguments = Arguments(camera, box);
    arguments.insert(arguments.end(), more.begin(), more.end());
    ExpectBadInput(arguments, texts);
    EXPECT_EQ(AllFiles(folder_.path()), before);
  }

  testing::TempFolder folder_;
  const std::string camera_ = "60,60,31.5,23.5", box_ = "chair,5,6,20,30";
};

TEST_F(AppPhotoInput, AnObjectThatIsNotFoundHasARowWithoutNumbers) {
  const ProgramResult result = RunOk(Arguments(camera_, box_ + ",-30"));
  EXPECT_NE(result.out.find("too_few_edges"), std::string::npos) << result.out;
  EXPECT_NE(result.out.find("0 of 11"), std::string::npos) << result.out;
  EXPECT_TRUE(std::filesystem::exists(folder_ / "out.png"));
}

TEST_F(AppPhotoInput, TakesALensAndADirectionWithALeadingMinus) {
  std::vector<std::string> arguments = Arguments(camera_, "table,-5,6,20,30");
  arguments.insert(arguments.end(), {"--distortion", "-0.1,0.01,0,0,0", "--up", "-0.1,-1,0"});
  RunOk(arguments);
}

TEST_F(AppPhotoInput, BadBoxes) {
  ExpectRefused(camera_, "sofa,5,6,20,30", {"--box", "sofa", "chair"});
  ExpectRefused(camera_, "chair,5,6,20", {"--box", "4 values", "category,x,y,width,height"});
  ExpectRefused(camera_, "chair,5,6,20,30,1,2", {"--box", "7 values"});
  ExpectRefused(camera_, "chair,5,six,20,30", {"--box", "six"});
  ExpectRefused(camera_, "chair,5,inf,20,30", {"--box", "inf"});
  ExpectRefused(camera_, "chair,5,6,0,30", {"--box", "greater than 0"});
  ExpectRefused(camera_, "chair,64,6,20,30", {"--box", "outside", "64 x 48"});
}

TEST_F(AppPhotoInput, BadCameras) {
  ExpectRefused("60,60,31.5", box_, {"--camera", "fx,fy,cx,cy"});
  ExpectRefused("60,0,31.5,23.5", box_, {"--camera", "greater than 0"});
  ExpectRefused(camera_, box_, {"--distortion", "k1,k2,p1,p2,k3"}, {"--distortion", "0.1"});
  ExpectRefused(camera_, box_, {"--up", "x,y,z"}, {"--up", "0,-1"});
  ExpectRefused(camera_, box_, {"--up", "length"}, {"--up", "0,0,0"});
}

TEST_F(AppPhotoInput, BadFiles) {
  folder_.Write("text.png", "not an image");
  const std::string text = folder_ / "text.png", photo = folder_ / "photo.png", out = folder_ / "out.png";
  ExpectBadInput({"photo", text, "--camera", camera_, "--box", box_, "--out", out}, {"text.png"});
  ExpectBadInput({"photo", "absent.png", "--camera", camera_, "--box", box_, "--out", out}, {"absent.png"});
  ExpectBadInput({"photo", photo, "--camera", camera_, "--box", box_, "--out", folder_ / "out.gif"},
                 {"out.gif"});
  ExpectBadInput({"photo", photo, "--camera", camera_, "--box", box_, "--out", text + "/out.png"},
                 {"text.png"});
  ExpectBadInput({"photo", photo, "--camera", camera_, "--out", out}, {"--box"});
  EXPECT_FALSE(std::filesystem::exists(out));
}

TEST(AppPhoto, PlacesFurnitureOfARealPhotograph) {
  ARMATURE_SHARED_DATA_OR_SKIP(photo, "photos/sunrgbd_total3d_3/img.jpg");
  const TempFolder folder;
  const ProgramResult result = RunOk({"photo", photo, "--camera", "529.5,529.5,365,265", "--box",
                                      "table,0,122,297,292,-50", "--out", folder / "out.png", "--json"});
  const auto table = nlohmann::json::parse(result.out)["objects"][0];
  EXPECT_EQ(table["status"], "ok");
  EXPECT_NEAR(table["distance_m"], 2.4, 0.5);
}

}  // namespace
}  // namespace armature
