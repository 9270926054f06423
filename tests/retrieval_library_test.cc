// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "category/normalise.h"
#include "support/frame_library.h"

namespace armature {
namespace {

using testing::FrameInstances;
using testing::FrameModel;
using testing::MetricFrame;
using testing::SomeCoefficients;

CategoryInstances MakeLibrary(const CadModel& cad) {
  return BuildLibrary({FrameModel()}, {cad}, "").categories.at(0);
}

// The same frame in another unit and place.
CadModel UnscaledFrame() {
  CadModel cad = MetricFrame("unscaled", Eigen::Vector3d(1.5, -0.5, 0.7));
  const Eigen::Vector3d shift(1, 2, -3);
  cad.metric = false;
  cad.wireframe.midpoints = (3 * cad.wireframe.midpoints).colwise() + shift;
  cad.wireframe.directions *= 3;
  cad.box_min = 3 * cad.box_min + shift;
  cad.box_max = 3 * cad.box_max + shift;
  return cad;
}

TEST(InstanceLibrary, CoefficientsComeBack) {
  const Eigen::Vector3d coefficients(1.5, -0.5, 0.7);
  const CadModel cad = MetricFrame("f", coefficients);
  const CategoryInstances instances = MakeLibrary(cad);
  EXPECT_LT((instances.coefficients.col(0).cast<double>() - coefficients).norm(), 1e-5);
  EXPECT_LT((instances.MakeWireframe(0).midpoints - cad.wireframe.midpoints).norm(), 1e-6);
  EXPECT_LT((instances.MakeWireframe(0).directions - cad.wireframe.directions).norm(), 1e-6);
  EXPECT_EQ(instances.size_sigmas(0), 0);
  EXPECT_EQ(instances.ids, std::vector<std::string>{"f"});
  EXPECT_EQ(instances.category, "frame");
}

TEST(InstanceLibrary, SizesAreThoseOfTheCadModel) {
  const CadModel cad = MetricFrame("f", Eigen::Vector3d(1, 1, 1));
  EXPECT_TRUE(MakeLibrary(cad).sizes.col(0).cast<double>().isApprox(cad.box_max - cad.box_min, 1e-6));
}

TEST(InstanceLibrary, MetricModelsAreOnlyCentred) {
  CadModel cad = MetricFrame("f", Eigen::Vector3d(2, 0, 0));
  cad.wireframe.midpoints.colwise() += Eigen::Vector3d(5, 6, 7);
  const CategoryInstances instances = MakeLibrary(cad);
  EXPECT_NEAR(instances.coefficients(0, 0), 2, 1e-5) << "as wide as it is, whatever the reference says";
  EXPECT_LT(BoundingBoxCenter(instances.MakeWireframe(0)).norm(), 1e-6);
}

TEST(InstanceLibrary, OthersAreBroughtToMetres) {
  const CadModel cad = UnscaledFrame();
  const CategoryModel model = FrameModel();
  const CategoryInstances instances = MakeLibrary(cad);
  const Wireframe expected = Normalised(model.spec.reference, cad.wireframe);
  EXPECT_NEAR(instances.MakeWireframe(0).directions.col(2).norm(), 1, 1e-6) << "the reference";
  EXPECT_LT((instances.edges.col(0).cast<double>() - ShapeVector(expected)).norm(), 1e-6);
  EXPECT_LT(
      (instances.coefficients.col(0).cast<double>() - CoefficientsFromWireframe(model, expected)).norm(),
      1e-5);
  const double scale = 1 / cad.wireframe.directions.col(2).norm();
  EXPECT_TRUE(instances.sizes.col(0).cast<double>().isApprox(scale * (cad.box_max - cad.box_min), 1e-6));
  EXPECT_EQ(instances.size_sigmas(0), static_cast<float>(kUnscaledSizeSigma));
}

TEST(InstanceLibrary, SurfacesComeAlongIntoTheObjectsFrame) {
  CadModel cad = UnscaledFrame();
  cad.T_annotation_geometry = Eigen::Translation3d(0.3, 0.2, 0.1) *
                              Eigen::AngleAxisd(1.2, Eigen::Vector3d(1, 2, 3).normalized()) *
                              Eigen::Scaling(0.01);
  const CategoryInstances instances = MakeLibrary(cad);
  const Eigen::Affine3d T_geometry_annotation = cad.T_annotation_geometry->inverse();
  for (int edge = 0; edge < 3; ++edge) {
    for (const int end : {0, 1}) {
      const Eigen::Vector3d on_surface = T_geometry_annotation * cad.wireframe.End(edge, end);
      EXPECT_LT((instances.MakeTransform(0) * on_surface - instances.MakeWireframe(0).End(edge, end)).norm(),
                1e-4);
    }
  }
}

TEST(InstanceLibrary, ASurfaceWithoutFrameIsLeftOut) {
  CadModel cad = MetricFrame("f", Eigen::Vector3d::Zero());
  EXPECT_EQ(MakeLibrary(cad).geometries.front(), "mesh/f.ply");
  cad.T_annotation_geometry.reset();
  EXPECT_EQ(MakeLibrary(cad).geometries.front(), "");
}

TEST(InstanceLibrary, ModelsWithoutSizeAreLeftOut) {
  CadModel flat = UnscaledFrame();
  flat.wireframe.directions.col(2).setZero();
  const InstanceLibrary library =
      BuildLibrary({FrameModel()}, {flat, MetricFrame("f", Eigen::Vector3d(1, 0, 0))}, "");
  EXPECT_EQ(library.categories.at(0).ids, std::vector<std::string>{"f"});
  EXPECT_NEAR(library.categories.at(0).coefficients(0, 0), 1, 1e-5);
  EXPECT_EQ(library.categories.at(0).sizes.cols(), 1);
  EXPECT_TRUE(BuildLibrary({FrameModel()}, {flat}, "").categories.empty());
}

TEST(InstanceLibrary, HasTheCategoriesThatThereAreModelsAndInstancesOf) {
  CategoryModel gate = FrameModel(), door = FrameModel();
  gate.spec.name = "gate";
  door.spec.name = "door";
  CadModel a_gate = MetricFrame("g", Eigen::Vector3d::Zero()), a_sofa = a_gate;
  a_gate.category = "gate";
  a_sofa.category = "sofa";
  const InstanceLibrary library = BuildLibrary(
      {gate, door, FrameModel()}, {MetricFrame("f", Eigen::Vector3d::Zero()), a_gate, a_sofa}, "here");
  ASSERT_EQ(library.categories.size(), 2);
  EXPECT_EQ(library.Of("gate")->ids, std::vector<std::string>{"g"});
  EXPECT_EQ(library.Of("frame")->ids, std::vector<std::string>{"f"});
  EXPECT_EQ(library.Of("door"), nullptr);
  EXPECT_EQ(library.Of("sofa"), nullptr);
  EXPECT_EQ(library.root, "here");
}

TEST(InstanceLibrary, FindsByName) {
  const CategoryInstances instances = FrameInstances(Eigen::MatrixXd::Zero(3, 4));
  EXPECT_EQ(instances.Find("f2"), 2);
  EXPECT_EQ(instances.Find("f9"), -1);
}

TEST(InstanceLibrary, WithoutSomeTheOthersStayAsTheyAre) {
  const CategoryInstances all = FrameInstances(SomeCoefficients(5));
  const CategoryInstances rest = Without(all, {3, 0});
  EXPECT_EQ(rest.ids, (std::vector<std::string>{"f1", "f2", "f4"}));
  EXPECT_EQ(rest.geometries.back(), "mesh/f4.ply");
  EXPECT_EQ(rest.model_checksum, all.model_checksum);
  EXPECT_EQ(rest.category, all.category);
  for (const auto& [now, before] : {std::pair(0, 1), std::pair(1, 2), std::pair(2, 4)}) {
    EXPECT_EQ(rest.coefficients.col(now), all.coefficients.col(before));
    EXPECT_EQ(rest.sizes.col(now), all.sizes.col(before));
    EXPECT_EQ(rest.edges.col(now), all.edges.col(before));
    EXPECT_EQ(rest.size_sigmas(now), all.size_sigmas(before));
    EXPECT_EQ(rest.T_object_geometry.col(now), all.T_object_geometry.col(before));
  }
  EXPECT_EQ(Without(all, {0, 1, 2, 3, 4}).size(), 0);
}

TEST(ModelChecksum, IsOfWhatCoefficientsDependOn) {
  const CategoryModel model = FrameModel();
  const std::uint64_t sum = ModelChecksum(model);
  EXPECT_EQ(ModelChecksum(FrameModel()), sum);
  CategoryModel other = model;
  other.mean(4) += 1e-9;
  EXPECT_NE(ModelChecksum(other), sum);
  other = model;
  other.basis.col(1) *= -1;
  EXPECT_NE(ModelChecksum(other), sum);
  other = model;
  other.standard_deviations(2) *= 1.001;
  EXPECT_NE(ModelChecksum(other), sum);
  other = model;
  std::swap(other.spec.edge_names[0], other.spec.edge_names[1]);
  EXPECT_NE(ModelChecksum(other), sum);
  other = model;
  other.source = "elsewhere";
  EXPECT_EQ(ModelChecksum(other), sum);
}

}  // namespace
}  // namespace armature
