// SPDX-License-Identifier: BSD-3-Clause
#include "bench/retrieval/library_costs.h"

#include <fmt/format.h>
#include <unistd.h>  // NOLINT: getpid is POSIX

#include <algorithm>
#include <filesystem>
#include <vector>

#include "base/stage_clock.h"
#include "base/statistics.h"
#include "io/library_file.h"
#include "retrieval/shape_distance.h"

namespace armature {
namespace {

namespace fs = std::filesystem;

constexpr Eigen::Index kEdges = 11;
constexpr Eigen::Index kQueries = 12;  // the first two do not count
constexpr int kListed = 5;

CategoryModel ChairLike(Eigen::Index modes) {
  CategoryModel model;
  model.spec.name = "chair";
  for (Eigen::Index e = 0; e < kEdges; ++e) model.spec.edge_names.push_back(fmt::format("edge_{}", e));
  model.mean = Eigen::VectorXd::LinSpaced(6 * kEdges, -0.5, 0.5);
  model.basis = Eigen::MatrixXd::Identity(6 * kEdges, modes);
  model.standard_deviations = Eigen::VectorXd::Constant(modes, 0.1);
  return model;
}

InstanceLibrary MakeLibrary(const CategoryModel& model, const Eigen::MatrixXf& coefficients) {
  CategoryInstances instances{.category = model.spec.name, .model_checksum = ModelChecksum(model)};
  const Eigen::Index count = coefficients.cols();
  instances.coefficients = coefficients;
  instances.sizes = coefficients.topRows<3>().cwiseAbs();
  instances.edges = coefficients.replicate(kEdges, 1).topRows(6 * kEdges);
  instances.size_sigmas = Eigen::VectorXf::Zero(count);
  instances.T_object_geometry = coefficients.replicate(2, 1).topRows<12>();
  for (Eigen::Index i = 0; i < count; ++i) {
    instances.ids.push_back(fmt::format("synthetic:chair-{:07}", i));
    instances.geometries.push_back(fmt::format("chair/chair-{:07}.ply", i));
  }
  return {".", {std::move(instances)}};
}

// An estimate that knows its first modes better than its last.
ShapeEvidence MakeEvidence(const Eigen::VectorXd& coefficients) {
  const Eigen::VectorXd information = Eigen::VectorXd::LinSpaced(coefficients.size(), 100, 1);
  return {information.asDiagonal(), information.cwiseProduct(coefficients)};
}

double MeasureWeighing(const CategoryInstances& instances, const Eigen::MatrixXf& queries) {
  std::vector<double> milliseconds;
  for (Eigen::Index i = 0; i < std::min(kQueries, queries.cols()); ++i) {
    const ShapeEvidence evidence = MakeEvidence(queries.col(i).cast<double>());
    double ms = 0;
    {
      const StageClock clock(ms);
      Likeliest(instances, evidence, 0.15, 0, kListed);
    }
    if (i >= 2) milliseconds.push_back(ms);
  }
  return ComputeStatistics(std::move(milliseconds)).value().median;
}

}  // namespace

LibraryCosts MeasureLibrary(const SyntheticLibrary& synthetic) {
  const CategoryModel model = ChairLike(synthetic.features.rows());
  const fs::path file = fs::temp_directory_path() / fmt::format("armature-bench-{}.armlib", getpid());
  LibraryCosts costs;
  {
    const InstanceLibrary library = MakeLibrary(model, synthetic.features);
    const StageClock clock(costs.write_ms);
    WriteLibrary(library, file);
  }
  costs.file_mb = static_cast<double>(fs::file_size(file)) / (1 << 20);
  InstanceLibrary library;
  {
    const StageClock clock(costs.read_ms);
    library = ReadLibrary(file, {model});
  }
  fs::remove(file);
  costs.weighed_ms = MeasureWeighing(library.categories.front(), synthetic.queries);
  return costs;
}

}  // namespace armature
