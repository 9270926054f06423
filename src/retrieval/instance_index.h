// SPDX-License-Identifier: BSD-3-Clause
// Nearest neighbours among the instances of a library (paper 4.2: k-NN, k = 5), by FLANN.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "base/enum_names.h"

namespace armature {

enum class IndexKind {
  kLinear,        // an exact scan
  kKdTreeSingle,  // one KD-tree, exact
  kKdTree,        // randomised KD-trees, approximate
  kKMeans,        // a hierarchical k-means tree, approximate
};

template <>
struct EnumNames<IndexKind> {
  static constexpr NamedValue<IndexKind> kTable[] = {{IndexKind::kLinear, "linear"},
                                                     {IndexKind::kKdTreeSingle, "kdtree_single"},
                                                     {IndexKind::kKdTree, "kdtree"},
                                                     {IndexKind::kKMeans, "kmeans"}};
};

// How neighbours are found; the parameters of other kinds are ignored.
struct IndexMethod {
  IndexKind kind = IndexKind::kKdTreeSingle;
  int leaf_size = 10;      // kdtree_single: instances a leaf
  int trees = 4;           // kdtree
  int branching = 32;      // kmeans
  int iterations = 11;     // kmeans, at most
  int checks = 128;        // kdtree, kmeans: instances that a query looks at
  std::uint64_t seed = 1;  // kdtree, kmeans
};

struct Neighbour {
  int instance = 0;     // column of the features
  double distance = 0;  // Euclidean, of the features

  bool operator==(const Neighbour&) const = default;
};

// By distance, equally far ones by instance.
inline bool IsNearer(const Neighbour& a, const Neighbour& b) {
  return a.distance != b.distance ? a.distance < b.distance : a.instance < b.instance;
}

class InstanceIndex {
 public:
  // `features`: D x N, a column an instance, finite; N = 0 is an index that finds nothing. The same seed
  // builds the same structure. Throws InputError for a parameter out of range.
  InstanceIndex(Eigen::MatrixXf features, const IndexMethod& method);
  ~InstanceIndex();
  InstanceIndex(InstanceIndex&&) noexcept;
  InstanceIndex& operator=(InstanceIndex&&) noexcept;

  // The k nearest, or all where there are fewer; nearest first, equally near ones by rising instance.
  // `query`: D. Also among equally near ones at the end of the list the first are taken, where the method is
  // exact. Distances are computed in double precision. Queries may be asked from several threads at once.
  // Throws std::invalid_argument when the query has another dimension or k is less than 1.
  std::vector<Neighbour> Nearest(const Eigen::VectorXf& query, int k) const;
  // All within the radius (of approximate methods: those they find), in the same order.
  std::vector<Neighbour> Within(const Eigen::VectorXf& query, double radius) const;

  Eigen::Index instances() const;
  Eigen::Index dimensions() const;
  // The features and the search structure, as FLANN counts it.
  size_t memory_bytes() const;

  // The search structure as bytes (the features are not in them), and back. `saved` has to be of these
  // features and of a structure with the same Description(), which io/index_file.h sees to. Throws
  // InputError, without a file's name, for bytes that are no such structure.
  std::string Saved() const;
  static InstanceIndex FromSaved(std::string_view saved, Eigen::MatrixXf features, const IndexMethod& method);
  const Eigen::MatrixXf& features() const;
  // The method with the parameters that it was built with (not `checks`): of another text it is another
  // structure.
  std::string Description() const;

 private:
  struct Implementation;
  explicit InstanceIndex(std::unique_ptr<Implementation> implementation);

  std::unique_ptr<Implementation> implementation_;
};

// Description() of an index by this method.
std::string DescribeMethod(const IndexMethod& method);

// Whether it finds the nearest, and not only near ones.
bool IsExact(const IndexMethod& method);

}  // namespace armature
