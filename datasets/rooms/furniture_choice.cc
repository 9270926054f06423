// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/rooms/furniture_choice.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/errors.h"
#include "category/normalise.h"
#include "datasets/cad/lid.h"
#include "datasets/cad/resized.h"

namespace armature {
namespace {

constexpr double kOwnShare = 0.25;  // of our own families where other collections have the category

// Tables that are not of a usual height have smaller tops.
constexpr double kCoffeeHeight = 0.6, kCoffeeTop = 0.8;
constexpr double kHighHeight = 0.9, kHighTop = 0.85;

using CandidateList = std::vector<const CadInstance*>;

const MetricReference& FindReference(const Furniture& furniture, const std::string& category) {
  const auto spec = std::find_if(furniture.specs.begin(), furniture.specs.end(),
                                 [&](const TrainingSpec& s) { return s.category.name == category; });
  if (spec == furniture.specs.end()) std::abort();
  return spec->category.reference;
}

// By collection, in their order.
std::vector<CandidateList> ListCandidates(const Furniture& furniture, const std::string& category,
                                          const Eigen::Vector2d& at_most) {
  std::vector<CandidateList> collections;
  for (const CadInstance& instance : furniture.collection) {
    if (instance.category != category || !instance.held_out) continue;
    if (instance.size.x() > at_most.x() || instance.size.z() > at_most.y()) continue;
    const bool is_known =
        !collections.empty() && collections.back().front()->collection == instance.collection;
    if (!is_known) collections.emplace_back();
    collections.back().push_back(&instance);
  }
  return collections;
}

size_t PickIndex(size_t count, Random& random) {
  return static_cast<size_t>(random.Uniform(0, static_cast<double>(count)));
}

double TopFactor(double height) {
  if (height < kCoffeeHeight) return kCoffeeTop;
  return height > kHighHeight ? kHighTop : 1;
}

}  // namespace

CadInstance DrawInstance(const Furniture& furniture, const std::string& category,
                         const Eigen::Vector2d& at_most, Random& random) {
  const std::vector<CandidateList> collections = ListCandidates(furniture, category, at_most);
  if (collections.empty())
    throw InputError(
        fmt::format("no held-out {} of at most {} x {} m is in the collections; give larger ones", category,
                    at_most.x(), at_most.y()));
  const bool is_own = random.Uniform(0, 1) < kOwnShare;
  const bool has_own = collections.front().front()->collection == CadInstance().collection;
  const size_t first = has_own && !is_own && collections.size() > 1 ? 1 : 0;
  const size_t chosen = has_own && is_own ? 0 : first + PickIndex(collections.size() - first, random);
  const CandidateList& candidates = collections[chosen];
  return Loaded(*candidates[PickIndex(candidates.size(), random)]);
}

double MeasureOf(const Furniture& furniture, const CadInstance& instance) {
  return Measure(FindReference(furniture, instance.category), instance.wireframe);
}

CadInstance InDrawnSize(const Furniture& furniture, CadInstance instance, const FurnitureRecipe& sizes,
                        Random& random) {
  if (instance.category == "laptop") instance = WithLid(instance, DrawNumber(sizes.lid_deg, random));
  const double measure = MeasureOf(furniture, instance);
  const double usual = FindReference(furniture, instance.category).metres;
  Eigen::Vector3d factors;
  if (instance.category == "chair") {
    const double flat = DrawNumber(sizes.chair_size, random) * usual / measure;
    factors = {flat, DrawNumber(sizes.seat_height, random) / measure, flat};
  } else if (instance.category == "table") {
    const double height = DrawNumber(sizes.table_height, random), flat = TopFactor(height) * usual / measure;
    factors = {flat, height / measure, flat};
  } else {
    factors = Eigen::Vector3d::Constant(DrawNumber(sizes.laptop_width, random) / measure);
  }
  return Resized(instance, instance.size.cwiseProduct(factors).unaryExpr(&RoundDrawn));
}

}  // namespace armature
