// SPDX-License-Identifier: BSD-3-Clause
#include "eval/trajectories/unmatched_stamps.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/statistics.h"
#include "eval/trajectories/pose_pairs.h"
#include "geometry/rotation.h"
#include "io/stamps.h"
#include "odometry/odometry.h"

namespace armature {
namespace {

constexpr int kMostSamples = 2000;     // of a motion; the work grows with the square
constexpr double kAlike = 0.7;         // correlation from which two motions are alike
constexpr double kLeastOverlap = 0.5;  // of the shorter motion

Eigen::Isometry3d PoseAt(const std::vector<TimedPose>& poses, double timestamp) {
  const auto after = std::lower_bound(poses.begin(), poses.end(), timestamp,
                                      [](const TimedPose& pose, double t) { return pose.timestamp < t; });
  if (after == poses.begin()) return poses.front().pose;
  if (after == poses.end()) return poses.back().pose;
  return InterpolatePose(*(after - 1), *after, timestamp);
}

// How fast the camera moves and turns, each over its mean, sampled at equal steps from `start`.
std::vector<double> SampleSpeeds(const std::vector<TimedPose>& poses, double start, double step,
                                 size_t count) {
  std::vector<double> moved, turned;
  Eigen::Isometry3d before = PoseAt(poses, start);
  for (size_t i = 1; i <= count; ++i) {
    const Eigen::Isometry3d pose = PoseAt(poses, start + static_cast<double>(i) * step);
    moved.push_back((pose.translation() - before.translation()).norm());
    turned.push_back(LogSO3(before.linear().transpose() * pose.linear()).norm());
    before = pose;
  }
  std::vector<double> speeds(count, 0);
  for (const std::vector<double>* part : {&moved, &turned}) {
    double sum = 0;
    for (const double value : *part) sum += value;
    if (sum <= 1e-9 * static_cast<double>(count)) continue;
    for (size_t i = 0; i < count; ++i) speeds[i] += (*part)[i] * static_cast<double>(count) / sum;
  }
  return speeds;
}

// Of a[i] with b[i + lag] where both are; 0 where they are constant.
double Correlate(const std::vector<double>& a, const std::vector<double>& b, long lag) {
  const long begin = std::max(0L, -lag);
  const long end = std::min(static_cast<long>(a.size()), static_cast<long>(b.size()) - lag);
  const auto n = static_cast<double>(end - begin);
  double sa = 0, sb = 0, saa = 0, sbb = 0, sab = 0;
  for (long i = begin; i < end; ++i) {
    const double x = a[static_cast<size_t>(i)], y = b[static_cast<size_t>(i + lag)];
    sa += x, sb += y, saa += x * x, sbb += y * y, sab += x * y;
  }
  const double va = saa - sa * sa / n, vb = sbb - sb * sb / n;
  return va <= 1e-9 * n || vb <= 1e-9 * n ? 0 : (sab - sa * sb / n) / std::sqrt(va * vb);
}

double Duration(const std::vector<TimedPose>& poses) {
  return poses.back().timestamp - poses.front().timestamp;
}

double MedianStep(const std::vector<TimedPose>& poses) {
  std::vector<double> steps;
  for (size_t i = 1; i < poses.size(); ++i) steps.push_back(poses[i].timestamp - poses[i - 1].timestamp);
  return Median(steps);
}

struct Offset {
  double seconds = 0, correlation = -1;
};

// To a step.
Offset FindCoarseOffset(const std::vector<TimedPose>& estimate, const std::vector<TimedPose>& truth,
                        double step) {
  const auto count = [&](const std::vector<TimedPose>& poses) {
    return static_cast<size_t>(Duration(poses) / step);
  };
  const auto a = SampleSpeeds(estimate, estimate.front().timestamp, step, count(estimate));
  const auto b = SampleSpeeds(truth, truth.front().timestamp, step, count(truth));
  const auto n = static_cast<long>(a.size()), m = static_cast<long>(b.size());
  const auto least = std::max(3L, static_cast<long>(kLeastOverlap * static_cast<double>(std::min(n, m))));
  Offset best;
  for (long lag = least - n; lag <= m - least; ++lag) {
    const double correlation = Correlate(a, b, lag);
    if (correlation <= best.correlation) continue;
    best = {truth.front().timestamp - estimate.front().timestamp + static_cast<double>(lag) * step,
            correlation};
  }
  return best;
}

// Around a coarse one, ten times finer and finer.
Offset Refine(const std::vector<TimedPose>& estimate, const std::vector<TimedPose>& truth, double step,
              const Offset& coarse) {
  Offset best = coarse;
  const double begin = std::max(estimate.front().timestamp, truth.front().timestamp - coarse.seconds + step);
  const double end = std::min(estimate.back().timestamp, truth.back().timestamp - coarse.seconds - step);
  if (end - begin < 3 * step) return best;
  const auto count = static_cast<size_t>((end - begin) / step);
  const auto a = SampleSpeeds(estimate, begin, step, count);
  best.correlation = -1;
  for (double finer = step; finer > 1e-4 * step; finer /= 10) {
    const double centre = best.correlation < 0 ? coarse.seconds : best.seconds;
    for (int i = -10; i <= 10; ++i) {
      const double seconds = centre + 0.1 * i * finer;
      const double correlation = Correlate(a, SampleSpeeds(truth, begin + seconds, step, count), 0);
      if (correlation > best.correlation) best = {seconds, correlation};
    }
  }
  return best;
}

std::vector<TimedPose> Shifted(std::vector<TimedPose> poses, double seconds) {
  for (TimedPose& pose : poses) pose.timestamp += seconds;
  return poses;
}

// The unit of one of them, if in it both would be at the same time: "nanoseconds".
std::optional<std::string> GuessUnit(const std::vector<TimedPose>& poses,
                                     const std::vector<TimedPose>& others) {
  for (const auto& [per_second, name] :
       {std::pair{1e3, "milliseconds"}, {1e6, "microseconds"}, {1e9, "nanoseconds"}}) {
    const double first = poses.front().timestamp / per_second, last = poses.back().timestamp / per_second;
    const bool is_short = last - first > 2 * Duration(others) || last - first < 0.01 * Duration(others);
    if (!is_short && first <= others.back().timestamp && last >= others.front().timestamp) return name;
  }
  return GuessStampUnit(poses.back().timestamp);
}

// The roundest number that is as good: clocks differ by whole hours, recordings start at whole seconds.
double RoundedWithin(double seconds, double tolerance) {
  for (const double step : {1.0, 0.1, 0.01}) {
    const double rounded = std::round(seconds / step) * step;
    if (std::abs(rounded - seconds) <= 0.5 * tolerance) return rounded;
  }
  return std::round(seconds * 1e3) / 1e3;
}

std::string Suggest(const std::vector<TimedPose>& estimate, const std::vector<TimedPose>& truth,
                    double tolerance) {
  if (const auto unit = GuessUnit(estimate, truth))
    return fmt::format("is the estimate in {}? write seconds", *unit);
  if (const auto unit = GuessUnit(truth, estimate))
    return fmt::format("is the truth in {}? write seconds", *unit);
  if (const auto offset = FindTimeOffset(estimate, truth)) {
    const double rounded = RoundedWithin(*offset, tolerance);
    const size_t matched = PairPoses(Shifted(estimate, rounded), truth, tolerance).size();
    if (matched > 0) {
      return fmt::format("shifted by {:.10g} s? with --time-offset {:.10g} {} of {} poses have a true one",
                         -rounded, rounded, matched, estimate.size());
    }
  }
  return "compare the stamps; --time-offset adds seconds to the estimate's, --tolerance allows more between";
}

}  // namespace

std::optional<double> FindTimeOffset(const std::vector<TimedPose>& estimate,
                                     const std::vector<TimedPose>& truth) {
  if (estimate.size() < 4 || truth.size() < 4) return std::nullopt;
  const double step = std::max({MedianStep(estimate), MedianStep(truth), Duration(estimate) / kMostSamples,
                                Duration(truth) / kMostSamples});
  if (!(step > 0)) return std::nullopt;
  const Offset coarse = FindCoarseOffset(estimate, truth, step);
  const Offset fine = Refine(estimate, truth, step, coarse);
  return std::max(coarse.correlation, fine.correlation) < kAlike ? std::nullopt : std::optional(fine.seconds);
}

std::string ExplainUnmatched(const std::vector<TimedPose>& estimate, const std::vector<TimedPose>& truth,
                             double tolerance_seconds) {
  return fmt::format(
      "no pose has a true one within {:g} ms: the stamps go from {}, the true ones from {}; {}",
      1e3 * tolerance_seconds, DescribeStampRange(estimate.front().timestamp, estimate.back().timestamp),
      DescribeStampRange(truth.front().timestamp, truth.back().timestamp),
      Suggest(estimate, truth, tolerance_seconds));
}

}  // namespace armature
