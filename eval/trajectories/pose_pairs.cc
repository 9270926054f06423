// SPDX-License-Identifier: BSD-3-Clause
#include "eval/trajectories/pose_pairs.h"

#include <algorithm>
#include <cmath>
#include <queue>
#include <tuple>

namespace armature {
namespace {

// Positions in the two trajectories, and how far apart in time.
struct IndexPair {
  double seconds;
  size_t estimate, truth;
  auto Order() const { return std::tie(seconds, estimate, truth); }
};

// The poses of both trajectories that have no partner yet, in a row by growing stamps. The closest pair are
// always neighbours in it, as a pose between two is closer to one of them.
class UnpairedRow {
 public:
  UnpairedRow(const std::vector<TimedPose>& estimate, const std::vector<TimedPose>& truth) {
    for (size_t i = 0, j = 0; i < estimate.size() || j < truth.size();) {
      if (j == truth.size() || (i < estimate.size() && estimate[i].timestamp <= truth[j].timestamp))
        PushFrom(estimate, i, false);
      else
        PushFrom(truth, j, true);
    }
    for (size_t i = 0; i < stamps_.size(); ++i) {
      stamps_[i].before = i - 1;  // of the first: none
      stamps_[i].after = i + 1;
    }
  }

  std::vector<IndexPair> TakePairs(double tolerance) {
    tolerance_ = tolerance;
    for (size_t i = 0; i + 1 < stamps_.size(); ++i) Offer(i, i + 1);
    std::vector<IndexPair> pairs;
    while (!offers_.empty()) {
      const Neighbours best = offers_.top();
      offers_.pop();
      if (stamps_[best.left].count == 0 || stamps_[best.right].count == 0) continue;
      if (MakePair(best.left, best.right).Order() == best.pair.Order()) {
        pairs.push_back(best.pair);
        Take(best.left);
        Take(best.right);
      }
      Offer(best.left, best.right);  // their next poses
    }
    return pairs;
  }

 private:
  // Poses of one trajectory with one stamp: all but the last are repeated.
  struct Stamp {
    double timestamp;
    bool is_true;
    size_t first, count;           // of those left, in the trajectory
    size_t before = 0, after = 0;  // neighbours that have poses left; none: not a position
  };
  struct Neighbours {
    IndexPair pair;
    size_t left, right;
    bool operator<(const Neighbours& other) const { return pair.Order() > other.pair.Order(); }
  };

  // The pose at the index, which goes on to the next.
  void PushFrom(const std::vector<TimedPose>& poses, size_t& index, bool is_true) {
    const double timestamp = poses[index].timestamp;
    const bool is_repeated =
        !stamps_.empty() && stamps_.back().timestamp == timestamp && stamps_.back().is_true == is_true;
    if (is_repeated)
      ++stamps_.back().count;
    else
      stamps_.push_back({timestamp, is_true, index, 1});
    ++index;
  }

  IndexPair MakePair(size_t left, size_t right) const {
    const Stamp &a = stamps_[left], &b = stamps_[right];
    return {std::abs(b.timestamp - a.timestamp), a.is_true ? b.first : a.first,
            a.is_true ? a.first : b.first};
  }

  void Offer(size_t left, size_t right) {
    if (left >= stamps_.size() || right >= stamps_.size()) return;
    const Stamp &a = stamps_[left], &b = stamps_[right];
    if (a.is_true == b.is_true || a.count == 0 || b.count == 0) return;
    const IndexPair pair = MakePair(left, right);
    if (pair.seconds <= tolerance_) offers_.push({pair, left, right});
  }

  // The first pose that is left of a stamp; a stamp without poses makes its neighbours each other's.
  void Take(size_t i) {
    Stamp& stamp = stamps_[i];
    ++stamp.first;
    if (--stamp.count > 0) return;
    if (stamp.before < stamps_.size()) stamps_[stamp.before].after = stamp.after;
    if (stamp.after < stamps_.size()) stamps_[stamp.after].before = stamp.before;
    Offer(stamp.before, stamp.after);
  }

  double tolerance_ = 0;
  std::vector<Stamp> stamps_;
  std::priority_queue<Neighbours> offers_;
};

}  // namespace

std::vector<PosePair> PairPoses(const std::vector<TimedPose>& estimate, const std::vector<TimedPose>& truth,
                                double tolerance_seconds) {
  std::vector<IndexPair> chosen = UnpairedRow(estimate, truth).TakePairs(tolerance_seconds + kStampRounding);
  std::sort(chosen.begin(), chosen.end(),
            [](const IndexPair& a, const IndexPair& b) { return a.estimate < b.estimate; });
  std::vector<PosePair> pairs;
  pairs.reserve(chosen.size());
  for (const IndexPair& c : chosen) {
    pairs.push_back({estimate[c.estimate].timestamp, estimate[c.estimate].pose, truth[c.truth].pose});
  }
  return pairs;
}

}  // namespace armature
