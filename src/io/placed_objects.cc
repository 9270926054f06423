// SPDX-License-Identifier: BSD-3-Clause
#include "io/placed_objects.h"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <set>

#include "base/errors.h"
#include "io/csv.h"

namespace armature {
namespace {

std::string ReadId(const CsvRow& row, std::set<std::string>& known) {
  const std::string& id = row.Text("id");
  if (id.empty()) throw InputError(row.At("the object has no id; give each its own"));
  if (!known.insert(id).second) {
    throw InputError(row.At(fmt::format("the id {} occurs twice; give each object its own", Quoted(id))));
  }
  return id;
}

Eigen::Vector3d ReadSize(const CsvRow& row) {
  const Eigen::Vector3d size(row.Number("size_x"), row.Number("size_y"), row.Number("size_z"));
  if (size.minCoeff() < 0) throw InputError(row.At("a size is negative; give lengths in metres"));
  return size;
}

int ReadObservationCount(const CsvRow& row) {
  const int count = row.Integer("observations");
  if (count < 0) throw InputError(row.At("column 'observations' is negative; give their number"));
  return count;
}

std::optional<PoseAndSizeCovariance> ReadCovarianceIfAny(const CsvTable& table, const CsvRow& row) {
  if (!table.HasColumn("covariance") || row.IsEmpty("covariance")) return std::nullopt;
  const std::vector<double> values = ParseNumbers(row.Text("covariance"), row.At("column 'covariance'"));
  PoseAndSizeCovariance covariance;
  if (values.size() != 45)
    throw InputError(row.At("column 'covariance' has not 45 numbers; give the upper triangle, row by row"));
  size_t next = 0;
  for (int i = 0; i < 9; ++i) {
    for (int j = i; j < 9; ++j) covariance(i, j) = covariance(j, i) = values[next++];
  }
  if (covariance.llt().info() != Eigen::Success)
    throw InputError(row.At("column 'covariance' is not positive definite; leave it empty, or run it again"));
  return covariance;
}

}  // namespace

std::vector<PlacedObject> ReadPlacedObjects(const std::filesystem::path& file) {
  const CsvTable table(file, {"id", "category", "instance", "tx", "ty", "tz", "qx", "qy", "qz", "qw",
                              "size_x", "size_y", "size_z", "observations", "shape"});
  std::vector<PlacedObject> objects;
  std::set<std::string> ids;
  for (const CsvRow& row : table.rows()) {
    objects.push_back({ReadId(row, ids), row.Text("category"), row.Text("instance"), ReadPose(row),
                       ReadSize(row), ReadObservationCount(row),
                       ParseNumbers(row.Text("shape"), row.At("column 'shape'")),
                       ReadProbabilityIfAny(table, row), ReadCovarianceIfAny(table, row)});
  }
  return objects;
}

}  // namespace armature
