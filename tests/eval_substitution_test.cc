// SPDX-License-Identifier: BSD-3-Clause
// Parts of a sequence that are replaced by the truth.
#include <gtest/gtest.h>

#include "eval/budget/substitution.h"
#include "eval/budget/true_models.h"
#include "io/sequence.h"
#include "support/expect_input_error.h"
#include "support/substitution_world.h"

namespace armature {
namespace {

using testing::ExpectInputError;
using testing::SubstitutionWorld;
using Truth = SubstitutedTruth;

class Substitution : public ::testing::Test {
 protected:
  SubstitutedFiles Give(Truth truth) const {
    return SubstituteTruth(world_.sequence_folder(), truth, world_.models);
  }
  // A file as a reader of files sees it.
  std::filesystem::path Kept(const SubstitutedFiles& files, const std::string& name) const {
    return world_.folder.Write("kept/" + name, files.at(name));
  }
  std::vector<TimedPose> OdometryOf(const SubstitutedFiles& files) const {
    return ReadTumTrajectory(Kept(files, "odometry.txt"));
  }

  SubstitutionWorld world_;
};

TEST_F(Substitution, OdometryGetsTheTrueScaleAndSaysThatItIsMetric) {
  const SubstitutedFiles files = Give(Truth::kScale);
  EXPECT_EQ(files.size(), 2u);
  const auto odometry = OdometryOf(files);
  ASSERT_EQ(odometry.size(), 2u);
  EXPECT_NEAR((odometry[1].pose.translation() - odometry[0].pose.translation()).x(), 0.2, 1e-9);
  const SequenceSettings settings = ReadSequenceSettings(Kept(files, "sequence.yaml"));
  EXPECT_TRUE(settings.odometry_metric);
  EXPECT_EQ(settings.name, "world");
  EXPECT_EQ(settings.camera.fx, 500);
  ASSERT_TRUE(settings.up);
  EXPECT_EQ(settings.up->y(), -1);
}

TEST_F(Substitution, ACameraThatHardlyMovesGetsNoScale) {
  world_.folder.Write("sequence/groundtruth.txt", "0.0 1 2 3 0 0 0 1\n0.2 1 2.01 3 0 0 0 1\n");
  EXPECT_TRUE(Give(Truth::kScale).empty());
}

TEST_F(Substitution, TrueCamerasAreOdometryInItsFrame) {
  world_.folder.Write("sequence/odometry.txt", "0.0 5 0 0 0 0 0.6 0.8\n0.2 5.1 0 0 0 0 0.6 0.8\n");
  const SubstitutedFiles files = Give(Truth::kCameras);
  const auto odometry = OdometryOf(files);
  ASSERT_EQ(odometry.size(), 2u);
  EXPECT_LT((odometry[0].pose.translation() - Eigen::Vector3d(5, 0, 0)).norm(), 1e-8);
  const Eigen::Isometry3d moved = odometry[0].pose.inverse() * odometry[1].pose;
  EXPECT_LT((moved.translation() - Eigen::Vector3d(0.2, 0, 0)).norm(), 1e-8);
  EXPECT_TRUE(moved.linear().isIdentity(1e-8));
  EXPECT_TRUE(ReadSequenceSettings(Kept(files, "sequence.yaml")).odometry_metric);
}

TEST_F(Substitution, WithoutOdometryTheFirstTrueCameraIsTheOrigin) {
  world_.folder.Write("sequence/groundtruth.txt", "0.0 1 2 3 0 0 0 1\n0.2 1 2.5 3 0 0 0 1\n");
  std::filesystem::remove(world_.folder / "sequence/odometry.txt");
  const auto odometry = OdometryOf(Give(Truth::kCameras));
  EXPECT_TRUE(odometry.at(0).pose.isApprox(Eigen::Isometry3d::Identity(), 1e-9));
  EXPECT_NEAR(odometry.at(1).pose.translation().y(), 0.5, 1e-9);
}

TEST_F(Substitution, OneRightDetectionOfEachObjectAnImageIsLeft) {
  const SubstitutedFiles files = Give(Truth::kDetections);
  EXPECT_EQ(files.at("detections.csv"),
            "timestamp,category,x,y,width,height,score,azimuth_deg,elevation_deg,tilt_deg\n"
            "0.0,chair,150,150,100,180,0.9,,,\n"
            "0.0,table,330,160,210,160,0.8,1,2,3\n"
            "0.2,chair,120,150,100,180,0.9,10,20,0\n"
            "0.2,table,300,160,210,160,0.8,,,\n");
  EXPECT_EQ(files.at("detections_gt.csv"),
            "timestamp,index,id\n0.0,0,chair0\n0.0,1,table0\n0.2,0,chair0\n0.2,1,table0\n");
  EXPECT_EQ(files.size(), 2u);
}

TEST_F(Substitution, ViewpointsOfRightDetectionsAreTrueAlongTheRayOfTheBox) {
  const SubstitutedFiles files = Give(Truth::kViewpoints);
  const auto images = ReadImageList(world_.folder / "sequence/rgb.txt");
  const Camera& camera = world_.sequence.camera;
  const auto detections = ReadDetections(Kept(files, "detections.csv"), images, camera, {"chair", "table"});
  ASSERT_EQ(detections.at(1).size(), 5u);
  const GroundTruth truth = LoadGroundTruth(world_.sequence_folder());
  for (const auto& [image, index] : {std::pair<size_t, size_t>{0, 0}, {0, 1}, {1, 1}, {1, 2}, {1, 4}}) {
    const Detection& detection = detections[image][index];
    const auto T_camera_object =
        truth.TrueCameraObject(images[image].timestamp, static_cast<int>(index)).value();
    const Eigen::Matrix3d R = RotationFromViewpoint(
        {detection.azimuth.value(), detection.elevation.value(), detection.tilt.value()},
        camera.Ray(detection.box.center()));
    EXPECT_TRUE(R.isApprox(T_camera_object.linear(), 1e-5)) << image << " " << index;
  }
  EXPECT_NEAR(*detections[1][0].azimuth, 4 * kDegree, 1e-9) << "of a false alarm";
  EXPECT_NEAR(*detections[1][3].azimuth, 7 * kDegree, 1e-9) << "of a table taken for a chair";
}

TEST_F(Substitution, LinesAreTheVisiblePartsOfEdges) {
  EXPECT_EQ(Give(Truth::kLines).at("segments.csv"),
            "timestamp,x1,y1,x2,y2\n"
            "0.000000,100.00,100.00,140.00,100.00\n"
            "0.000000,110.00,200.00,130.00,200.00\n"
            "0.200000,300.00,200.00,300.00,260.00\n");
}

TEST_F(Substitution, EachObjectIsACategoryOfItsOwn) {
  const SubstitutedFiles files = Give(Truth::kIdentities);
  EXPECT_EQ(files.at("detections.csv").substr(files.at("detections.csv").find('\n') + 1),
            "0.0,chair0,150,150,100,180,0.9,,,\n"
            "0.0,table0,330,160,210,160,0.8,1,2,3\n"
            "0.2,chair0,120,150,100,180,0.9,10,20,0\n"
            "0.2,table0,300,160,210,160,0.8,,,\n");
  for (const auto& [name, content] : files) Kept(files, name);
  const auto models = LoadCategories(world_.folder / "kept/categories");
  ASSERT_EQ(models.size(), 2u);
  CategoryModel model = models[1];
  EXPECT_EQ(model.spec.name, "table0");
  EXPECT_EQ(model.mean, LookUpModel(world_.models, "table").mean);
  EXPECT_EQ(model.spec.size_sigma, LookUpModel(world_.models, "table").spec.size_sigma);
  world_.folder.Write("kept/groundtruth.txt", testing::ReadFile(world_.folder / "sequence/groundtruth.txt"));
  const GroundTruth truth = LoadGroundTruth(world_.folder / "kept");
  EXPECT_EQ(truth.objects.at(1).category, "table0");
  EXPECT_EQ(truth.objects[1].size, Eigen::Vector3d(1.2, 0.74, 0.6));
  EXPECT_EQ(truth.FindObject(0.2, 1), &truth.objects[1]);
}

TEST_F(Substitution, ModelsGetTheSizeOfTheirObjectsAndHardlyVary) {
  const SubstitutedFiles files = Give(Truth::kShapes);
  for (const auto& [name, content] : files) Kept(files, name);
  const CategoryModel sized = LoadCategory(world_.folder / "kept/categories/table0.yaml");
  const CategoryModel& of_all = LookUpModel(world_.models, "table");
  const Eigen::Vector3d size = BoundingBoxSize(WireframeFromVector(sized.mean)) + 2 * sized.spec.padding;
  EXPECT_LT((size - Eigen::Vector3d(1.2, 0.74, 0.6)).norm(), 1e-8);
  EXPECT_TRUE(sized.standard_deviations.isApprox(0.01 * of_all.standard_deviations, 1e-6));
  EXPECT_NEAR(sized.spec.size_sigma, 0.01 * of_all.spec.size_sigma, 1e-9);
  ASSERT_EQ(sized.dictionary.size(), 1u);
  EXPECT_EQ(sized.dictionary[0].norm(), 0);
}

TEST_F(Substitution, BadInputNamesTheFileAndTheTruthThatCannotBeGiven) {
  const auto without = [&](const char* file, Truth truth, const char* name) {
    const SubstitutionWorld other;
    std::filesystem::remove(other.folder / "sequence" / file);
    ExpectInputError([&] { SubstituteTruth(other.sequence_folder(), truth, other.models); },
                     {file, std::string("'") + name + "'"});
  };
  without("groundtruth.txt", Truth::kScale, "scale");
  without("odometry.txt", Truth::kScale, "scale");
  without("groundtruth.txt", Truth::kCameras, "cameras");
  without("detections_gt.csv", Truth::kDetections, "detections");
  without("objects_gt.csv", Truth::kShapes, "shapes");
  without("edges_gt.csv", Truth::kLines, "lines");
}

TEST_F(Substitution, BadInput) {
  world_.folder.Write("sequence/odometry.txt", "70 5 0 0 0 0 0 1\n71 5 0 0 0 0 0 1\n");
  ExpectInputError([&] { Give(Truth::kScale); }, {"odometry.txt", "groundtruth.txt"});
  ExpectInputError([&] { Give(Truth::kCameras); }, {"odometry.txt", "groundtruth.txt"});
  const auto named = [&](const std::string& id, const std::string& category) {
    world_.folder.Write("sequence/objects_gt.csv",
                        "id,category,instance,tx,ty,tz,qx,qy,qz,qw,size_x,size_y,size_z\n" + id + "," +
                            category + ",,0,0,3,0,0,0,1,1,1,1\n");
    world_.folder.Write("sequence/detections_gt.csv", "timestamp,index,id\n0.0,0," + id + "\n");
    std::filesystem::remove(world_.folder / "sequence/edges_gt.csv");
  };
  named("my chair", "chair");
  ExpectInputError([&] { Give(Truth::kIdentities); }, {"objects_gt.csv:2", "'my chair'", "letters"});
  EXPECT_NO_THROW(Give(Truth::kDetections));
  named("sofa", "sofa");
  ExpectInputError([&] { Give(Truth::kShapes); }, {"objects_gt.csv:2", "sofa"});
  named("chair0", "chair");
  world_.folder.Write("sequence/rgb.txt", "0.0 -\n");
  ExpectInputError([&] { Give(Truth::kDetections); }, {"detections.csv:4", "rgb.txt"});
}

}  // namespace
}  // namespace armature
