// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "io/shape_evidence_csv.h"
#include "support/category_examples.h"
#include "support/expect_input_error.h"
#include "support/temp_folder.h"

namespace armature {
namespace {

using testing::ExpectInputError;
using testing::TempFolder;

MapObject Evident(const std::string& id, const Eigen::MatrixXd& information, const Eigen::VectorXd& vector) {
  static const CategoryModel model = testing::FrameModel();
  MapObject object;
  object.id = id;
  object.model = &model;
  object.evidence = {information, vector};
  return object;
}

const Eigen::Matrix3d kInformation{{4.5, -1.25, 0.5}, {-1.25, 1234.000001, 2}, {0.5, 2, 0}};

TEST(ShapeEvidenceCsv, IsTheLowerTriangleRowByRow) {
  EXPECT_EQ(ShapeEvidenceText({Evident("chair0", kInformation, Eigen::Vector3d(1, -2.5, 1e-9))}),
            "id,model,information,vector\n"
            "chair0," +
                fmt::format("{:016x}", ModelChecksum(testing::FrameModel())) +
                ",4.500000;-1.250000;1234.000001;0.500000;2.000000;0.000000,1.000000;-2.500000;0.000000\n");
}

TEST(ShapeEvidenceCsv, ComesBack) {
  const TempFolder folder;
  const Eigen::Vector2d vector(-0.5, 3);
  const Eigen::Matrix2d information{{2, 0.125}, {0.125, 8}};
  const auto file = folder.Write("shape_evidence.csv",
                                 ShapeEvidenceText({Evident("chair0", kInformation, Eigen::Vector3d(1, 2, 3)),
                                                    Evident("table0", information, vector)}));
  const std::map<std::string, StoredEvidence> read = ReadShapeEvidence(file);
  ASSERT_EQ(read.size(), 2);
  EXPECT_EQ(read.at("chair0").evidence.information, kInformation);
  EXPECT_EQ(read.at("chair0").evidence.vector, Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(read.at("table0").evidence.information, information);
  EXPECT_EQ(read.at("table0").evidence.vector, vector);
  EXPECT_EQ(read.at("table0").model_checksum, ModelChecksum(testing::FrameModel()));
}

TEST(ShapeEvidenceCsv, BadFiles) {
  const TempFolder folder;
  const auto expect_refused = [&](const std::string& content, const std::vector<std::string>& texts) {
    const auto file = folder.Write("shape_evidence.csv", content);
    ExpectInputError([&] { ReadShapeEvidence(file); }, texts);
  };
  const std::string header = "id,model,information,vector\n", sum = "0123456789abcdef,";
  ExpectInputError([&] { ReadShapeEvidence(folder / "nowhere.csv"); }, {"nowhere.csv", "cannot be opened"});
  expect_refused("id,model,vector\nchair0,0,1\n", {"shape_evidence.csv:1", "information"});
  expect_refused(header + "chair0," + sum + "1;2;3,1\n",
                 {"shape_evidence.csv:2", "3 numbers", "with 1", "armature run"});
  expect_refused(header + "chair0," + sum + "1;two;3,1;2\n",
                 {"shape_evidence.csv:2", "information", "'two'"});
  expect_refused(header + "chair0," + sum + "1;2;3,1;nan\n", {"shape_evidence.csv:2", "vector", "'nan'"});
  expect_refused(header + "chair0," + sum + "1;;3,1;2\n", {"shape_evidence.csv:2", "information", "''"});
  expect_refused(header + "chair0," + sum + "1;2;3;,1;2\n", {"shape_evidence.csv:2", "information", "''"});
  expect_refused(header + "chair0,0123456789abcdeg,1,2\n",
                 {"shape_evidence.csv:2", "model", "0123456789abcdeg"});
  expect_refused(header + "chair0," + sum + "1,2\nchair0," + sum + "1,2\n",
                 {"shape_evidence.csv:3", "'chair0'", "twice"});
}

}  // namespace
}  // namespace armature
