// SPDX-License-Identifier: BSD-3-Clause
#include "retrieval/instance_index.h"

#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>
#include <stdexcept>

#include "base/errors.h"
#include "retrieval/checked_flann.h"
#include "retrieval/neighbour_sets.h"

namespace armature {
namespace {

using FlannIndex = flann::NNIndex<FeatureDistance>;

void CheckAtLeast(const char* parameter, int value, int least) {
  if (value < least)
    throw InputError(fmt::format("index: {} {} has to be {} or more", parameter, value, least));
}

void CheckMethod(const IndexMethod& m) {
  CheckAtLeast("leaf_size", m.leaf_size, 1);
  CheckAtLeast("trees", m.trees, 1);
  CheckAtLeast("branching", m.branching, 2);
  CheckAtLeast("iterations", m.iterations, 1);
  CheckAtLeast("checks", m.checks, 1);
}

// Not built yet; keeps pointers to the features.
std::unique_ptr<FlannIndex> MakeFlannIndex(Eigen::MatrixXf& features, const IndexMethod& m) {
  // A column here is a row there.
  const flann::Matrix<float> points(features.data(), static_cast<size_t>(features.cols()),
                                    static_cast<size_t>(features.rows()));
  const FeatureDistance distance(m.seed);
  switch (m.kind) {
    case IndexKind::kLinear:
      return std::make_unique<flann::LinearIndex<FeatureDistance>>(points, flann::LinearIndexParams(),
                                                                   distance);
    case IndexKind::kKdTreeSingle:
      return std::make_unique<flann::KDTreeSingleIndex<FeatureDistance>>(
          points, flann::KDTreeSingleIndexParams(m.leaf_size), distance);
    case IndexKind::kKdTree:
      return std::make_unique<flann::KDTreeIndex<FeatureDistance>>(points, flann::KDTreeIndexParams(m.trees),
                                                                   distance);
    case IndexKind::kKMeans:
      return std::make_unique<flann::KMeansIndex<FeatureDistance>>(
          points, flann::KMeansIndexParams(m.branching, m.iterations, flann::FLANN_CENTERS_RANDOM), distance);
  }
  std::abort();
}

std::string Saved(FlannIndex& index) {
  char* bytes = nullptr;
  size_t size = 0;
  std::FILE* stream = open_memstream(&bytes, &size);
  if (!stream) throw std::runtime_error("index: no memory to save it");
  index.saveIndex(stream);
  std::fclose(stream);
  const std::unique_ptr<char, decltype(&std::free)> owner(bytes, &std::free);
  return {bytes, size};
}

template <typename Index>
void LoadAs(FlannArchive& archive, FlannIndex& index) {
  archive& static_cast<Index&>(index);
}

void LoadFrom(std::string_view saved, IndexKind kind, FlannIndex& index) {
  FlannArchive archive(saved);
  switch (kind) {
    case IndexKind::kLinear:
      LoadAs<flann::LinearIndex<FeatureDistance>>(archive, index);
      break;
    case IndexKind::kKdTreeSingle:
      LoadAs<flann::KDTreeSingleIndex<FeatureDistance>>(archive, index);
      break;
    case IndexKind::kKdTree:
      LoadAs<flann::KDTreeIndex<FeatureDistance>>(archive, index);
      break;
    case IndexKind::kKMeans:
      LoadAs<flann::KMeansIndex<FeatureDistance>>(archive, index);
      break;
  }
  archive.Finish();
}

}  // namespace

struct InstanceIndex::Implementation {
  Eigen::MatrixXf features;  // does not move: FLANN points into it
  IndexMethod method;
  std::unique_ptr<FlannIndex> flann;  // none of no features, of which FLANN has no structure

  Implementation(Eigen::MatrixXf&& given, const IndexMethod& by) : features(std::move(given)), method(by) {
    CheckMethod(method);
    if (features.cols() == 0) return;
    if (features.rows() == 0) throw std::invalid_argument("index: features without dimensions");
    if (!features.allFinite()) throw std::invalid_argument("index: a feature is not a finite number");
    flann = MakeFlannIndex(features, method);
  }

  void Search(const Eigen::VectorXf& query, NeighbourSet& neighbours) const {
    if (query.size() != features.rows()) {
      throw std::invalid_argument(
          fmt::format("index: a query of {} dimensions, not {}", query.size(), features.rows()));
    }
    if (!flann) return;
    flann::SearchParams parameters(method.checks);
    // Bounds of branches are sums with rounding: none is left out that might hold a point as far as the last
    // one.
    parameters.eps = -1e-5F;
    flann->findNeighbors(neighbours, query.data(), parameters);
  }
};

InstanceIndex::InstanceIndex(Eigen::MatrixXf features, const IndexMethod& method)
    : InstanceIndex(std::make_unique<Implementation>(std::move(features), method)) {
  if (implementation_->flann) implementation_->flann->buildIndex();
}

InstanceIndex::InstanceIndex(std::unique_ptr<Implementation> implementation)
    : implementation_(std::move(implementation)) {}

InstanceIndex::~InstanceIndex() = default;
InstanceIndex::InstanceIndex(InstanceIndex&&) noexcept = default;
InstanceIndex& InstanceIndex::operator=(InstanceIndex&&) noexcept = default;

std::vector<Neighbour> InstanceIndex::Nearest(const Eigen::VectorXf& query, int k) const {
  if (k < 1) throw std::invalid_argument(fmt::format("index: the {} nearest", k));
  const size_t most = static_cast<size_t>(std::min<Eigen::Index>(k, std::max<Eigen::Index>(instances(), 1)));
  NearestSet nearest(implementation_->features, query, most);
  implementation_->Search(query, nearest);
  return std::move(nearest.found());
}

std::vector<Neighbour> InstanceIndex::Within(const Eigen::VectorXf& query, double radius) const {
  WithinSet within(implementation_->features, query, radius);
  implementation_->Search(query, within);
  std::sort(within.found().begin(), within.found().end(), IsNearer);
  return std::move(within.found());
}

Eigen::Index InstanceIndex::instances() const { return implementation_->features.cols(); }

Eigen::Index InstanceIndex::dimensions() const { return implementation_->features.rows(); }

size_t InstanceIndex::memory_bytes() const {
  const Implementation& self = *implementation_;
  if (!self.flann) return 0;
  const size_t features = static_cast<size_t>(self.features.size()) * sizeof(float);
  const size_t pointers = static_cast<size_t>(instances()) * sizeof(float*);
  const bool has_copy = self.method.kind == IndexKind::kKdTreeSingle;
  return (has_copy ? 2 : 1) * features + pointers + static_cast<size_t>(self.flann->usedMemory());
}

std::string InstanceIndex::Saved() const {
  return implementation_->flann ? armature::Saved(*implementation_->flann) : "";
}

InstanceIndex InstanceIndex::FromSaved(std::string_view saved, Eigen::MatrixXf features,
                                       const IndexMethod& method) {
  InstanceIndex index(std::make_unique<Implementation>(std::move(features), method));
  if (index.implementation_->flann) LoadFrom(saved, method.kind, *index.implementation_->flann);
  return index;
}

const Eigen::MatrixXf& InstanceIndex::features() const { return implementation_->features; }

std::string InstanceIndex::Description() const { return DescribeMethod(implementation_->method); }

std::string DescribeMethod(const IndexMethod& m) {
  const char* name = ToName(m.kind);
  switch (m.kind) {
    case IndexKind::kLinear:
      return name;
    case IndexKind::kKdTreeSingle:
      return fmt::format("{} leaf_size={}", name, m.leaf_size);
    case IndexKind::kKdTree:
      return fmt::format("{} trees={} seed={}", name, m.trees, m.seed);
    case IndexKind::kKMeans:
      return fmt::format("{} branching={} iterations={} seed={}", name, m.branching, m.iterations, m.seed);
  }
  std::abort();
}

bool IsExact(const IndexMethod& method) {
  return method.kind == IndexKind::kLinear || method.kind == IndexKind::kKdTreeSingle;
}

}  // namespace armature
