// SPDX-License-Identifier: BSD-3-Clause
// How FLANN's structures over our own distance are written and read: what FLANN does itself, but nothing that
// is read is used as a size or an index before it is known to be one. (FLANN's own way to write a KD-tree is
// replaced, too: it cannot read it back where the features are more than two blocks of 64 KB. Left out is the
// copy of the features in the order of the leaves, which is made again.)
#pragma once

#include <cstring>
#include <limits>
#include <type_traits>

#include "retrieval/flann_archive.h"
#include "retrieval/seeded_flann.h"

namespace armature {

// How much of a tree has been read. Trees that were built are nowhere near these limits.
class TreeLimits {
 public:
  static constexpr int kMostLevels = 5000;

  void Begin(size_t most_nodes) { left_ = most_nodes; }
  void Enter() {
    if (left_-- == 0) RefuseStructure("it has more nodes than points");
    if (++level_ > kMostLevels) RefuseStructure("it is too deep");
  }
  void Leave() { --level_; }

 private:
  size_t left_ = 0;
  int level_ = 0;
};

inline thread_local TreeLimits tree_limits;

class TreeLevel {
 public:
  TreeLevel() { tree_limits.Enter(); }
  ~TreeLevel() { tree_limits.Leave(); }
  TreeLevel(const TreeLevel&) = delete;
  TreeLevel& operator=(const TreeLevel&) = delete;
};

// What was written as a bool may be read as something else.
template <typename Archive>
bool LoadFlag(Archive& archive) {
  unsigned char flag = 0;
  archive& flag;
  if (flag > 1) RefuseStructure("it is neither true nor false");
  return flag == 1;
}

// A value that has to be the one that is there already.
template <typename Archive, typename T>
void LoadSame(Archive& archive, const T& expected, const char* why) {
  if constexpr (std::is_same_v<T, bool>) {
    if (LoadFlag(archive) != expected) RefuseStructure(why);
    return;
  }
  T value{};
  archive& value;
  if (value != expected) RefuseStructure(why);
}

// An enumeration as a number: what was read may be none of its values.
template <typename Enum>
int NumberOf(const Enum& value) {
  int number = 0;
  static_assert(sizeof number == sizeof value);
  std::memcpy(&number, &value, sizeof number);
  return number;
}

inline bool IsBelow(int index, size_t size) { return index >= 0 && static_cast<size_t>(index) < size; }

}  // namespace armature

namespace flann {

template <>
template <typename Archive>
void NNIndex<armature::FeatureDistance>::serialize(Archive& archive) {
  bool has_dataset = false;
  if constexpr (Archive::is_saving::value) {
    IndexHeader header;
    header.h.data_type = flann_datatype_value<float>::value;
    header.h.index_type = getType();
    header.h.rows = size_;
    header.h.cols = veclen_;
    archive& header;
    archive& size_& veclen_& size_at_build_& has_dataset& last_id_& ids_& removed_& removed_count_;
  } else {
    IndexHeaderStruct header;
    archive.load(header);
    const bool fits = armature::NumberOf(header.data_type) == flann_datatype_value<float>::value &&
                      armature::NumberOf(header.index_type) == getType() && header.rows == size_ &&
                      header.cols == veclen_;
    if (!fits) armature::RefuseStructure("it is of another kind, or of other points");
    armature::LoadSame(archive, size_, "it is of other points");
    armature::LoadSame(archive, veclen_, "it is of other points");
    archive& size_at_build_;
    armature::LoadSame(archive, has_dataset, "it holds points of its own");
    archive& last_id_;
    armature::LoadSame(archive, size_t{0}, "it has points of other names");
    armature::LoadSame(archive, false, "it has points that were removed");
    armature::LoadSame(archive, size_t{0}, "it has points that were removed");
  }
}

template <>
template <typename Archive>
void KDTreeSingleIndex<armature::FeatureDistance>::Node::serialize(Archive& archive) {
  using Index = KDTreeSingleIndex<armature::FeatureDistance>;
  auto* index = static_cast<Index*>(archive.getObject());
  bool is_leaf = child1 == nullptr && child2 == nullptr;
  archive& left& right& divfeat& divlow& divhigh;
  if constexpr (Archive::is_loading::value) {
    const armature::TreeLevel level;
    is_leaf = armature::LoadFlag(archive);
    const bool is_range = left >= 0 && left <= right && static_cast<size_t>(right) <= index->size_;
    if (is_leaf ? !is_range : !armature::IsBelow(divfeat, index->veclen_))
      armature::RefuseStructure("a node is of points or dimensions that are not there");
    if (is_leaf) return;
    child1 = new (index->pool_) Node();
    child2 = new (index->pool_) Node();
    archive&* child1&* child2;
  } else {
    archive& is_leaf;
    if (!is_leaf) archive&* child1&* child2;
  }
}

template <>
template <typename Archive>
void KDTreeSingleIndex<armature::FeatureDistance>::serialize(Archive& archive) {
  archive.setObject(this);
  archive&* static_cast<NNIndex<armature::FeatureDistance>*>(this);
  if constexpr (Archive::is_saving::value) {
    archive& root_bbox_& vind_&* root_node_;
  } else {
    armature::LoadSame(archive, veclen_, "its box is of another number of dimensions");
    root_bbox_.resize(veclen_);
    for (Interval& interval : root_bbox_) archive& interval;
    armature::LoadSame(archive, size_, "it is of other points");
    vind_.resize(size_);
    for (int& point : vind_) {
      archive& point;
      if (!armature::IsBelow(point, size_)) armature::RefuseStructure("it names a point that is not there");
    }
    armature::tree_limits.Begin(2 * size_ + 1);
    root_node_ = new (pool_) Node();
    archive&* root_node_;
    data_ = Matrix<float>(new float[size_ * veclen_], size_, veclen_);
    for (size_t i = 0; i < size_; ++i) {
      const float* point = points_[static_cast<size_t>(vind_[i])];
      std::copy(point, point + veclen_, data_[i]);
    }
  }
}

template <>
template <typename Archive>
void KDTreeIndex<armature::FeatureDistance>::Node::serialize(Archive& archive) {
  using Index = KDTreeIndex<armature::FeatureDistance>;
  auto* index = static_cast<Index*>(archive.getObject());
  bool is_leaf = child1 == nullptr && child2 == nullptr;
  archive& divfeat& divval;
  if constexpr (Archive::is_loading::value) {
    const armature::TreeLevel level;
    is_leaf = armature::LoadFlag(archive);
    if (!armature::IsBelow(divfeat, is_leaf ? index->size_ : index->veclen_))
      armature::RefuseStructure("a node is of a point or a dimension that is not there");
    if (is_leaf) {
      point = index->points_[static_cast<size_t>(divfeat)];
      return;
    }
    child1 = new (index->pool_) Node();
    child2 = new (index->pool_) Node();
    archive&* child1&* child2;
  } else {
    archive& is_leaf;
    if (!is_leaf) archive&* child1&* child2;
  }
}

template <>
template <typename Archive>
void KDTreeIndex<armature::FeatureDistance>::serialize(Archive& archive) {
  archive.setObject(this);
  archive&* static_cast<NNIndex<armature::FeatureDistance>*>(this);
  if constexpr (Archive::is_saving::value) {
    archive& trees_;
    for (Node* root : tree_roots_) archive&* root;
  } else {
    armature::LoadSame(archive, trees_, "it has another number of trees");
    for (int tree = 0; tree < trees_; ++tree) {
      armature::tree_limits.Begin(2 * size_ + 1);
      tree_roots_.push_back(new (pool_) Node());
      archive&* tree_roots_.back();
    }
  }
}

template <>
template <typename Archive>
void KMeansIndex<armature::FeatureDistance>::PointInfo::serialize(Archive& archive) {
  using Index = KMeansIndex<armature::FeatureDistance>;
  archive& index;
  if constexpr (Archive::is_loading::value) {
    auto* of = static_cast<Index*>(archive.getObject());
    if (index >= of->size_) armature::RefuseStructure("it names a point that is not there");
    point = of->points_[index];
  }
}

template <>
template <typename Archive>
void KMeansIndex<armature::FeatureDistance>::Node::serialize(Archive& archive) {
  using Index = KMeansIndex<armature::FeatureDistance>;
  auto* index = static_cast<Index*>(archive.getObject());
  size_t children = childs.size();
  if constexpr (Archive::is_saving::value) {
    archive& serialization::make_binary_object(pivot, index->veclen_ * sizeof(DistanceType));
    archive& radius& variance& size& children;
    if (children == 0) archive& points;
    for (Node* child : childs) archive&* child;
  } else {
    const armature::TreeLevel level;
    pivot = new DistanceType[index->veclen_];
    archive& serialization::make_binary_object(pivot, index->veclen_ * sizeof(DistanceType));
    archive& radius& variance& size& children;
    if (children == 0) {
      size_t count = 0;
      archive& count;
      if (count > index->size_) armature::RefuseStructure("a node has more points than there are");
      points.resize(count);
      for (PointInfo& info : points) archive& info;
      return;
    }
    // The search looks at as many as there should be.
    if (children != static_cast<size_t>(index->branching_))
      armature::RefuseStructure("a node has another number of branches");
    for (size_t i = 0; i < children; ++i) {
      childs.push_back(new (index->pool_) Node());
      archive&* childs.back();
    }
  }
}

template <>
template <typename Archive>
void KMeansIndex<armature::FeatureDistance>::serialize(Archive& archive) {
  archive.setObject(this);
  archive&* static_cast<NNIndex<armature::FeatureDistance>*>(this);
  auto centers = static_cast<int>(centers_init_);
  if constexpr (Archive::is_saving::value) {
    archive& branching_& iterations_& memoryCounter_& cb_index_& centers&* root_;
  } else {
    armature::LoadSame(archive, branching_, "it was built with another number of branches");
    armature::LoadSame(archive, iterations_, "it was built with another number of iterations");
    archive& memoryCounter_;
    armature::LoadSame(archive, cb_index_, "it was built with other parameters");
    armature::LoadSame(archive, centers, "it was built with other parameters");
    armature::tree_limits.Begin(2 * size_ * static_cast<size_t>(branching_) + 1);
    root_ = new (pool_) Node();
    archive&* root_;
  }
}

}  // namespace flann
