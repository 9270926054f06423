// SPDX-License-Identifier: BSD-3-Clause
// Collections of CAD models in miniature: generated ones, and published tables of key points.
#include <gtest/gtest.h>

#include <algorithm>

#include "io/annotation_tables.h"
#include "io/cad_folder.h"
#include "io/category_yaml.h"
#include "support/category_examples.h"
#include "support/expect_input_error.h"
#include "support/small_cad.h"

namespace armature {
namespace {

using testing::ExpectInputError;
using testing::WriteInstances;

class CadFolder : public ::testing::Test {
 protected:
  CadFolder() {
    for (const CategoryModel& model : LoadCategories(testing::CategoryFolder())) specs_.push_back(model.spec);
  }
  std::vector<CadModel> Read() const { return ReadCadFolder(folder_.path(), specs_); }
  void ExpectRefused(const std::vector<std::string>& texts) const {
    ExpectInputError([&] { Read(); }, texts);
  }

  testing::TempFolder folder_;
  std::vector<CategorySpec> specs_;
};

// --- Generated ones

class GeneratedCadFolder : public CadFolder {
 protected:
  GeneratedCadFolder() {
    testing::WriteSmallCad(folder_, *std::find_if(specs_.begin(), specs_.end(), [](const CategorySpec& spec) {
                             return spec.name == "table";
                           }));
  }
};

TEST_F(GeneratedCadFolder, IsInMetresWithItsMeshes) {
  const std::vector<CadModel> models = Read();
  ASSERT_EQ(models.size(), 2);
  const CadModel& cad = models[0];
  EXPECT_EQ(cad.instance, "armature:table-0001");
  EXPECT_EQ(cad.category, "table");
  EXPECT_EQ(cad.geometry, "mesh/a.ply");
  EXPECT_TRUE(cad.metric);
  EXPECT_FALSE(cad.held_out);
  EXPECT_EQ(cad.box_max, Eigen::Vector3d(0.6, 0.35, 0.3));
  EXPECT_EQ(cad.box_min, -cad.box_max);
  EXPECT_TRUE(cad.T_annotation_geometry->isApprox(Eigen::Affine3d::Identity()));
  EXPECT_EQ(cad.wireframe.midpoints.col(3), Eigen::Vector3d(3, 0.5, 0));
}

TEST_F(GeneratedCadFolder, HeldOutOnesHaveAFileOfTheirOwn) {
  const CadModel cad = Read().at(1);
  EXPECT_EQ(cad.instance, "armature:table-0010");
  EXPECT_TRUE(cad.held_out);
  EXPECT_EQ(cad.wireframe.midpoints.col(3), Eigen::Vector3d(3.5, 0.5, 0));
}

TEST_F(GeneratedCadFolder, CategoriesWithoutSpecificationAreLeftOut) {
  WriteInstances(folder_, "table-0001,table,0,1.2,0.7,0.6,a\nsofa-0001,sofa,0,2,1,1,b\n");
  EXPECT_EQ(Read().size(), 1);
}

TEST_F(GeneratedCadFolder, BadInput) {
  WriteInstances(folder_, "table-0001,table,0,1.2,-0.7,0.6,a\n");
  ExpectRefused({"instances.csv:2", "size"});
  WriteInstances(folder_, "table-0001,table,yes,1.2,0.7,0.6,a\n");
  ExpectRefused({"instances.csv:2", "held_out", "yes"});
  WriteInstances(folder_, "table-0001,table,2,1.2,0.7,0.6,a\n");
  ExpectRefused({"instances.csv:2", "held_out", "2"});
  WriteInstances(folder_, "table-0001,table,0,1.2,0.7,0.6,a\ntable-0001,table,0,1.2,0.7,0.6,a\n");
  ExpectRefused({"instances.csv:3", "table-0001", "twice"});
  WriteInstances(folder_, "table-0010,table,0,1.2,0.7,0.6,a\n");
  ExpectRefused({"instances.csv:2", "table-0010", "table_edges.csv"});
  WriteInstances(folder_, "laptop-0001,laptop,0,0.3,0.2,0.2,a\n");
  ExpectRefused({"laptop_edges.csv"});
  folder_.Write("instances.csv", "id,category\ntable-0001,table\n");
  ExpectRefused({"instances.csv:1", "held_out"});
}

// --- Published tables

const AnnotationTable& TableOf(const std::string& format) {
  return *std::find_if(AnnotationTables().begin(), AnnotationTables().end(),
                       [&](const AnnotationTable& table) { return table.format == format; });
}

// The key points in the order in which the edges name them, the i-th at (scale i, i^2, -1).
std::string KeyPoints(const AnnotationTable& table, const std::string& id, double scale) {
  std::string header = table.id_column, row = id;
  if (!table.filter_column.empty()) {
    header += "," + table.filter_column;
    row += fmt::format(",{}", table.filter_value);
  }
  std::vector<std::string> points;
  for (const TableEdge& edge : table.edges) {
    for (const std::string& point : {edge.start, edge.end}) {
      if (std::find(points.begin(), points.end(), point) != points.end()) continue;
      const auto i = static_cast<double>(points.size());
      points.push_back(point);
      header += fmt::format(",{0}_x,{0}_y,{0}_z", point);
      row += fmt::format(",{},{},-1", scale * i, i * i);
    }
  }
  return header + "\n" + row + "\n";
}

std::string MakeRow(const std::string& table) { return table.substr(table.find('\n') + 1); }

TEST_F(CadFolder, ChairsTakeTheirBoxesFrameAndExtent) {
  folder_.Write("keypointnet_chair_kp10.csv", KeyPoints(TableOf("keypointnet_chair"), "abc", 1));
  folder_.Write("keypointnet_chair_boxes.txt",
                "abc 17 0.1 0.2 0.3  0.1 0.2 0.05  1 0 0 0 1 0 0 0 1\n"
                "abc 17 0.5 0.2 0.3  0.1 0.2 0.05  0 1 0 -1 0 0 0 0 1\n"  // lies on its side
                "other 18 9 9 9  1 1 1  1 0 0 0 1 0 0 0 1\n");
  const std::vector<CadModel> models = Read();
  ASSERT_EQ(models.size(), 1);
  const CadModel& chair = models[0];
  EXPECT_EQ(chair.instance, "keypointnet:abc");
  EXPECT_EQ(chair.category, "chair");
  EXPECT_EQ(chair.geometry, "keypointnet_chair_boxes.txt#abc");
  EXPECT_FALSE(chair.metric);
  EXPECT_FALSE(chair.held_out);
  // Half a turn about y: x and z change their signs.
  EXPECT_TRUE(chair.box_min.isApprox(Eigen::Vector3d(-0.7, 0, -0.35)));
  EXPECT_TRUE(chair.box_max.isApprox(Eigen::Vector3d(0, 0.4, -0.25)));
  EXPECT_TRUE((*chair.T_annotation_geometry * Eigen::Vector3d(1, 2, 3)).isApprox(Eigen::Vector3d(-1, 2, -3)));
  EXPECT_TRUE(chair.wireframe.End(0, 0).isApprox(Eigen::Vector3d(0, 0, 1))) << "the first key point";
}

TEST_F(CadFolder, TablesAreNamedByTheirSecondId) {
  folder_.Write("shapeassembly_table_kp12.csv", KeyPoints(TableOf("shapeassembly_table"), "17", 1));
  folder_.Write("shapeassembly_table_boxes.txt",
                "abc 17 1 2 3  0.5 0.5 0.5  1 0 0 0 1 0 0 0 1\n"
                "17 abc 9 9 9  0.5 0.5 0.5  1 0 0 0 1 0 0 0 1\n");
  const std::vector<CadModel> models = Read();
  ASSERT_EQ(models.size(), 1);
  EXPECT_EQ(models[0].instance, "shapeassembly:17");
  EXPECT_EQ(models[0].geometry, "shapeassembly_table_boxes.txt#17");
  EXPECT_TRUE(models[0].box_min.isApprox(Eigen::Vector3d(0.5, 1.5, 2.5)));
  EXPECT_TRUE(models[0].box_max.isApprox(Eigen::Vector3d(1.5, 2.5, 3.5)));
}

TEST_F(CadFolder, AMeshWithoutKnownFrameIsNamedButItsEdgesGiveTheSize) {
  folder_.Write("modelnet40_laptop_autokp6.csv", KeyPoints(TableOf("modelnet_laptop"), "l1.off", 1));
  EXPECT_EQ(Read().at(0).geometry, "") << "no mesh yet";
  folder_.Write("modelnet40_laptop/l1.off", "OFF\n");
  const CadModel laptop = Read().at(0);
  EXPECT_EQ(laptop.instance, "modelnet40:l1.off");
  EXPECT_EQ(laptop.geometry, "modelnet40_laptop/l1.off");
  EXPECT_FALSE(laptop.T_annotation_geometry);
  EXPECT_TRUE((laptop.box_max - laptop.box_min).isApprox(BoundingBoxSize(laptop.wireframe)));
  EXPECT_EQ(laptop.box_min.x(), 1) << "six points at z = -1, and x of the object is -z of the table";
  EXPECT_EQ(laptop.box_max.z(), 5) << "the last one's x";
}

TEST_F(CadFolder, ModelsWithoutBoxesTakeThatOfTheirEdges) {
  folder_.Write("keypointnet_chair_kp10.csv", KeyPoints(TableOf("keypointnet_chair"), "abc", 1));
  folder_.Write("keypointnet_chair_boxes.txt", "other 18 9 9 9  1 1 1  1 0 0 0 1 0 0 0 1\n");
  const CadModel chair = Read().at(0);
  EXPECT_EQ(chair.geometry, "");
  EXPECT_TRUE((chair.box_max - chair.box_min).isApprox(BoundingBoxSize(chair.wireframe)));
}

TEST_F(CadFolder, OfRowsWithOneNameTheLastCounts) {
  const AnnotationTable& table = TableOf("keypointnet_chair");
  folder_.Write("keypointnet_chair_kp10.csv", KeyPoints(table, "b", 1) + MakeRow(KeyPoints(table, "a", 1)) +
                                                  MakeRow(KeyPoints(table, "b", 2)));
  const std::vector<CadModel> models = Read();
  ASSERT_EQ(models.size(), 2);
  EXPECT_EQ(models[0].instance, "keypointnet:a");
  EXPECT_EQ(models[1].instance, "keypointnet:b");
  const auto width = [](const CadModel& cad) { return BoundingBoxSize(cad.wireframe).x(); };
  EXPECT_DOUBLE_EQ(width(models[1]), 2 * width(models[0]));
}

TEST_F(CadFolder, AllThatIsThereIsRead) {
  WriteInstances(folder_, "");
  for (const auto& [file, format] : {std::pair("keypointnet_chair_kp10.csv", "keypointnet_chair"),
                                     std::pair("shapeassembly_table_kp12.csv", "shapeassembly_table")})
    folder_.Write(file, KeyPoints(TableOf(format), "1", 1));
  EXPECT_EQ(Read().size(), 2);
  EXPECT_EQ(ReadCadFolder(folder_.path(), {}).size(), 0) << "no category, no model";
}

TEST_F(CadFolder, BadTables) {
  ExpectRefused({folder_.path(), "has no annotated CAD models", "instances.csv"});
  ExpectInputError([&] { ReadCadFolder(folder_ / "nowhere", specs_); },
                   {"nowhere", "has no annotated CAD models"});
  folder_.Write("keypointnet_chair_kp10.csv", KeyPoints(TableOf("keypointnet_chair"), "abc", 1));
  folder_.Write("keypointnet_chair_boxes.txt", "\nabc 17 1 2 3\n");
  ExpectRefused({"keypointnet_chair_boxes.txt:2", "15 numbers"});
  folder_.Write("keypointnet_chair_kp10.csv", "model_id,sane\nabc,1\n");
  ExpectRefused({"keypointnet_chair_"});
}

}  // namespace
}  // namespace armature
