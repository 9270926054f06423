// SPDX-License-Identifier: BSD-3-Clause
// Reading comma-separated tables with a header line. Blank lines and '#' comments are skipped; fields may be
// quoted, a line holds a row.
#pragma once

#include <Eigen/Geometry>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/text.h"
#include "io/csv.h"

namespace armature {

// One row; every access throws InputError naming file, line and column when the field is missing or
// malformed.
class CsvRow {
 public:
  CsvRow(const class CsvTable* table, int line, std::vector<std::string> fields)
      : table_(table), line_(line), fields_(std::move(fields)) {}

  const std::string& Text(const std::string& column) const;
  double Number(const std::string& column) const;  // finite
  int Integer(const std::string& column) const;
  bool IsEmpty(const std::string& column) const;
  int line() const { return line_; }
  // "file:line: message", ready to be thrown
  std::string At(const std::string& message) const;

 private:
  const class CsvTable* table_;
  int line_;
  std::vector<std::string> fields_;
};

class CsvTable {
 public:
  // Throws InputError when the file cannot be read, has no header or one of more than a thousand
  // columns, names a column twice, lacks one of the
  // required columns, or a row has another number of fields than the header.
  CsvTable(std::filesystem::path file, const std::vector<std::string>& required_columns);
  CsvTable(const CsvTable&) = delete;  // rows point to their table
  CsvTable& operator=(const CsvTable&) = delete;

  const std::vector<CsvRow>& rows() const { return rows_; }
  const std::filesystem::path& file() const { return file_; }
  bool HasColumn(const std::string& column) const;
  // Position of a column; throws InputError when there is none.
  size_t ColumnIndex(const std::string& column) const;
  // Throws InputError when the header has a column that is not among the known ones, naming the nearest.
  void CheckColumnsKnown(const std::vector<std::string>& known) const;

 private:
  std::filesystem::path file_;
  int header_line_ = 0;
  std::vector<std::string> header_;
  std::vector<CsvRow> rows_;
};

// From the column 'probability', which may be absent or empty. Throws InputError when it is no number from 0
// to 1.
std::optional<double> ReadProbabilityIfAny(const CsvTable& table, const CsvRow& row);

// From the columns tx ty tz (metres) and qx qy qz qw. Throws InputError when one is missing, is not a finite
// number, or the quaternion's length is further than 1e-3 from 1.
Eigen::Isometry3d ReadPose(const CsvRow& row);

}  // namespace armature
