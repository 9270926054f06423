// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/rooms/room_path.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "datasets/rooms/distribution.h"
#include "datasets/rooms/free_floor.h"
#include "geometry/rotation.h"

namespace armature {
namespace {

using Eigen::Vector2d;
using std::numbers::pi;

constexpr double kStep = 0.6;        // seconds between keyframes, at least
constexpr double kFastestTurn = 45;  // degrees a second that the head turns
constexpr double kDegreesOfShake = 2.5;
constexpr double kMetresOfShake = 0.035;
constexpr int kWayTries = 30;  // of a part of the way

struct Step {
  Vector2d position{0, 0};
  double heading = 0;  // radians
};

using Steps = std::vector<Step>;

double HeadingTo(const Vector2d& from, const Vector2d& to) {
  return std::atan2(to.y() - from.y(), to.x() - from.x());
}

class WayDrawing {
 public:
  WayDrawing(const PathRecipe& recipe, const DrawnRoom& room, Random& random)
      : recipe_(recipe), room_(room), floor_(room), random_(random) {
    seconds_ = room.scene.frames / room.scene.fps;
    const int intervals = static_cast<int>(seconds_ / kStep);
    count_ = std::clamp(intervals, 3, std::max(3, room.scene.frames)) + 1;
    interval_ = seconds_ / (count_ - 1);
    speed_ = DrawNumber(recipe.speed, random);
  }

  // Empty: there is none.
  Steps Draw(const std::string& kind) {
    if (kind == "arc") return Arc();
    if (kind == "corridor") return Corridor();
    if (kind == "close") return Close();
    return Wander();
  }

  double interval() const { return interval_; }

 private:
  Vector2d ObjectAt(size_t i) const { return room_.scene.objects[i].T_world_object.translation().head<2>(); }

  size_t AnyObject() {
    return static_cast<size_t>(random_.Uniform(0, static_cast<double>(room_.scene.objects.size())));
  }

  // Around some furniture, looking at it.
  Steps Arc() {
    const Vector2d centre = ObjectAt(AnyObject());
    const double radius = random_.Uniform(1.3, 3.2), start = random_.Uniform(-pi, pi);
    const double most = random_.Uniform(60, 300) * kDegree;
    const double span = std::min(most, seconds_ * speed_ / radius) * (random_.Uniform(0, 1) < 0.5 ? -1 : 1);
    const double aside = random_.Normal(0, 8) * kDegree;
    Steps steps;
    for (int i = 0; i < count_; ++i) {
      const double angle = start + span * i / (count_ - 1);
      const Vector2d at = centre + radius * Vector2d(std::cos(angle), std::sin(angle));
      if (!floor_.IsFree(at)) return {};
      steps.push_back({at, HeadingTo(at, centre) + aside});
    }
    return steps;
  }

  // Straight through the room, looking to the left and to the right.
  Steps Corridor() {
    const Vector2d start = floor_.Anywhere(random_);
    const double direction = random_.Uniform(-pi, pi);
    const Vector2d ahead(std::cos(direction), std::sin(direction));
    double length = seconds_ * speed_;
    while (length > 1 && !floor_.IsFree(start, start + length * ahead)) length *= 0.85;
    if (length <= 1) return {};
    const double swing = random_.Uniform(20, 65) * kDegree, turns = random_.Uniform(0.7, 2.2);
    const double aside = random_.Uniform(-30, 30) * kDegree, phase = random_.Uniform(-pi, pi);
    Steps steps;
    for (int i = 0; i < count_; ++i) {
      const double share = static_cast<double>(i) / (count_ - 1);
      steps.push_back({start + share * length * ahead,
                       direction + aside + swing * std::sin(2 * pi * turns * share + phase)});
    }
    return steps;
  }

  // Along the outline of a table with its chairs, looking at it; back again where the way is blocked.
  Steps Close() {
    std::vector<size_t> tables;
    for (size_t i = 0; i < room_.scene.objects.size(); ++i) {
      if (room_.scene.objects[i].instance.category == "table") tables.push_back(i);
    }
    const size_t chosen =
        tables.empty() ? AnyObject()
                       : tables[static_cast<size_t>(random_.Uniform(0, static_cast<double>(tables.size())))];
    const Outline outline(room_, chosen, DrawNumber(recipe_.distance, random_));
    double along = random_.Uniform(0, outline.length());
    double step = speed_ * interval_ * (random_.Uniform(0, 1) < 0.5 ? -1 : 1);
    if (!floor_.IsFree(outline.At(along))) return {};
    const double swing = random_.Uniform(5, 30) * kDegree, period = random_.Uniform(4, 9);
    Steps steps;
    for (int i = 0; i < count_; ++i) {
      const Vector2d at = outline.At(along);
      steps.push_back(
          {at, HeadingTo(at, outline.NearestInside(at)) + swing * std::sin(2 * pi * i * interval_ / period)});
      if (!floor_.IsFree(at, outline.At(along + step))) step = -step;
      if (floor_.IsFree(at, outline.At(along + step))) along += step;
    }
    return steps;
  }

  // From place to place, looking at one thing after the other.
  Steps Wander() {
    const std::vector<Vector2d> places = WanderedPlaces(seconds_ * speed_);
    if (places.size() < 2) return {};
    Steps steps;
    size_t target = AnyObject();
    double heading = HeadingTo(places[0], ObjectAt(target));
    double along = 0, next_look = random_.Uniform(1.5, 4);
    for (int i = 0; i < count_; ++i) {
      const Vector2d at = PointAlong(places, along);
      if (i * interval_ > next_look) {
        target = AnyObject();
        next_look += random_.Uniform(1.5, 5);
      }
      const double most = kFastestTurn * kDegree * interval_;
      heading += std::clamp(WrapAngle(HeadingTo(at, ObjectAt(target)) - heading), -most, most);
      steps.push_back({at, heading});
      along += speed_ * interval_;
    }
    return steps;
  }

  std::vector<Vector2d> WanderedPlaces(double length) {
    std::vector<Vector2d> places{floor_.Anywhere(random_)};
    if (!floor_.IsFree(places[0])) return {};
    double walked = 0;
    for (int i = 0; i < kWayTries && walked < length; ++i) {
      const Vector2d next = floor_.Anywhere(random_);
      const double way = (next - places.back()).norm();
      if (way < 0.8 || !floor_.IsFree(places.back(), next)) continue;
      walked += way;
      places.push_back(next);
    }
    return places;
  }

  static Vector2d PointAlong(const std::vector<Vector2d>& places, double along) {
    for (size_t i = 1; i < places.size(); ++i) {
      const double way = (places[i] - places[i - 1]).norm();
      if (along <= way) return places[i - 1] + along / way * (places[i] - places[i - 1]);
      along -= way;
    }
    return places.back();
  }

  const PathRecipe& recipe_;
  const DrawnRoom& room_;
  FreeFloor floor_;
  Random& random_;
  double seconds_ = 0, interval_ = 0, speed_ = 0;
  int count_ = 0;
};

// In some places the camera stands still or turns on the spot, for two to four keyframes; what comes later is
// left out.
void AddPauses(int pauses, double interval, Random& random, Steps* steps) {
  const size_t count = steps->size();
  for (int i = 0; i < pauses; ++i) {
    const auto at = static_cast<size_t>(random.Uniform(0, static_cast<double>(count)));
    const auto rest = static_cast<size_t>(random.Uniform(2, 5));
    const double turn =
        random.Uniform(0, 1) < 0.5 ? 0 : random.Uniform(-1, 1) * kFastestTurn * kDegree * interval;
    Steps resting;
    for (size_t k = 1; k <= rest; ++k)
      resting.push_back({(*steps)[at].position, (*steps)[at].heading + static_cast<double>(k) * turn});
    for (size_t k = at + 1; k < count; ++k) {
      (*steps)[k].heading += static_cast<double>(rest) * turn;
    }
    steps->insert(steps->begin() + static_cast<std::ptrdiff_t>(at) + 1, resting.begin(), resting.end());
    steps->resize(count);
  }
}

// As a hand moves that holds the camera, but for where it rests: there only angles change, or nothing does.
void AddKeyframes(const Steps& steps, double shake, Random& random, CameraPath* path) {
  CameraPath::Keyframe last;
  for (size_t i = 0; i < steps.size(); ++i) {
    const bool rests = i > 0 && steps[i].position == steps[i - 1].position;
    CameraPath::Keyframe key = last;
    if (!rests) {
      key.position =
          (steps[i].position + kMetresOfShake * shake * Vector2d(random.Normal(0, 1), random.Normal(0, 1)))
              .unaryExpr(&RoundDrawn);
      key.height = RoundDrawn(path->height + random.Normal(0, kMetresOfShake * shake));
    }
    if (!rests || steps[i].heading != steps[i - 1].heading) {
      const double sigma = kDegreesOfShake * shake;
      key.heading_deg = RoundDrawn(WrapAngle(steps[i].heading) / kDegree + random.Normal(0, sigma));
      key.pitch_deg = RoundDrawn(path->pitch_deg + random.Normal(0, sigma));
      key.roll_deg = RoundDrawn(random.Normal(0, sigma));
    }
    path->keyframes.push_back(key);
    last = key;
  }
}

CameraPath DrawLoop(const DrawnRoom& room, Random& random) {
  CameraPath path;
  const Vector2d most = room.scene.room.size.head<2>() - Vector2d::Constant(0.8);
  path.length = RoundDrawn(random.Uniform(0.4, 0.98) * most.x());
  path.width = RoundDrawn(std::min(random.Uniform(0.25, 0.98) * most.y(), path.length));
  path.clockwise = random.Uniform(0, 1) < 0.5;
  const bool is_inwards = random.Uniform(0, 1) < 0.5;
  const double aside = random.Uniform(40, 90);
  path.heading_offset_deg = RoundDrawn(is_inwards == path.clockwise ? -aside : aside);
  const Vector2d spare = 0.5 * (most - Vector2d(path.length, path.width));
  path.centre =
      Vector2d(random.Uniform(-1, 1) * spare.x(), random.Uniform(-1, 1) * spare.y()).unaryExpr(&RoundDrawn);
  return path;
}

CameraPath DrawTurn(const DrawnRoom& room, Random& random) {
  CameraPath path;
  path.kind = CameraPath::Kind::kTurn;
  path.centre = (0.3 * Vector2d(random.Uniform(-1, 1) * room.scene.room.size.x(),
                                random.Uniform(-1, 1) * room.scene.room.size.y()))
                    .unaryExpr(&RoundDrawn);
  path.start_deg = RoundDrawn(random.Uniform(-180, 180));
  path.clockwise = random.Uniform(0, 1) < 0.5;
  return path;
}

}  // namespace

std::optional<CameraPath> TryPath(const PathRecipe& recipe, const DrawnRoom& room, Random& random) {
  const std::string kind = DrawWord(recipe.kind, random);
  const double shake = DrawNumber(recipe.shake, random);
  CameraPath path;
  if (kind == "loop") path = DrawLoop(room, random);
  if (kind == "turn") path = DrawTurn(room, random);
  path.overlap = DrawNumber(recipe.overlap, random);
  path.height = DrawNumber(recipe.height, random);
  path.pitch_deg = DrawNumber(recipe.pitch_deg, random);
  if (kind == "loop" || kind == "turn") {
    path.sway_deg = RoundDrawn(0.7 * (0.5 + shake));
    path.sway = kind == "turn" ? 0 : RoundDrawn(0.008 * (0.5 + shake));
  } else {
    if (room.scene.objects.empty()) return std::nullopt;
    path.kind = CameraPath::Kind::kKeyframes;
    path.sway = 0;  // shaking is in the keyframes
    path.sway_deg = 0;
    WayDrawing drawing(recipe, room, random);
    Steps steps = drawing.Draw(kind);
    if (steps.empty()) return std::nullopt;
    AddPauses(DrawInteger(recipe.pauses, random), drawing.interval(), random, &steps);
    AddKeyframes(steps, shake, random, &path);
  }
  const FreeFloor floor(room);
  for (const Eigen::Isometry3d& pose : CameraPoses(path, room.scene.frames, room.scene.seed)) {
    if (!floor.IsClear(pose.translation())) return std::nullopt;
  }
  return path;
}

}  // namespace armature
