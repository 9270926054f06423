// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/object_estimator.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/stage_clock.h"
#include "geometry/rotation.h"
#include "geometry/viewpoint.h"
#include "pipeline/view_evidence.h"

namespace armature {
namespace {

// Tuned on office_dev and redkitchen_a.
constexpr double kPruneMargin = 3;  // hypotheses this much above the best without lines are passed by
// Hypotheses closer than this in azimuth and (share) in depth are alike: only the better is refined.
constexpr double kAlikeAzimuth = 10 * kDegree, kAlikeDepth = 0.1;
constexpr int kLeastEdges = 2;          // matched edges, fewer are too few
constexpr double kMostShapeSigmas = 3;  // a shape with a coefficient beyond this is not believed
constexpr double kAmbiguityMargin = 1;  // half a turn that costs no more than this on top is as good

double Diagonal(const Box& box) { return std::hypot(box.width, box.height); }

// The gate shrinks geometrically from the search's to the final one.
MatchGate ShrinkGate(const ObjectView& view, const AssociationOptions& options, double progress) {
  const double coarse =
      std::max(options.final_gate_pixels, options.search_gate * Diagonal(view.detection.box));
  const double ratio = options.final_gate_pixels / coarse;
  const double angle_ratio = kFinalAngleDeg / kSearchAngleDeg;
  return {coarse * std::pow(ratio, progress), kSearchAngleDeg * kDegree * std::pow(angle_ratio, progress)};
}

void Project(const ObjectView& view, const PoseAndShape& at, const BoxSides& sides, ProjectedWireframe& out) {
  ProjectWireframe(*view.camera, view.model->spec, WireframeFromCoefficients(*view.model, at.coefficients),
                   at.T_camera_object, ClipBox(view.detection.box, sides, *view.camera), view.occluders, out);
}

// A candidate on its way: from hypothesis to refined estimate.
struct Candidate {
  Hypothesis hypothesis;
  PoseAndShape estimate;
  double cost = 0;
  std::vector<EdgeMatch> matches;
  int iterations = 0;
  StopReason stop = StopReason::kMaxIterations;

  bool finite() const { return stop != StopReason::kNotFinite; }
};

OffsetSign SignOf(AssociationCost cost) {
  return cost == AssociationCost::kPrinted ? OffsetSign::kPrinted : OffsetSign::kNone;
}

double PrintedCost(const ObjectView& view, const PoseAndShape& at, const Wireframe& wireframe,
                   const AssociationOptions& options, ProjectedWireframe& scratch) {
  const Box everywhere{-1e6, -1e6, 2e6, 2e6};
  ProjectEdges(*view.camera, wireframe, at.T_camera_object, everywhere, scratch);
  return AssociateAsPrinted(scratch, view.segments, options.printed, SignOf(options.cost)).cost;
}

// None where even perfectly matched lines would leave the cost above the bound.
std::optional<double> CoverageCost(const ObjectView& view, const Hypothesis& hypothesis,
                                   const Wireframe& wireframe, const MatchGate& gate, double bound,
                                   const AssociationOptions& options, ProjectedWireframe& scratch) {
  const Eigen::Isometry3d& T = hypothesis.start.T_camera_object;
  ProjectSeenEdges(*view.camera, view.model->spec, wireframe, T,
                   ClipBox(view.detection.box, hypothesis.sides, *view.camera), scratch);
  const double prior =
      PriorCost(view, hypothesis.start, wireframe, hypothesis.sides, scratch, options.box, options.coverage);
  if (prior > bound) return std::nullopt;
  DetermineVisibility(*view.camera, view.model->spec, wireframe, T, view.occluders, scratch);
  return prior + LineCost(scratch, CoveredLength(scratch, view.segments, gate));
}

struct Ranked {
  double cost = 0;
  size_t hypothesis = 0;
};

// Algorithm 1: the cost of every hypothesis, the best first.
std::vector<Ranked> Rank(const ObjectView& view, const std::vector<Wireframe>& dictionary,
                         const std::vector<Hypothesis>& hypotheses, const AssociationOptions& options) {
  const Wireframe remembered =
      view.track_prior ? WireframeFromCoefficients(*view.model, view.track_prior->expected.coefficients)
                       : Wireframe{};
  const MatchGate gate = ShrinkGate(view, options, 0);
  ProjectedWireframe scratch;
  std::vector<Ranked> ranking;
  double best = 1e9;
  for (size_t i = 0; i < hypotheses.size(); ++i) {
    const int index = hypotheses[i].dictionary_index;
    const Wireframe& wireframe = index < 0 ? remembered : dictionary[static_cast<size_t>(index)];
    const std::optional<double> cost =
        options.cost != AssociationCost::kCoverage
            ? PrintedCost(view, hypotheses[i].start, wireframe, options, scratch)
            : CoverageCost(view, hypotheses[i], wireframe, gate, best + kPruneMargin, options, scratch);
    if (!cost) continue;
    best = std::min(best, *cost);
    ranking.push_back({*cost, i});
  }
  std::stable_sort(ranking.begin(), ranking.end(),
                   [](const Ranked& a, const Ranked& b) { return a.cost < b.cost; });
  return ranking;
}

bool AreAlike(const Hypothesis& a, const Hypothesis& b, int symmetry_order) {
  const double za = a.start.T_camera_object.translation().z(), zb = b.start.T_camera_object.translation().z();
  return std::abs(AzimuthDifference(a.azimuth, b.azimuth, symmetry_order)) < kAlikeAzimuth &&
         std::abs(za - zb) < kAlikeDepth * std::min(za, zb);
}

// The best few hypotheses that are not alike.
std::vector<Candidate> Search(const ObjectView& view, const AssociationOptions& options) {
  std::vector<Wireframe> dictionary;
  for (const Eigen::VectorXd& c : view.model->dictionary)
    dictionary.push_back(WireframeFromCoefficients(*view.model, c));
  const std::vector<Hypothesis> hypotheses =
      MakeHypotheses(view, dictionary, options.box, options.hypotheses);
  std::vector<Candidate> kept;
  for (const Ranked& ranked : Rank(view, dictionary, hypotheses, options)) {
    if (static_cast<int>(kept.size()) >= options.refined_hypotheses) break;
    const Hypothesis& hypothesis = hypotheses[ranked.hypothesis];
    const bool alike = std::any_of(kept.begin(), kept.end(), [&](const Candidate& other) {
      return AreAlike(hypothesis, other.hypothesis, view.model->spec.symmetry_order);
    });
    if (alike) continue;
    Candidate& candidate = kept.emplace_back();
    candidate.hypothesis = hypothesis;
    candidate.estimate = hypothesis.start;
    candidate.cost = ranked.cost;
  }
  return kept;
}

std::vector<EdgeMatch> Associate(const ObjectView& view, const ProjectedWireframe& projected,
                                 const MatchGate& gate, const AssociationOptions& options) {
  if (options.cost != AssociationCost::kCoverage)
    return AssociateAsPrinted(projected, view.segments, options.printed, SignOf(options.cost)).matches;
  return MatchSegments(projected, view.segments, gate).matches;
}

// One round of association and resection.
void RefineOnce(const ObjectView& view, const AssociationOptions& options, const ResectionOptions& resection,
                int round, Candidate& candidate, EstimatorTimes& times) {
  if (!candidate.finite()) return;
  ProjectedWireframe projected;
  const BoxSides& sides = candidate.hypothesis.sides;
  const double progress = options.rounds > 1 ? round / (options.rounds - 1.0) : 1.0;
  {
    const StageClock clock(times.association_ms);
    Project(view, candidate.estimate, sides, projected);
    candidate.matches = Associate(view, projected, ShrinkGate(view, options, progress), options);
  }
  const StageClock clock(times.optimization_ms);
  const ResectionResult result =
      Resect({view, sides, candidate.matches, projected, candidate.estimate, options.box, resection});
  candidate.iterations += result.iterations;
  candidate.stop = result.stop;
  if (result.finite()) candidate.estimate = result.estimate;
}

// The matches and the cost of where the rounds have led.
void Score(const ObjectView& view, const AssociationOptions& options, Candidate& candidate,
           EstimatorTimes& times) {
  const StageClock clock(times.association_ms);
  ProjectedWireframe projected;
  const BoxSides& sides = candidate.hypothesis.sides;
  Project(view, candidate.estimate, sides, projected);
  const Wireframe wireframe = WireframeFromCoefficients(*view.model, candidate.estimate.coefficients);
  if (options.cost != AssociationCost::kCoverage) {
    candidate.cost = PrintedCost(view, candidate.estimate, wireframe, options, projected);
    return;
  }
  Matching matching = MatchSegments(projected, view.segments, ShrinkGate(view, options, 1));
  candidate.matches = std::move(matching.matches);
  candidate.cost =
      PriorCost(view, candidate.estimate, wireframe, sides, projected, options.box, options.coverage) +
      LineCost(projected, matching.covered_length);
}

// Whether two candidates are on the way to the same place.
bool HaveConverged(const Candidate& a, const Candidate& b) {
  constexpr double kDistance = 0.01;  // share of the distance from the camera
  constexpr double kTurn = 1 * kDegree;
  constexpr double kShape = 0.3;  // standard deviations
  if (!a.finite() || !b.finite() || a.hypothesis.sides != b.hypothesis.sides) return false;
  const Eigen::Isometry3d &A = a.estimate.T_camera_object, &B = b.estimate.T_camera_object;
  if ((A.translation() - B.translation()).norm() > kDistance * A.translation().norm()) return false;
  if ((a.estimate.coefficients - b.estimate.coefficients).norm() > kShape) return false;
  // trace(A^T B) = 1 + 2 cos(angle)
  return A.linear().cwiseProduct(B.linear()).sum() > 1 + 2 * std::cos(kTurn);
}

// Of candidates that have met the first, which was ranked better, goes on.
void DropConverged(std::vector<Candidate>& candidates) {
  std::vector<Candidate> kept;
  for (Candidate& candidate : candidates) {
    const bool met = std::any_of(kept.begin(), kept.end(),
                                 [&](const Candidate& other) { return HaveConverged(other, candidate); });
    if (!met) kept.push_back(std::move(candidate));
  }
  candidates = std::move(kept);
}

// Association and resection in turn, with a gate that shrinks from round to round.
void Refine(const ObjectView& view, const AssociationOptions& options, const ResectionOptions& resection,
            std::vector<Candidate>& candidates, EstimatorTimes& times) {
  for (int round = 0; round < options.rounds; ++round) {
    for (Candidate& candidate : candidates) {
      RefineOnce(view, options, resection, round, candidate, times);
    }
    DropConverged(candidates);
  }
  for (Candidate& candidate : candidates) Score(view, options, candidate, times);
}

EstimateStatus Validate(const ObjectView& view, const Candidate& candidate,
                        const ProjectedWireframe& projected) {
  if (!candidate.finite() || candidate.estimate.coefficients.cwiseAbs().maxCoeff() > kMostShapeSigmas) {
    return EstimateStatus::kDiverged;
  }
  if (candidate.estimate.T_camera_object.translation().z() <= 0) return EstimateStatus::kBehindCamera;
  if (MatchedEdges(candidate.matches) < kLeastEdges) return EstimateStatus::kTooFewEdges;
  const std::optional<Box> seen = BoxAround(projected);
  if (!seen) return EstimateStatus::kOffTheBox;
  const double covered = Intersection(*seen, view.detection.box).area() / std::max(seen->area(), 1.0);
  return covered < 0.5 ? EstimateStatus::kOffTheBox : EstimateStatus::kOk;
}

// Whether the lines and the box would have it turned round as well: front and back of many chairs are told
// apart by the priors of turn alone.
bool IsAmbiguous(const ObjectView& view, const Candidate& best, const AssociationOptions& association,
                 const ResectionOptions& resection, EstimatorTimes& times) {
  if (view.model->spec.symmetry_order > 1) return false;
  ObjectView without_priors = view;
  without_priors.track_prior.reset();
  without_priors.detection.azimuth.reset();
  std::vector<Candidate> turned = {best};
  turned.front().estimate.T_camera_object.rotate(Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitY()));
  Refine(without_priors, association, resection, turned, times);
  if (!turned.front().finite()) return false;
  std::vector<Candidate> as_is = {best};
  Score(without_priors, association, as_is.front(), times);
  // Refining without the priors makes it better still: mostly the answer is known without.
  if (turned.front().cost > as_is.front().cost + kAmbiguityMargin) return false;
  Refine(without_priors, association, resection, as_is, times);
  return turned.front().cost <= as_is.front().cost + kAmbiguityMargin;
}

// By how much the best costs less than the best of those that stand or are turned elsewhere.
double MarginOver(const std::vector<Candidate>& candidates, const Candidate& best, int symmetry_order) {
  constexpr double kElsewhere = 0.15;  // share of the distance, and
  constexpr double kTurned = 15 * kDegree;
  const auto azimuth = [](const Eigen::Isometry3d& T) {
    return ViewpointFromRotation(T.linear(), T.translation()).azimuth;
  };
  const Eigen::Isometry3d& at = best.estimate.T_camera_object;
  double margin = kMostMargin;
  for (const Candidate& other : candidates) {
    if (!other.finite()) continue;
    const Eigen::Isometry3d& T = other.estimate.T_camera_object;
    const double nearer = std::min(at.translation().norm(), T.translation().norm());
    if (std::abs(AzimuthDifference(azimuth(at), azimuth(T), symmetry_order)) > kTurned ||
        std::abs(at.translation().norm() - T.translation().norm()) > kElsewhere * nearer) {
      margin = std::min(margin, other.cost - best.cost);
    }
  }
  return margin;
}

double RmsPixels(const std::vector<EdgeMatch>& matches) {
  double sum = 0;
  for (const EdgeMatch& match : matches) sum += match.cost * match.cost;
  return matches.empty() ? 0 : std::sqrt(sum / static_cast<double>(matches.size()));
}

void Measure(const ObjectView& view, const Candidate& best, const AssociationOptions& association,
             const ResectionOptions& resection, SingleViewResult& result) {
  ObjectView alone = view;
  alone.track_prior.reset();
  alone.floor.reset();
  const BoxSides& sides = best.hypothesis.sides;
  ProjectedWireframe projected;
  PoseAndShape optimum = best.estimate;
  for (int round = 0; round < 2; ++round) {
    Project(alone, optimum, sides, projected);
    const ResectionResult resected =
        Resect({alone, sides, best.matches, projected, optimum, association.box, resection});
    if (!resected.finite()) break;
    optimum = resected.estimate;
  }
  Project(alone, optimum, sides, projected);
  const ResectionInput input{alone, sides, best.matches, projected, optimum, association.box, resection};
  result.measured = MeasurementAt(input);
  result.evidence = EvidenceAt(input);
}

void Describe(const ObjectView& view, Candidate best, const AssociationOptions& association,
              const ResectionOptions& resection, SingleViewResult& result) {
  ProjectedWireframe projected;
  Project(view, best.estimate, best.hypothesis.sides, projected);
  result.initial = best.hypothesis.start;
  ObjectEstimate& estimate = result.estimate;
  estimate.T_camera_object = best.estimate.T_camera_object;
  estimate.coefficients = best.estimate.coefficients;
  estimate.status = Validate(view, best, projected);
  estimate.covariance = PoseCovariance(
      {view, best.hypothesis.sides, best.matches, projected, best.estimate, association.box, resection});
  estimate.rms_pixels = RmsPixels(best.matches);
  estimate.matches = std::move(best.matches);
  estimate.cost = best.cost;
  estimate.iterations = best.iterations;
  estimate.stop = best.stop;
}

}  // namespace

SingleViewResult EstimateObject(const ObjectView& view, const AssociationOptions& association,
                                const ResectionOptions& resection) {
  SingleViewResult result;
  EstimatorTimes& times = result.times;
  std::vector<Candidate> candidates;
  {
    const StageClock clock(times.association_ms);
    candidates = Search(view, association);
  }
  Refine(view, association, resection, candidates, times);
  const auto best = std::min_element(candidates.begin(), candidates.end(),
                                     [](const Candidate& a, const Candidate& b) { return a.cost < b.cost; });

  result.estimate.ambiguous = IsAmbiguous(view, *best, association, resection, times);
  const double margin = MarginOver(candidates, *best, view.model->spec.symmetry_order);
  const BoxSides sides = best->hypothesis.sides;
  {
    const StageClock clock(times.optimization_ms);
    Measure(view, *best, association, resection, result);
    Describe(view, std::move(*best), association, resection, result);
  }
  ObjectEstimate& estimate = result.estimate;
  if (estimate.status == EstimateStatus::kOk && association.cost == AssociationCost::kCoverage) {
    ViewEvidence evidence = CollectViewEvidence(view, sides, estimate);
    evidence.margin = margin;
    estimate.probability = ComputeProbability(evidence);
  }
  return result;
}

}  // namespace armature
