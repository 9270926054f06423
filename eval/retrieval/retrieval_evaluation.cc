// SPDX-License-Identifier: BSD-3-Clause
#include "eval/retrieval/retrieval_evaluation.h"

#include <algorithm>
#include <map>
#include <numeric>

#include "base/interrupt.h"
#include "category/category_lookup.h"
#include "geometry/random.h"

namespace armature {
namespace {

RetrievalOptions AllCandidates(RetrievalOptions options) {
  options.k = options.candidates;
  options.radius = 0;
  return options;
}

constexpr int kFirstFew = 5;
constexpr int kRandomPicks = 50;
constexpr std::uint64_t kPickSeed = 1;

// Rankings of one way of retrieval by category, each made when it is first needed.
class Rankings {
 public:
  explicit Rankings(const RetrievalOptions& options) : options_(options) {}

  const InstanceRanking& Of(const CategoryModel& model, const CategoryInstances& instances) {
    return by_category_.try_emplace(instances.category, model, instances, options_).first->second;
  }

 private:
  RetrievalOptions options_;
  std::map<std::string, InstanceRanking> by_category_;
};

std::optional<SurfaceDistance> NearestSurface(const std::vector<int>& others, DistancesFromTruth& distances) {
  std::optional<SurfaceDistance> nearest;
  for (size_t i = 0; i < std::min<size_t>(others.size(), kFirstFew); ++i) {
    const std::optional<SurfaceDistance> distance = distances.To(others[i]);
    if (distance && (!nearest || distance->chamfer < nearest->chamfer)) nearest = distance;
  }
  return nearest;
}

std::optional<SurfaceDistance> FirstSurface(const std::vector<int>& others, DistancesFromTruth& distances) {
  return others.empty() ? std::nullopt : distances.To(others.front());
}

// In an order that is the same for all queries of a category, so that few surfaces are read.
std::vector<int> Shuffled(int instances) {
  std::vector<int> order(static_cast<size_t>(instances));
  std::iota(order.begin(), order.end(), 0);
  Random random(kPickSeed);
  for (size_t left = order.size(); left > 1; --left)
    std::swap(order[left - 1], order[static_cast<size_t>(random.Uniform(0, 1) * static_cast<double>(left))]);
  return order;
}

std::optional<double> MeanChamfer(const std::vector<int>& instances, int most,
                                  DistancesFromTruth& distances) {
  double sum = 0;
  int known = 0;
  for (const int instance : instances) {
    if (known == most) break;
    const std::optional<SurfaceDistance> distance = distances.To(instance);
    if (!distance) continue;
    sum += distance->chamfer;
    ++known;
  }
  return known > 0 ? std::optional<double>(sum / known) : std::nullopt;
}

// The true model's edges stretched to the true object's size.
ShapeQuery TrueShape(const CategoryModel& model, Wireframe edges, const Eigen::Vector3d& scale,
                     const Eigen::Vector3d& size) {
  edges.midpoints = scale.asDiagonal() * edges.midpoints;
  edges.directions = scale.asDiagonal() * edges.directions;
  return {CoefficientsFromWireframe(model, edges), size, std::nullopt};
}

ShapeQuery MeanShape(const CategoryModel& model) {
  return {Eigen::VectorXd::Zero(model.modes()),
          BoundingBoxSize(WireframeFromVector(model.mean)) + 2 * model.spec.padding, std::nullopt};
}

}  // namespace

// A query with what is known of its answer. Without instances of its category in the library: nothing.
struct RetrievalEvaluation::Asked {
  const RetrievalQuery* query = nullptr;
  const CategoryModel* model = nullptr;
  const CategoryInstances* instances = nullptr;    // of the library
  int true_instance = -1;                          // among them
  const std::vector<bool>* has_surface = nullptr;  // one an instance
  std::optional<ShapeQuery> true_shape;            // none: the true model is not known
  std::optional<DistancesFromTruth> distances;     // there where `instances` are

  std::vector<int> Others(std::vector<int> ranking) const {
    std::erase_if(ranking, [this](int instance) {
      return instance == true_instance || !(*has_surface)[static_cast<size_t>(instance)];
    });
    return ranking;
  }
};

RetrievalEvaluation::RetrievalEvaluation(const std::vector<RetrievalQuery>& queries,
                                         const std::vector<CategoryModel>& models,
                                         const InstanceLibrary& library, const InstanceLibrary& true_models,
                                         int points)
    : library_(library), points_(points), surfaces_(library, points) {
  for (const CategoryInstances& instances : library.categories) {
    std::vector<bool>& has_surface = has_surface_[instances.category];
    for (int i = 0; i < instances.size(); ++i) has_surface.push_back(HasSurface(library, instances, i));
  }
  for (const RetrievalQuery& query : queries) {
    ThrowIfInterrupted();
    Add(query, LookUpModel(models, query.category), true_models);
  }
}

void RetrievalEvaluation::Add(const RetrievalQuery& query, const CategoryModel& model,
                              const InstanceLibrary& true_models) {
  Asked& asked = asked_.emplace_back();
  asked.query = &query;
  asked.model = &model;
  asked.instances = library_.Of(query.category);
  if (!asked.instances) return;
  asked.true_instance = asked.instances->Find(query.true_model);
  asked.has_surface = &has_surface_.at(query.category);
  std::optional<SurfacePoints> true_surface;
  const CategoryInstances* known = true_models.Of(query.category);
  if (const int i = known ? known->Find(query.true_model) : -1; i >= 0) {
    const Eigen::Vector3d scale = query.true_size.cwiseQuotient(known->sizes.col(i).cast<double>());
    asked.true_shape = TrueShape(model, known->MakeWireframe(i), scale, query.true_size);
    true_surface = FindSurface(true_models, *known, i, scale, points_);
  }
  asked.distances.emplace(std::move(true_surface), *asked.instances, surfaces_);
}

RetrievalEvaluation::~RetrievalEvaluation() = default;

RetrievalOutcome RetrievalEvaluation::Judge(Asked& asked, const std::vector<int>& ranking,
                                            const std::vector<int>& by_truth) {
  const std::vector<int> others = asked.Others(ranking);
  RetrievalOutcome outcome;
  outcome.rank = FindRank(asked.true_instance, ranking);
  if (!others.empty()) outcome.first_other = others.front();
  outcome.retrieved = FirstSurface(others, *asked.distances);
  outcome.best_of_five = NearestSurface(others, *asked.distances);
  outcome.by_truth = FirstSurface(asked.Others(by_truth), *asked.distances);
  return outcome;
}

std::vector<RetrievalOutcome> RetrievalEvaluation::Evaluate(const RetrievalOptions& options) {
  Rankings rankings(options);
  std::vector<RetrievalOutcome> outcomes;
  for (Asked& asked : asked_) {
    ThrowIfInterrupted();
    outcomes.emplace_back();
    if (!asked.instances) continue;
    const InstanceRanking& ranking = rankings.Of(*asked.model, *asked.instances);
    const auto& sightings = asked.query->sightings;
    outcomes.back() = Judge(asked, ranking.Of(asked.query->shape, sightings ? &*sightings : nullptr),
                            asked.true_shape ? ranking.Of(*asked.true_shape, nullptr) : std::vector<int>());
  }
  return outcomes;
}

std::vector<RetrievalBaselines> RetrievalEvaluation::Baselines() {
  RetrievalOptions by_shape;
  by_shape.rerank = false;
  Rankings rankings(by_shape);
  std::vector<RetrievalBaselines> all;
  for (Asked& asked : asked_) {
    ThrowIfInterrupted();
    RetrievalBaselines& baselines = all.emplace_back();
    if (!asked.instances) continue;
    const InstanceRanking& ranking = rankings.Of(*asked.model, *asked.instances);
    const std::vector<int> by_mean = asked.Others(ranking.Of(MeanShape(*asked.model), nullptr));
    if (const auto nearest = FirstSurface(by_mean, *asked.distances)) baselines.mean_shape = nearest->chamfer;
    baselines.random =
        MeanChamfer(asked.Others(Shuffled(asked.instances->size())), kRandomPicks, *asked.distances);
  }
  return all;
}

InstanceRanking::InstanceRanking(const CategoryModel& model, const CategoryInstances& instances,
                                 const RetrievalOptions& options)
    : candidates_(model, instances, AllCandidates(options), BuildIndex(model, instances, options)) {}

std::vector<int> InstanceRanking::Of(const ShapeQuery& query, const ObjectSightings* sightings) const {
  const int all = candidates_.instances().size();
  std::vector<int> ranking;
  std::vector<bool> is_ranked(static_cast<size_t>(all));
  const auto add = [&](int instance) {
    if (is_ranked[static_cast<size_t>(instance)]) return;
    is_ranked[static_cast<size_t>(instance)] = true;
    ranking.push_back(instance);
  };
  for (const RetrievedInstance& candidate : candidates_.Retrieve(query, sightings)) add(candidate.instance);
  for (const Neighbour& neighbour : candidates_.Nearest(query, std::max(all, 1))) add(neighbour.instance);
  return ranking;
}

std::optional<int> FindRank(int instance, const std::vector<int>& ranking) {
  const auto found = std::find(ranking.begin(), ranking.end(), instance);
  if (found == ranking.end()) return std::nullopt;
  return static_cast<int>(found - ranking.begin()) + 1;
}

}  // namespace armature
