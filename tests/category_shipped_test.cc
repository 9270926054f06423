// SPDX-License-Identifier: BSD-3-Clause
// The category models that are shipped, and the annotated models they come from.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "category/learn.h"
#include "category/normalise.h"
#include "datasets/cad/families.h"
#include "io/annotations.h"
#include "io/category_yaml.h"
#include "io/training_models.h"
#include "support/category_examples.h"
#include "support/shared_data.h"

namespace armature {
namespace {

using testing::CategoryFolder;

std::vector<CategoryModel> Shipped() { return LoadCategories(CategoryFolder()); }

// The shapes to check of a model: its mean and its dictionary.
std::vector<Wireframe> Shapes(const CategoryModel& model) {
  std::vector<Wireframe> shapes = {WireframeFromVector(model.mean)};
  for (const Eigen::VectorXd& entry : model.dictionary)
    shapes.push_back(WireframeFromCoefficients(model, entry));
  return shapes;
}

int Edge(const CategoryModel& model, const std::string& name) {
  const auto& names = model.spec.edge_names;
  return static_cast<int>(std::find(names.begin(), names.end(), name) - names.begin());
}

TEST(ShippedModels, BaseEdgesSpanAnUpwardNormal) {
  for (const CategoryModel& model : Shipped()) {
    for (const Wireframe& shape : Shapes(model)) {
      const Eigen::Vector3d first = shape.directions.col(model.spec.base_edges[0]);
      const Eigen::Vector3d second = shape.directions.col(model.spec.base_edges[1]);
      EXPECT_GT(first.cross(second).normalized().y(), 0.95) << model.spec.name;
    }
  }
}

TEST(ShippedModels, AreCentredInMetresAndOfPlausibleSize) {
  for (const CategoryModel& model : Shipped()) {
    const TrainingSpec spec = LoadTrainingSpec(CategoryFolder() / "specs" / (model.spec.name + ".yaml"));
    for (const Wireframe& shape : Shapes(model)) {
      EXPECT_TRUE(spec.plausible.Contains(BoundingBoxSize(shape))) << model.spec.name;
      EXPECT_LT(BoundingBoxCenter(shape).norm(), 0.03) << model.spec.name;
    }
    // The mean's lowest end is a leg's, the training models' lowest of four: a few millimetres apart.
    EXPECT_NEAR(Measure(model.spec.reference, Shapes(model)[0]), model.spec.reference.metres, 0.01);
  }
}

TEST(ShippedModels, FacesAreFlatAndNamedEdgesMeetAtTheirCorners) {
  for (const CategoryModel& model : Shipped()) {
    const Wireframe mean = WireframeFromVector(model.mean);
    for (const Face& face : model.spec.faces) {
      ASSERT_EQ(face.corners.size(), 4u);
      std::vector<Eigen::Vector3d> corners;
      for (const EdgeEnd& corner : face.corners) corners.push_back(mean.End(corner.edge, corner.end));
      const Eigen::Vector3d across = corners[2] - corners[0];
      const Eigen::Vector3d normal = across.cross(corners[3] - corners[1]).normalized();
      EXPECT_LT(std::abs(normal.dot(corners[1] - corners[0])), 0.02) << model.spec.name << " " << face.name;
    }
  }
}

TEST(ShippedModels, ExplainTheirTrainingModels) {
  for (const CategoryModel& model : Shipped()) {
    EXPECT_EQ(model.dictionary.size(), 4u);
    EXPECT_GT(ExplainedVariance(model).sum(), 0.9) << model.spec.name;
    EXPECT_LE(model.modes(), 7);
    EXPECT_FALSE(model.source.empty());
  }
}

TEST(ShippedModels, ChairFacesForward) {
  const CategoryModel chair = LoadCategory(CategoryFolder() / "chair.yaml");
  for (const Wireframe& shape : Shapes(chair)) {
    EXPECT_LT(shape.midpoints(2, Edge(chair, "back_top")), -0.1);
    EXPECT_GT(shape.midpoints(1, Edge(chair, "back_top")), 0.1);
    EXPECT_GT(shape.End(Edge(chair, "leg_front_left"), 1).z(), 0.1);
    EXPECT_LT(shape.End(Edge(chair, "leg_rear_left"), 1).z(), -0.1);
    EXPECT_LT(shape.midpoints(0, Edge(chair, "leg_front_left")), -0.1);
    EXPECT_GT(shape.midpoints(0, Edge(chair, "leg_front_right")), 0.1);
  }
}

TEST(ShippedModels, LaptopScreenFacesForwardAndTableIsWiderThanDeep) {
  const CategoryModel laptop = LoadCategory(CategoryFolder() / "laptop.yaml");
  const Wireframe mean = WireframeFromVector(laptop.mean);
  EXPECT_GT(mean.midpoints(2, Edge(laptop, "base_front")), mean.midpoints(2, Edge(laptop, "hinge")) + 0.15);
  EXPECT_GT(mean.midpoints(1, Edge(laptop, "screen_top")), mean.midpoints(1, Edge(laptop, "hinge")) + 0.15);
  EXPECT_FALSE(laptop.spec.stands_on_floor);
  const CategoryModel table = LoadCategory(CategoryFolder() / "table.yaml");
  const Eigen::Vector3d size = BoundingBoxSize(WireframeFromVector(table.mean));
  EXPECT_GT(size.x(), size.z());
  EXPECT_EQ(table.spec.symmetry_order, 2);
  EXPECT_TRUE(table.spec.stands_on_floor);
}

// The shipped model written in text, with the source as shipped.
void ExpectReproduced(const TrainingSpec& spec, const TrainingModels& models) {
  const CategoryModel shipped = LoadCategory(CategoryFolder() / (spec.category.name + ".yaml"));
  const CategoryModel learnt = LearnCategory(spec, models.wireframes, shipped.source);
  EXPECT_EQ(learnt.training_models, shipped.training_models);
  EXPECT_LT((learnt.mean - shipped.mean).norm(), 1e-7);
  EXPECT_LT((learnt.basis - shipped.basis).norm(), 1e-6);
  EXPECT_LT((learnt.standard_deviations - shipped.standard_deviations).norm(), 1e-7);
  ASSERT_EQ(learnt.dictionary.size(), shipped.dictionary.size());
  for (size_t i = 0; i < learnt.dictionary.size(); ++i) {
    EXPECT_LT((learnt.dictionary[i] - shipped.dictionary[i]).norm(), 1e-5);
  }
}

TEST(ShippedModels, TablesAndLaptopsAreLearntFromTheirFamilies) {
  for (const char* name : {"table", "laptop"}) {
    const TrainingSpec spec = LoadTrainingSpec(CategoryFolder() / "specs" / (std::string(name) + ".yaml"));
    ExpectReproduced(spec, FamilyTrainingModels(spec, {name, 2000, 1}, SampleFamily({name, 2000, 1})));
  }
}

TEST(ShippedModels, ChairIsLearntFromTheAnnotatedChairs) {
  ARMATURE_SHARED_DATA_OR_SKIP(table, "cad/keypointnet_chair_kp10.csv");
  const TrainingSpec spec = LoadTrainingSpec(CategoryFolder() / "specs" / "chair.yaml");
  ExpectReproduced(spec, AnnotatedTrainingModels(spec, {table, "keypointnet_chair"}));
}

// Share of variance in the first seven modes of all models as they are annotated, in their own unit.
double VarianceAsAnnotated(const std::string& category, const std::filesystem::path& file,
                           const std::string& format, bool unit_directions) {
  TrainingSpec spec = LoadTrainingSpec(CategoryFolder() / "specs" / (category + ".yaml"));
  spec.mirrored = false;
  std::vector<Wireframe> wireframes;
  for (AnnotatedModel& model : ReadAnnotations(file, format, spec.category)) {
    if (unit_directions) model.wireframe.directions.colwise().normalize();
    wireframes.push_back(model.wireframe);
  }
  return ExplainedVariance(LearnCategory(spec, wireframes, "")).sum();
}

TEST(AnnotatedModels, SevenModesHoldThePublishedVarianceOfChairs) {
  ARMATURE_SHARED_DATA_OR_SKIP(file, "cad/keypointnet_chair_kp10.csv");
  EXPECT_NEAR(VarianceAsAnnotated("chair", file, "keypointnet_chair", false), 0.92, 0.005);
  EXPECT_NEAR(VarianceAsAnnotated("chair", file, "keypointnet_chair", true), 0.84, 0.005);
}

TEST(AnnotatedModels, SevenModesHoldThePublishedVarianceOfTables) {
  ARMATURE_SHARED_DATA_OR_SKIP(file, "cad/shapeassembly_table_kp12.csv");
  EXPECT_NEAR(VarianceAsAnnotated("table", file, "shapeassembly_table", false), 0.99, 0.005);
}

TEST(AnnotatedModels, LaptopsFaceForward) {
  ARMATURE_SHARED_DATA_OR_SKIP(file, "cad/modelnet40_laptop_autokp6.csv");
  const CategorySpec spec = LoadCategorySpec(CategoryFolder() / "specs" / "laptop.yaml");
  const std::vector<AnnotatedModel> models = ReadAnnotations(file, "modelnet_laptop", spec);
  EXPECT_EQ(models.size(), 132u);
  for (const AnnotatedModel& model : models) {
    EXPECT_GT(model.wireframe.directions(0, 2), 0) << model.id;  // hinge, to the right
    EXPECT_GT(model.wireframe.midpoints(2, 5), model.wireframe.midpoints(2, 2))
        << model.id;  // front before hinge
  }
}

}  // namespace
}  // namespace armature
