// SPDX-License-Identifier: BSD-3-Clause
#include "io/shape_evidence_csv.h"

#include <fmt/format.h>

#include <charconv>

#include "base/csv_fields.h"
#include "base/errors.h"
#include "base/number_format.h"
#include "io/csv.h"

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

// 16 hexadecimal digits.
std::uint64_t ReadChecksum(const CsvRow& row) {
  const std::string& text = row.Text("model");
  std::uint64_t checksum = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), checksum, 16);
  if (text.size() == 16 && error == std::errc() && end == text.data() + text.size()) return checksum;
  throw InputError(
      row.At(fmt::format("column 'model': {} is no checksum; run `armature run` again", Quoted(text))));
}

StoredEvidence ReadRow(const CsvRow& row) {
  const std::vector<double> triangle = ParseNumbers(row.Text("information"), row.At("column 'information'"));
  const std::vector<double> vector = ParseNumbers(row.Text("vector"), row.At("column 'vector'"));
  if (triangle.size() != vector.size() * (vector.size() + 1) / 2) {
    throw InputError(
        row.At(fmt::format("{} numbers of information do not go with {} of the vector; run "
                           "`armature run` again",
                           triangle.size(), vector.size())));
  }
  const auto size = static_cast<Eigen::Index>(vector.size());
  return {{Symmetric(triangle, size), Eigen::Map<const Eigen::VectorXd>(vector.data(), size)},
          ReadChecksum(row)};
}

}  // namespace

std::string ShapeEvidenceText(const std::vector<MapObject>& objects) {
  std::string text = "id,model,information,vector\n";
  for (const MapObject& object : objects) {
    const Eigen::VectorXd& vector = object.evidence.vector;
    text += fmt::format("{},{:016x},{},{}\n", CsvField(object.id), ModelChecksum(*object.model),
                        Joined(LowerTriangle(object.evidence.information)),
                        Joined({vector.begin(), vector.end()}));
  }
  return text;
}

std::map<std::string, StoredEvidence> ReadShapeEvidence(const std::filesystem::path& file) {
  const CsvTable table(file, {"id", "model", "information", "vector"});
  std::map<std::string, StoredEvidence> evidence;
  for (const CsvRow& row : table.rows()) {
    if (!evidence.emplace(row.Text("id"), ReadRow(row)).second)
      throw InputError(row.At(fmt::format("'{}' is there twice; keep one row", row.Text("id"))));
  }
  return evidence;
}

}  // namespace armature
