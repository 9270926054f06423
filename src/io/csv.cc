// SPDX-License-Identifier: BSD-3-Clause
#include "io/csv.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/csv_fields.h"
#include "base/errors.h"
#include "base/nearest_name.h"

namespace armature {
namespace {

constexpr size_t kMostColumns = 1000;  // tables of this project have at most 20

constexpr size_t kMostCommas = 10 * kMostColumns;  // commas in quoted fields are counted, too

// At most; those in quotes are none.
size_t CountFields(const std::string& line) {
  return static_cast<size_t>(std::count(line.begin(), line.end(), ',')) + 1;
}

}  // namespace

const std::string& CsvRow::Text(const std::string& column) const {
  return fields_[table_->ColumnIndex(column)];
}

double CsvRow::Number(const std::string& column) const {
  return ParseNumber(Text(column), At(fmt::format("column '{}'", column)));
}

int CsvRow::Integer(const std::string& column) const {
  return ParseInteger(Text(column), At(fmt::format("column '{}'", column)));
}

bool CsvRow::IsEmpty(const std::string& column) const { return Text(column).empty(); }

std::string CsvRow::At(const std::string& message) const {
  return fmt::format("{}:{}: {}", table_->file().string(), line_, message);
}

CsvTable::CsvTable(std::filesystem::path file, const std::vector<std::string>& required_columns)
    : file_(std::move(file)) {
  for (const TextLine& line : ReadTextLines(file_)) {
    // Counted before it is split: a line may be all commas.
    const size_t most_fields = CountFields(line.text);
    if (header_.empty()) {
      header_line_ = line.number;
      if (most_fields > kMostColumns) {
        throw InputError(fmt::format("{}:{}: a header of {} columns, at most {} are read; is this the table?",
                                     file_.string(), line.number, most_fields, kMostColumns));
      }
      header_ = SplitCsvFields(line.text);
      continue;
    }
    std::vector<std::string> fields;
    if (most_fields <= kMostCommas) fields = SplitCsvFields(line.text);
    if (fields.size() != header_.size()) {
      throw InputError(fmt::format(
          "{}:{}: {} fields where the header has {}; fill the row or leave fields empty", file_.string(),
          line.number, fields.empty() ? most_fields : fields.size(), header_.size()));
    }
    rows_.emplace_back(this, line.number, std::move(fields));
  }
  if (header_.empty()) {
    throw InputError(fmt::format("{}: has no header line; start it with '{}'", file_.string(),
                                 fmt::join(required_columns, ",")));
  }
  for (const std::string& column : header_) {
    if (std::count(header_.begin(), header_.end(), column) == 1) continue;
    throw InputError(fmt::format("{}:{}: two columns are called {}; rename one", file_.string(), header_line_,
                                 Quoted(column)));
  }
  for (const std::string& column : required_columns) ColumnIndex(column);
}

bool CsvTable::HasColumn(const std::string& column) const {
  return std::find(header_.begin(), header_.end(), column) != header_.end();
}

size_t CsvTable::ColumnIndex(const std::string& column) const {
  const auto found = std::find(header_.begin(), header_.end(), column);
  if (found == header_.end()) {
    throw InputError(fmt::format("{}:{}: has no column {}; add it to the header {}", file_.string(),
                                 header_line_, Quoted(column),
                                 Quoted(fmt::format("{}", fmt::join(header_, ",")))));
  }
  return static_cast<size_t>(found - header_.begin());
}

void CsvTable::CheckColumnsKnown(const std::vector<std::string>& known) const {
  for (const std::string& column : header_) {
    if (std::find(known.begin(), known.end(), column) != known.end()) continue;
    throw InputError(
        fmt::format("{}:{}: {}", file_.string(), header_line_, UnknownNameMessage("column", column, known)));
  }
}

std::optional<double> ReadProbabilityIfAny(const CsvTable& table, const CsvRow& row) {
  if (!table.HasColumn("probability") || row.IsEmpty("probability")) return std::nullopt;
  const double probability = row.Number("probability");
  if (probability < 0 || probability > 1)
    throw InputError(row.At("column 'probability' is none; give a number from 0 to 1"));
  return probability;
}

Eigen::Isometry3d ReadPose(const CsvRow& row) {
  const Eigen::Quaterniond q(row.Number("qw"), row.Number("qx"), row.Number("qy"), row.Number("qz"));
  if (std::abs(q.norm() - 1) > 1e-3)
    throw InputError(row.At("the quaternion has not unit length; normalise it"));
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = q.normalized().toRotationMatrix();
  // Not by Eigen's comma initialiser: it must not be left half way, as by a number that cannot be read.
  pose.translation() = Eigen::Vector3d(row.Number("tx"), row.Number("ty"), row.Number("tz"));
  return pose;
}

}  // namespace armature
