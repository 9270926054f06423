// SPDX-License-Identifier: BSD-3-Clause
#include "mapping/object_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <queue>

#include "mapping/object_association.h"

namespace armature {
namespace {

// Of a view's distance: its own estimate may be off, the more so where the box is cut or hidden.
constexpr std::array kDistances{1.0, 0.72, 0.85, 1.18, 1.4};
constexpr double kNearest = 0.3;  // metres before the camera
constexpr double kWidest = 2;     // tangent of the angle off the optical axis beyond which nothing is seen

// All in logarithms of likelihoods.
constexpr double kLeastEvidence = 0.5;  // of a detection that is explained
constexpr double kObjectCost = 6;       // of there being an object
constexpr double kMissCost = 0.25;      // of a frame that shows all of it, where it was not detected
constexpr double kSeenFrom = 5;         // metres: from farther, nothing is missed

// Where a box's side is, over the box's size: mostly as precisely as simulated boxes, often as roughly as a
// network's, seldom anywhere; or nearer to the middle, for something hides the object there.
constexpr double kFine = 0.045, kFinePixels = 2, kRough = 0.13;
constexpr double kFineShare = 0.6, kRoughShare = 0.38, kAnywhere = 0.01;
constexpr std::array kHidden{0.15, 0.05, 0.15, 0.3};  // left, top, right, bottom
constexpr double kCutLikelihood = 0.6;  // of a side that the image's border cuts: says next to nothing
constexpr double kChance = 0.5;         // likelihood of a side of a detection of something else
constexpr double kFarthestSide = 0.6;   // over the box's size, and not hidden: not of this object

// Where the camera's height above the floor is known: share of it by which what stands on the floor may be
// mistaken, and what it costs at most to be elsewhere.
constexpr double kHeightSigma = 0.1, kMostHeightCost = 8;

constexpr double kOccupied = 0.2;  // intersection over union: no room for another of the category

double Density(double x, double sigma) {
  constexpr double kRootTwoPi = 2.5066282746310002;
  return std::exp(-0.5 * x * x / (sigma * sigma)) / (kRootTwoPi * sigma);
}

using Sides = std::array<double, 4>;  // pixels: left, top, right, bottom

// One detection that may be explained.
struct SeenView {
  size_t frame = 0, observation = 0;
  const CategoryModel* model = nullptr;
  Sides sides{}, size{};  // size: of the box along the axis that the side moves along
  std::array<bool, 4> is_cut{};
  Sides hidden{};  // probability
  Sides fine{};    // standard deviation of a side that is boxed precisely, over the box's size
};

SeenView MakeSeenView(const std::vector<MapFrame>& frames, size_t i, size_t j) {
  const ObjectView& view = frames[i].observations[j].view;
  const Box& box = view.detection.box;
  SeenView seen{i, j, view.model, {box.left(), box.top(), box.right(), box.bottom()}, {}, {}, {}, {}};
  for (size_t side = 0; side < 4; ++side) {
    seen.size[side] = side % 2 == 0 ? box.width : box.height;
    seen.fine[side] = std::hypot(kFine, kFinePixels / seen.size[side]);
    seen.is_cut[side] = view.sides[side] == BoxSide::kOpen;
    seen.hidden[side] = std::max(kHidden[side], view.hidden_probability[side]);
  }
  return seen;
}

// How much likelier the detection is if it is of what is expected there; none if it hardly can be.
std::optional<double> ComputeEvidence(const Sides& expected, const SeenView& seen, const Camera& camera) {
  const Sides border{0, 0, camera.width - 1.0, camera.height - 1.0};
  double likelihood = 1;
  for (size_t side = 0; side < 4; ++side) {
    const bool is_low = side < 2;
    const double at =
        is_low ? std::max(expected[side], border[side]) : std::min(expected[side], border[side]);
    // Positive where the box goes on beyond what is expected.
    const double beyond = (is_low ? at - seen.sides[side] : seen.sides[side] - at) / seen.size[side];
    if (beyond > kFarthestSide || beyond < -4) return std::nullopt;
    const double at_side =
        kFineShare * Density(beyond, seen.fine[side]) + kRoughShare * Density(beyond, kRough) + kAnywhere;
    // What is hidden may be boxed anywhere along the object.
    double of_side = (1 - seen.hidden[side]) * at_side + (beyond < 0 ? seen.hidden[side] / (1 - beyond) : 0);
    if (seen.is_cut[side]) of_side = std::min(of_side, kCutLikelihood);
    likelihood *= of_side / kChance;
  }
  const double evidence = std::log(likelihood);
  if (evidence < kLeastEvidence) return std::nullopt;
  return evidence;
}

// The single view that candidates are made of.
struct Source {
  SeenView view;
  Eigen::Matrix3Xd ends;  // of all edges from the object's centre, axes of the world
  double below = 0;       // metres, along up: of the object's lowest point, from its centre
};

Source MakeSource(const MapObservation& observation, const SeenView& view,
                  const Eigen::Isometry3d& T_world_camera, const Eigen::Vector3d& up_world) {
  const Wireframe wireframe = WireframeFromCoefficients(*view.model, observation.measured.coefficients);
  const Eigen::Matrix3d R = T_world_camera.linear() * observation.measured.T_camera_object.linear();
  Source source{view, Eigen::Matrix3Xd(3, 2 * wireframe.edges())};
  source.ends << R * (wireframe.midpoints - 0.5 * wireframe.directions),
      R * (wireframe.midpoints + 0.5 * wireframe.directions);
  source.below = -(up_world.transpose() * source.ends).minCoeff();
  return source;
}

// The sides of the projection, not cut at the image's border.
Sides ProjectSides(const Camera& camera, const Eigen::Vector3d& center, const Eigen::Matrix3Xd& ends_camera,
                   double padding) {
  Sides sides{1e9, 1e9, -1e9, -1e9};
  for (Eigen::Index k = 0; k < ends_camera.cols(); ++k) {
    const double inverse_z = 1 / std::max(center.z() + ends_camera(2, k), 0.5 * kNearest);
    const double x = (center.x() + ends_camera(0, k)) * inverse_z;
    const double y = (center.y() + ends_camera(1, k)) * inverse_z;
    const double pad = padding * inverse_z;
    sides[0] = std::min(sides[0], x - pad);
    sides[1] = std::min(sides[1], y - pad);
    sides[2] = std::max(sides[2], x + pad);
    sides[3] = std::max(sides[3], y + pad);
  }
  for (const size_t side : {0, 2}) sides[side] = sides[side] * camera.fx + camera.cx;
  for (const size_t side : {1, 3}) sides[side] = sides[side] * camera.fy + camera.cy;
  return sides;
}

bool AreWholeInImage(const Sides& sides, const Camera& camera) {
  return sides[0] > 0 && sides[1] > 0 && sides[2] < camera.width && sides[3] < camera.height;
}

struct Explained {
  size_t frame = 0, observation = 0;
  double evidence = 0;
};

struct Candidate {
  size_t source = 0;
  Eigen::Vector3d center;  // metres, world
  std::vector<Explained> explained;
  double cost = 0;  // of frames that should show it, and of where it stands
};

// So many of `count` at most, evenly.
std::vector<size_t> SelectEvenly(size_t count, size_t most) {
  std::vector<size_t> selected;
  const double step = std::max(1.0, static_cast<double>(count) / static_cast<double>(most));
  for (double at = 0; at < static_cast<double>(count); at += step)
    selected.push_back(static_cast<size_t>(at));
  return selected;
}

class Search {
 public:
  Search(const std::vector<MapFrame>& frames, const std::vector<Eigen::Isometry3d>& T_world_camera,
         const ObjectSearchOptions& options)
      : frames_(frames), T_world_camera_(T_world_camera), options_(options), seen_(frames.size()) {
    for (size_t i = 0; i < frames.size(); ++i) {
      taken_.emplace_back(frames[i].observations.size(), false);
      for (size_t j = 0; j < frames[i].observations.size(); ++j) {
        if (frames[i].observations[j].view.model) seen_[i].push_back(MakeSeenView(frames, i, j));
      }
    }
    AddCandidates();
    const std::vector<size_t> asked = SelectEvenly(frames.size(), options.most_frames);
    for (size_t s = 0; s < sources_.size(); ++s) {
      for (const size_t i : asked) Explain(s, i);
    }
  }

  std::vector<ObjectCandidate> TakeBest() {
    using Entry = std::pair<double, size_t>;  // support when it was put in: it only falls
    const auto is_worse = [](const Entry& a, const Entry& b) {
      return a.first < b.first || (a.first == b.first && a.second > b.second);
    };
    std::priority_queue<Entry, std::vector<Entry>, decltype(is_worse)> queue(is_worse);
    for (size_t c = 0; c < candidates_.size(); ++c) {
      const double support = Support(candidates_[c]).support;
      if (support > 0) queue.push({support, c});
    }
    std::vector<ObjectCandidate> found;
    while (!queue.empty()) {
      const auto [then, c] = queue.top();
      queue.pop();
      ObjectCandidate now = Support(candidates_[c]);
      if (now.support <= 0 || static_cast<int>(now.views.size()) < options_.least_observations) continue;
      if (now.support < then - 1e-9) {
        queue.push({now.support, c});
        continue;
      }
      now.object = MakeObject(candidates_[c]);
      if (IsOccupied(now.object, found)) continue;
      for (const auto& [i, j] : now.views) taken_[i][j] = true;
      found.push_back(std::move(now));
    }
    return found;
  }

 private:
  void AddCandidates() {
    std::vector<const SeenView*> all;
    for (const std::vector<SeenView>& of_frame : seen_) {
      for (const SeenView& view : of_frame) all.push_back(&view);
    }
    for (const size_t k : SelectEvenly(all.size(), options_.most_views)) {
      const SeenView& view = *all[k];
      const MapObservation& observation = frames_[view.frame].observations[view.observation];
      const Eigen::Vector3d up_world = T_world_camera_[view.frame].linear() * frames_[view.frame].up_camera;
      sources_.push_back(MakeSource(observation, view, T_world_camera_[view.frame], up_world));
      for (const double distance : kDistances) {
        const Eigen::Vector3d t = distance * observation.measured.T_camera_object.translation();
        candidates_.push_back(
            {sources_.size() - 1, T_world_camera_[view.frame] * t, {}, HeightCost(sources_.back(), t)});
      }
    }
  }

  // Of an object with its centre at t in the source's camera, metres, that should stand on the floor.
  double HeightCost(const Source& source, const Eigen::Vector3d& t) const {
    const MapFrame& frame = frames_[source.view.frame];
    if (!frame.camera_height || !source.view.model->spec.stands_on_floor) return 0;
    const auto& [height, sigma] = *frame.camera_height;
    const double off = source.below - frame.up_camera.dot(t) - height;
    return std::min(kMostHeightCost, 0.5 * std::pow(off / std::hypot(sigma, kHeightSigma * height), 2));
  }

  // What the candidates of one source explain in one frame.
  void Explain(size_t s, size_t i) {
    if (frames_[i].observations.empty()) return;
    const Camera& camera = *frames_[i].observations.front().view.camera;
    const Source& source = sources_[s];
    const Eigen::Matrix3d R_camera_world = T_world_camera_[i].linear().transpose();
    Eigen::Matrix3Xd ends_camera;
    for (size_t d = 0; d < kDistances.size(); ++d) {
      Candidate& candidate = candidates_[s * kDistances.size() + d];
      const Eigen::Vector3d at = R_camera_world * (candidate.center - T_world_camera_[i].translation());
      if (at.z() < kNearest || at.head<2>().cwiseAbs().maxCoeff() > kWidest * at.z()) continue;
      if (ends_camera.cols() == 0) ends_camera = R_camera_world * source.ends;
      const Sides sides = ProjectSides(camera, at, ends_camera, source.view.model->spec.padding.x());
      bool is_detected = false;
      for (const SeenView& view : seen_[i]) {
        if (view.model != source.view.model) continue;
        const auto evidence = ComputeEvidence(sides, view, camera);
        if (!evidence) continue;
        candidate.explained.push_back({i, view.observation, *evidence});
        is_detected = true;
      }
      if (!is_detected && at.z() < kSeenFrom && AreWholeInImage(sides, camera)) candidate.cost += kMissCost;
    }
  }

  // By what is not taken; one detection a frame.
  ObjectCandidate Support(const Candidate& candidate) const {
    ObjectCandidate result;
    result.support = -kObjectCost - candidate.cost;
    const std::vector<Explained>& explained = candidate.explained;
    for (size_t e = 0; e < explained.size();) {
      const size_t frame = explained[e].frame;
      const Explained* best = nullptr;
      for (; e < explained.size() && explained[e].frame == frame; ++e) {
        if (taken_[frame][explained[e].observation]) continue;
        if (best == nullptr || explained[e].evidence > best->evidence) best = &explained[e];
      }
      if (best == nullptr) continue;
      result.support += best->evidence;
      result.views.emplace_back(frame, best->observation);
    }
    return result;
  }

  GraphObject MakeObject(const Candidate& candidate) const {
    const SeenView& view = sources_[candidate.source].view;
    const PoseAndShape& measured = frames_[view.frame].observations[view.observation].measured;
    GraphObject object{view.model, T_world_camera_[view.frame] * measured.T_camera_object,
                       measured.coefficients, 0};
    object.T_world_object.translation() = candidate.center;
    return object;
  }

  static bool IsOccupied(const GraphObject& object, const std::vector<ObjectCandidate>& found) {
    return std::any_of(found.begin(), found.end(), [&](const ObjectCandidate& other) {
      return other.object.model == object.model &&
             IntersectionOverUnion(MakeBox(other.object), MakeBox(object)) > kOccupied;
    });
  }

  const std::vector<MapFrame>& frames_;
  const std::vector<Eigen::Isometry3d>& T_world_camera_;
  const ObjectSearchOptions options_;
  std::vector<std::vector<SeenView>> seen_;  // a frame each
  std::vector<std::vector<bool>> taken_;     // frame, observation
  std::vector<Source> sources_;
  std::vector<Candidate> candidates_;  // those of a source one after the other
};

// Of cameras in rooms, metres a second: the logarithm's mean and standard deviation; and what is tried.
constexpr double kSpeed = 0.3, kSpeedSigma = 1;
constexpr double kSlowest = 0.01, kFastest = 4;
constexpr double kLongestStep = 30;  // seconds
constexpr double kCoarseStep = 1.2, kFineStep = 1.06;
constexpr int kFineSteps = 3;  // to either side of the best
constexpr ObjectSearchOptions kCoarse{150, 100, 4};
constexpr double kFoundSigma = 0.3;  // of the logarithm of the scale: the map's lines know better

// Of the way between the frames, and of the time, where not a pause between two recordings lies between them.
struct Way {
  double length = 0;  // the odometry's unit
  double seconds = 0;
};

Way MeasureWay(const std::vector<MapFrame>& frames) {
  Way way;
  for (size_t i = 1; i < frames.size(); ++i) {
    const double seconds = frames[i].timestamp - frames[i - 1].timestamp;
    if (seconds > kLongestStep || frames[i].follows_jump) continue;
    way.length += (frames[i].T_odom_camera.translation() - frames[i - 1].T_odom_camera.translation()).norm();
    way.seconds += seconds;
  }
  return way;
}

}  // namespace

std::vector<ObjectCandidate> SearchObjects(const std::vector<MapFrame>& frames,
                                           const std::vector<Eigen::Isometry3d>& T_world_camera,
                                           const ObjectSearchOptions& options) {
  return Search(frames, T_world_camera, options).TakeBest();
}

std::vector<ObjectCandidate> BreakAtGaps(const std::vector<MapFrame>& frames,
                                         const std::vector<ObjectCandidate>& candidates, double seconds,
                                         int least_observations) {
  std::vector<ObjectCandidate> pieces;
  for (const ObjectCandidate& candidate : candidates) {
    double last = -1e18;
    for (const auto& view : candidate.views) {
      const double now = frames[view.first].timestamp;
      if (now - last > seconds) pieces.push_back({candidate.object, {}, candidate.support});
      pieces.back().views.push_back(view);
      last = now;
    }
  }
  std::erase_if(pieces, [&](const ObjectCandidate& piece) {
    return static_cast<int>(piece.views.size()) < least_observations;
  });
  return pieces;
}

ScaleEstimate SearchScale(const std::vector<MapFrame>& frames, const ScaleEstimate& expected,
                          int least_observations) {
  const Way way = MeasureWay(frames);
  if (expected.sigma <= 0 || !(way.length > 0) || !(way.seconds > 0)) return expected;
  bool is_anything_found = false;
  double most = -1e18, best_speed = kSpeed;
  const auto consider = [&](double speed, ObjectSearchOptions options) {
    std::vector<Eigen::Isometry3d> T_world_camera;
    for (const MapFrame& frame : frames) {
      T_world_camera.push_back(frame.T_odom_camera);
      T_world_camera.back().translation() *= speed * way.seconds / way.length;
    }
    options.least_observations = least_observations;
    const double off = std::log(speed / kSpeed) / kSpeedSigma;
    double support = -0.5 * off * off;
    for (const ObjectCandidate& found : SearchObjects(frames, T_world_camera, options)) {
      support += found.support;
      is_anything_found = true;
    }
    if (support <= most) return;
    most = support;
    best_speed = speed;
  };
  for (double speed = kSlowest; speed < kFastest; speed *= kCoarseStep) consider(speed, kCoarse);
  const double coarse = best_speed;
  most = -1e18;  // more views support everything more
  for (int step = -kFineSteps; step <= kFineSteps; ++step) {
    consider(coarse * std::pow(kFineStep, step), ObjectSearchOptions{});
  }
  if (!is_anything_found) return expected;
  return {best_speed * way.seconds / way.length, kFoundSigma};
}

}  // namespace armature
