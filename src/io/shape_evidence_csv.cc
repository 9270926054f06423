// SPDX-License-Identifier: BSD-3-Clause
#include "io/shape_evidence_csv.h"

#include <fmt/format.h>

#include "io/csv.h"
#include "io/errors.h"
#include "io/number_format.h"

namespace armature {
namespace {

std::string Joined(const std::vector<double>& values) {
  std::vector<std::string> texts;
  texts.reserve(values.size());
  for (const double value : values) texts.push_back(Fixed(value, 6));
  return fmt::format("{}", fmt::join(texts, ";"));
}

std::vector<double> LowerTriangle(const Eigen::MatrixXd& matrix) {
  std::vector<double> values;
  for (Eigen::Index row = 0; row < matrix.rows(); ++row) {
    for (Eigen::Index column = 0; column <= row; ++column) values.push_back(matrix(row, column));
  }
  return values;
}

Eigen::MatrixXd Symmetric(const std::vector<double>& triangle, Eigen::Index size) {
  Eigen::MatrixXd matrix(size, size);
  size_t next = 0;
  for (Eigen::Index row = 0; row < size; ++row) {
    for (Eigen::Index column = 0; column <= row; ++column)
      matrix(row, column) = matrix(column, row) = triangle[next++];
  }
  return matrix;
}

ShapeEvidence ReadRow(const CsvRow& row) {
  const std::vector<double> triangle = ParseNumbers(row.Text("information"), row.At("column 'information'"));
  const std::vector<double> vector = ParseNumbers(row.Text("vector"), row.At("column 'vector'"));
  if (triangle.size() != vector.size() * (vector.size() + 1) / 2) {
    throw InputError(
        row.At(fmt::format("{} numbers of information do not go with {} of the vector; run "
                           "`armature run` again",
                           triangle.size(), vector.size())));
  }
  const auto size = static_cast<Eigen::Index>(vector.size());
  return {Symmetric(triangle, size), Eigen::Map<const Eigen::VectorXd>(vector.data(), size)};
}

}  // namespace

std::string ShapeEvidenceText(const std::vector<MapObject>& objects) {
  std::string text = "id,information,vector\n";
  for (const MapObject& object : objects) {
    const Eigen::VectorXd& vector = object.evidence.vector;
    text += fmt::format("{},{},{}\n", object.id, Joined(LowerTriangle(object.evidence.information)),
                        Joined({vector.begin(), vector.end()}));
  }
  return text;
}

std::map<std::string, ShapeEvidence> ReadShapeEvidence(const std::filesystem::path& file) {
  const CsvTable table(file, {"id", "information", "vector"});
  std::map<std::string, ShapeEvidence> evidence;
  for (const CsvRow& row : table.rows()) {
    if (!evidence.emplace(row.Text("id"), ReadRow(row)).second)
      throw InputError(row.At(fmt::format("'{}' is there twice; keep one row", row.Text("id"))));
  }
  return evidence;
}

}  // namespace armature
