// SPDX-License-Identifier: BSD-3-Clause
#include "eval/detections/lasting.h"

#include <algorithm>
#include <cmath>

namespace armature {
namespace {

struct ErrorMoments {
  double mean = 0, variance = 0;
};

ErrorMoments MomentsOf(const std::vector<ErrorSeries>& series) {
  double count = 0, sum = 0, squares = 0;
  for (const ErrorSeries& one : series) {
    for (const double error : one.errors) {
      ++count;
      sum += error;
      squares += error * error;
    }
  }
  if (count == 0) return {};
  const double mean = sum / count;
  return {mean, squares / count - mean * mean};
}

std::optional<double> MeanLength(long frames, long runs, double step) {
  if (runs == 0) return std::nullopt;
  return static_cast<double>(frames) * step / static_cast<double>(runs);
}

}  // namespace

std::optional<double> CorrelationAfter(const std::vector<ErrorSeries>& series, double lag) {
  constexpr double kWithin = 0.25;
  constexpr int kLeastPairs = 10;
  const auto [mean, variance] = MomentsOf(series);
  double sum = 0;
  int pairs = 0;
  for (const ErrorSeries& one : series) {
    for (size_t i = 0; i < one.times.size(); ++i) {
      for (size_t j = i + 1; j < one.times.size(); ++j) {
        const double apart = one.times[j] - one.times[i];
        if (apart > (1 + kWithin) * lag) break;
        if (apart < (1 - kWithin) * lag) continue;
        sum += (one.errors[i] - mean) * (one.errors[j] - mean);
        ++pairs;
      }
    }
  }
  if (pairs < kLeastPairs || variance <= 0) return std::nullopt;
  return sum / pairs / variance;
}

void RunLengths::Add(bool is_on) {
  if (is_on) {
    ++frames_;
    if (!was_on_) ++runs_;
  }
  was_on_ = is_on;
}

std::optional<double> RunLengths::Mean(double step) const { return MeanLength(frames_, runs_, step); }

void BoxLengths::AddFrame(const std::vector<Box>& boxes) {
  constexpr double kSame = 0.5;
  for (const Box& box : boxes) {
    ++all_;
    const auto goes_on = std::find_if(last_.begin(), last_.end(), [&](const Box& last) {
      return IntersectionOverUnion(last, box) >= kSame;
    });
    if (goes_on == last_.end()) {
      ++begun_;
    } else {
      last_.erase(goes_on);
    }
  }
  last_ = boxes;
}

std::optional<double> BoxLengths::Mean(double step) const { return MeanLength(all_, begun_, step); }

}  // namespace armature
