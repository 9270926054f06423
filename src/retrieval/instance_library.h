// SPDX-License-Identifier: BSD-3-Clause
// The library of instances: CAD models as their category's model describes them (paper 4.2).
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "category/cad_model.h"
#include "category/category_model.h"

namespace armature {

// Seats of real chairs are 0.42 to 0.48 m high, and laptops differ more.
constexpr double kUnscaledSizeSigma = 0.05;

// The instances of one category, a column each. Numbers are floats: a library of a million instances fits
// into memory and is read in a second.
struct CategoryInstances {
  std::string category;
  std::uint64_t model_checksum = 0;  // of the category model that the coefficients are of
  std::vector<std::string> ids{};    // "armature:chair-0001"
  std::vector<std::string>
      geometries{};                // their surfaces: files relative to the root, see CadModel; empty: none
  Eigen::MatrixXf coefficients{};  // B x N, standard deviations
  Eigen::Matrix3Xf sizes{};        // of their bounding boxes, metres
  Eigen::MatrixXf edges{};         // 6m x N: their own wireframes as shape vectors, centred, metres
  // Of the logarithm of its size, known beforehand: 0 for models in metres, kUnscaledSizeSigma for those that
  // were brought to metres by their category's reference.
  Eigen::VectorXf size_sigmas{};
  Eigen::Matrix<float, 12, Eigen::Dynamic> T_object_geometry{};  // 3 x 4, column by column: the surface to
                                                                 // the centred object frame, metres

  int size() const { return static_cast<int>(ids.size()); }
  // -1: there is none of this id.
  int Find(const std::string& id) const;
  Wireframe MakeWireframe(int instance) const;
  Eigen::Affine3d MakeTransform(int instance) const;  // T_object_geometry
};

struct InstanceLibrary {
  std::filesystem::path root;                 // where the surfaces are
  std::vector<CategoryInstances> categories;  // at most one of a name

  const CategoryInstances* Of(const std::string& category) const;  // null: it has none of this category
};

// The CAD models of the categories that there are models of; others are left out, and so are those that have
// no size in metres (a seat on the ground). Wireframes are brought to metres by the category's reference,
// metric ones stay as they are. A surface whose frame is not known is left out.
InstanceLibrary BuildLibrary(const std::vector<CategoryModel>& models, const std::vector<CadModel>& cad,
                             const std::filesystem::path& root);

// The instances without some of them, in their order. `leave_out`: indices.
CategoryInstances Without(const CategoryInstances& instances, const std::vector<int>& leave_out);

}  // namespace armature
