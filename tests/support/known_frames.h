// SPDX-License-Identifier: BSD-3-Clause
// A library of frames whose ranks and surfaces are known by hand.
#pragma once

#include <fmt/format.h>

#include <string>
#include <vector>

#include "category/category_model.h"
#include "eval/retrieval/retrieval_queries.h"
#include "retrieval/instance_library.h"
#include "support/category_examples.h"
#include "support/temp_folder.h"

namespace armature::testing {

// Two modes: the posts grow longer (0), the bar grows wider (1), by a metre a deviation. What is longer than
// the mean stays centred.
inline CategoryModel TwoModeFrames() {
  CategoryModel model;
  model.spec = FrameSpec().category;
  model.mean = ShapeVector(FrameWireframe());
  model.basis = Eigen::MatrixXd::Zero(18, 2);
  model.basis(5, 0) = model.basis(11, 0) = std::sqrt(0.5);
  model.basis(15, 1) = 1;
  model.standard_deviations = Eigen::Vector2d(std::sqrt(2), 1);
  return model;
}

// Frames of the first coefficient 0, 1, 2, ... and the second 0, "cad:0", "cad:1", ... Their surfaces are
// level squares of 2 cm, the i-th 0.1 i metres up; files "0.off", ... of the folder, `without` some.
class FrameLibrary {
 public:
  explicit FrameLibrary(int count, const std::vector<int>& without = {}) {
    std::vector<CadModel> cad;
    for (int i = 0; i < count; ++i) {
      cad.push_back({.instance = fmt::format("cad:{}", i),
                     .category = "frame",
                     .metric = true,
                     .wireframe = WireframeFromCoefficients(models.front(), Eigen::Vector2d(i, 0))});
      cad.back().box_min = Eigen::Vector3d(-1, -1, -1);
      cad.back().box_max = Eigen::Vector3d(1, 1, 1);
      if (std::find(without.begin(), without.end(), i) != without.end()) continue;
      cad.back().geometry = fmt::format("{}.off", i);
      cad.back().T_annotation_geometry = Eigen::Affine3d::Identity();
      WriteSurface(cad.back().geometry, 0.1 * i);
    }
    library = BuildLibrary(models, cad, folder.path());
  }

  const CategoryInstances& frames() const { return library.categories.front(); }

  // The object of that model and size was estimated to have the coefficients.
  RetrievalQuery Query(const std::string& true_model, double first, double second = 0,
                       const Eigen::Vector3d& size = {2, 2, 2}) const {
    return {.category = "frame",
            .true_model = true_model,
            .true_size = size,
            .shape = {Eigen::Vector2d(first, second), size, std::nullopt}};
  }

  TempFolder folder;
  std::vector<CategoryModel> models{TwoModeFrames()};
  InstanceLibrary library;

 private:
  void WriteSurface(const std::string& name, double height) const {
    folder.Write(name,
                 fmt::format("OFF\n4 1 0\n-0.01 {0} -0.01\n0.01 {0} -0.01\n0.01 {0} 0.01\n-0.01 {0} 0.01\n"
                             "4 0 1 2 3\n",
                             height));
  }
};

}  // namespace armature::testing
