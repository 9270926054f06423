// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/rooms/room_layout.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "datasets/cad/resized.h"
#include "datasets/scene/clutter.h"
#include "datasets/scene/distractors.h"
#include "datasets/scene/placing.h"
#include "datasets/scene/support.h"
#include "geometry/rotation.h"

namespace armature {
namespace {

using Eigen::Isometry3d;
using Eigen::Translation3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr int kTries = 40;            // a place
constexpr double kBetween = 0.1;      // metres between things of different groups
constexpr double kFromWall = 0.03;    // metres
constexpr double kChairPitch = 0.62;  // metres between the centres of neighbours at a table
constexpr double kPullOut = 0.08;     // metres that a chair is pulled out by where it cannot be

enum LayoutStream : std::uint64_t { kGroups = 0, kDistractors = 1000, kSeats = 2000 };

Isometry3d PlaceFrame(const Vector2d& position, double yaw_deg) {
  return Translation3d(position.x(), position.y(), 0) *
         Isometry3d(Eigen::AngleAxisd(yaw_deg * kDegree, Vector3d::UnitZ()));
}

Vector2d Turned(const Vector2d& v, double yaw_deg) { return Eigen::Rotation2Dd(yaw_deg * kDegree) * v; }

// The yaw of a thing whose front looks along `front`: at 0 it looks along -y.
double YawTowards(const Vector2d& front) { return std::atan2(front.x(), -front.y()) / kDegree; }

bool IsInRoom(const Solid& solid, const Room& room) {
  const std::vector<Vector3d> corners = Corners(solid.around);
  return std::all_of(corners.begin(), corners.end(), [&](const Vector3d& corner) {
    return (corner.head<2>().cwiseAbs() - 0.5 * room.size.head<2>()).maxCoeff() < -kFromWall &&
           corner.z() < room.size.z() - kFromWall;
  });
}

bool IsFreeIn(const DrawnRoom& room, const Solid& solid, int group) {
  if (!IsInRoom(solid, room.scene.room)) return false;
  OrientedBox wide = solid.around;
  wide.size += Vector3d::Constant(2 * kBetween);
  for (size_t i = 0; i < room.solids.size(); ++i) {
    if (room.groups[i] == group ? Overlap(solid, room.solids[i])
                                : IntersectionVolume(wide, room.solids[i].around) > 1e-9)
      return false;
  }
  return true;
}

std::string NextId(const DrawnRoom& room, const std::string& kind) {
  int number = 1;
  for (const SceneObject& object : room.scene.objects) number += object.instance.category == kind ? 1 : 0;
  for (const ClutterPiece& piece : room.scene.clutter) number += piece.shape == kind ? 1 : 0;
  return fmt::format("{}-{}", kind, number);
}

// Whether it could be placed there.
bool TryObject(const CadInstance& instance, Placement at, const Isometry3d& T_world_place, DrawnRoom* room) {
  SceneObject object{NextId(*room, instance.category), instance, StandingOn(T_world_place, instance)};
  const Solid solid = MakeSolid(instance.mesh, object.T_world_object);
  if (!IsFreeIn(*room, solid, at.group)) return false;
  room->solids.push_back(solid);
  room->groups.push_back(at.group);
  room->scene.objects.push_back(std::move(object));
  room->objects.push_back(std::move(at));
  return true;
}

Vector2d Rounded(const Vector2d& position) { return position.unaryExpr(&RoundDrawn); }

bool TryOnFloor(const CadInstance& instance, const Vector2d& position, double yaw_deg, int group,
                DrawnRoom* room) {
  const Placement at{Rounded(position), RoundDrawn(yaw_deg), "", group};
  return TryObject(instance, at, PlaceFrame(at.position, at.yaw_deg), room);
}

Vector2d AnywhereIn(const Room& room, Random& random) {
  return {random.Uniform(-0.5, 0.5) * room.size.x(), random.Uniform(-0.5, 0.5) * room.size.y()};
}

struct FloorPlace {
  Vector2d position;
  double yaw_deg;
};

// With its back to a wall. `size`: width and depth.
FloorPlace AtSomeWall(const Room& room, const Vector2d& size, Random& random) {
  const double yaw_deg = 90 * std::floor(random.Uniform(0, 4));
  const Vector2d inwards = Turned({0, -1}, yaw_deg), along = Turned({1, 0}, yaw_deg);
  const double away = 0.5 * std::abs(inwards.dot(room.size.head<2>())) - 0.5 * size.y() -
                      random.Uniform(kFromWall + 0.01, 0.15);
  const double free = std::max(0.0, std::abs(along.dot(room.size.head<2>())) - size.x() - 0.1);
  return {-away * inwards + random.Uniform(-0.5, 0.5) * free * along, yaw_deg + random.Normal(0, 1.5)};
}

// Where a chair may stand at a table: on its rim, looking inwards; table's frame, front at -y.
struct Seat {
  Vector2d rim, outwards;
};

void AddRow(double length, const Vector2d& middle, const Vector2d& outwards, std::vector<Seat>* seats) {
  const int count = std::max(1, static_cast<int>((length - 0.05) / kChairPitch));
  const Vector2d along(-outwards.y(), outwards.x());
  const double pitch = length / count;
  for (int i = 0; i < count; ++i)
    seats->push_back({middle + (i - 0.5 * (count - 1)) * pitch * along, outwards});
}

std::vector<Seat> SeatsAround(const Vector3d& size) {
  std::vector<Seat> seats;
  AddRow(size.x(), {0, -0.5 * size.z()}, {0, -1}, &seats);
  AddRow(size.x(), {0, 0.5 * size.z()}, {0, 1}, &seats);
  AddRow(size.z(), {0.5 * size.x(), 0}, {1, 0}, &seats);
  AddRow(size.z(), {-0.5 * size.x(), 0}, {-1, 0}, &seats);
  return seats;
}

void Shuffle(std::vector<Seat>* seats, Random& random) {
  for (size_t i = seats->size(); i > 1; --i)
    std::swap((*seats)[i - 1], (*seats)[static_cast<size_t>(random.Uniform(0, static_cast<double>(i)))]);
}

class GroupPlacing {
 public:
  GroupPlacing(const Recipe& recipe, const Furniture& furniture, DrawnRoom* room)
      : recipe_(recipe), furniture_(furniture), room_(room) {}

  void Place(const GroupRecipe& group, Random& random) {
    ++group_;
    if (group.kind == GroupRecipe::Kind::kFree) {
      const CadInstance instance = Draw(DrawWord(group.category, random), {3, 3}, random);
      for (int i = 0; i < kTries; ++i) {
        if (TryOnFloor(instance, AnywhereIn(room_->scene.room, random), random.Uniform(-180, 180), group_,
                       room_))
          return;
      }
      return;
    }
    const int chairs = DrawInteger(group.chairs, random);
    if (!PlaceTable(group, chairs, random)) return;
    const SceneObject table = room_->scene.objects.back();
    const Placement at = room_->objects.back();
    PlaceLaptops(table, DrawInteger(group.laptops, random), random);
    PlaceChairs(group, table, at, chairs, random);
  }

 private:
  CadInstance Draw(const std::string& category, const Vector2d& at_most, Random& random) {
    return InDrawnSize(furniture_, DrawInstance(furniture_, category, at_most, random), recipe_.furniture,
                       random);
  }

  // Long enough for its rows of chairs.
  CadInstance DrawTable(const GroupRecipe& group, int chairs, Random& random) {
    if (group.kind != GroupRecipe::Kind::kMeeting) {
      const double widest = group.kind == GroupRecipe::Kind::kDesk ? 1.8 : 2.4;
      return Draw("table", {widest, 1.3}, random);
    }
    CadInstance table = Draw("table", {2.6, 1.3}, random);
    for (int i = 0; i < 2; ++i) {
      CadInstance other = Draw("table", {2.6, 1.3}, random);
      if (other.size.x() > table.size.x()) table = std::move(other);
    }
    const double row = kChairPitch * std::max(2, (chairs - 1) / 2);
    const Vector3d size(std::max(table.size.x(), row + 0.3), table.size.y(),
                        std::clamp(table.size.z(), 0.9, 1.3));
    return Resized(table, size.unaryExpr(&RoundDrawn));
  }

  bool PlaceTable(const GroupRecipe& group, int chairs, Random& random) {
    const CadInstance table = DrawTable(group, chairs, random);
    const bool is_desk = group.kind == GroupRecipe::Kind::kDesk && random.Uniform(0, 1) < 0.75;
    const bool is_meeting = group.kind == GroupRecipe::Kind::kMeeting;
    const Room& room = room_->scene.room;
    for (int i = 0; i < kTries; ++i) {
      FloorPlace place{(is_meeting ? 0.35 : 0.8) * AnywhereIn(room, random), random.Uniform(-180, 180)};
      if (is_desk) place = AtSomeWall(room, {table.size.x(), table.size.z()}, random);
      if (is_meeting) place.yaw_deg = (room.size.x() < room.size.y() ? 90 : 0) + random.Normal(0, 4);
      if (TryOnFloor(table, place.position, place.yaw_deg, group_, room_)) return true;
    }
    return false;
  }

  void PlaceLaptops(const SceneObject& table, int count, Random& random) {
    for (int n = 0; n < count; ++n) {
      const CadInstance laptop = Draw("laptop", {1, 1}, random);
      const Vector2d reach = 0.5 * Vector2d(table.instance.size.x() - laptop.size.head<3>().norm(),
                                            table.instance.size.z() - laptop.size.head<3>().norm());
      if (reach.minCoeff() < 0) continue;
      for (int i = 0; i < kTries; ++i) {
        const Vector2d position = Rounded(
            {random.Uniform(-1, 1) * reach.x(), (n % 2 == 0 ? 1 : -1) * random.Uniform(0, 1) * reach.y()});
        const double facing = position.y() >= 0 ? 0 : 180;  // who sits on that side of the table
        const Placement at{position, RoundDrawn(facing + random.Normal(0, 12)), table.id, group_};
        const Isometry3d T_world_place =
            FindTop(table) * PlaceFrame({position.x(), -position.y()}, at.yaw_deg);
        if (TryObject(laptop, at, T_world_place, room_)) break;
      }
    }
  }

  void PlaceChairs(const GroupRecipe& group, const SceneObject& table, const Placement& at, int count,
                   Random& random) {
    std::vector<Seat> seats = SeatsAround(table.instance.size);
    Shuffle(&seats, random);
    if (group.kind == GroupRecipe::Kind::kDesk)
      seats.assign(1, {{0, -0.5 * table.instance.size.z()}, {0, -1}});
    const bool are_alike = random.Uniform(0, 1) < DrawNumber(recipe_.furniture.alike, random);
    CadInstance chair = Draw("chair", {0.8, 0.9}, random);
    for (size_t i = 0; i < seats.size() && static_cast<int>(i) < count; ++i) {
      if (!are_alike && i > 0) chair = Draw("chair", {0.8, 0.9}, random);
      PlaceChair(group, chair, seats[i], at, random);
    }
  }

  // Pulled out until it is free.
  void PlaceChair(const GroupRecipe& group, const CadInstance& chair, const Seat& seat,
                  const Placement& table, Random& random) {
    const double first = DrawNumber(group.gap, random), aside = random.Normal(0, 0.03);
    const double turned = DrawNumber(group.turned_deg, random);
    const Vector2d along(-seat.outwards.y(), seat.outwards.x());
    for (double gap = first; gap < std::max(first, 0.0) + 0.5; gap += kPullOut) {
      const Vector2d in_table = seat.rim + (0.5 * chair.size.z() + gap) * seat.outwards + aside * along;
      const double yaw_deg = YawTowards(-seat.outwards) + turned;
      if (TryOnFloor(chair, table.position + Turned(in_table, table.yaw_deg), table.yaw_deg + yaw_deg, group_,
                     room_))
        return;
    }
  }

  const Recipe& recipe_;
  const Furniture& furniture_;
  DrawnRoom* room_;
  int group_ = 0;
};

bool TryPiece(const std::string& shape, const Vector3d& size, const Placement& at,
              const Isometry3d& T_world_place, DrawnRoom* room) {
  Random own = MakeRandom(room->scene.seed, room->scene.clutter.size());  // as the scene's reader has it
  const Colour colour = DrawClutterColour(shape, own);
  ClutterPiece piece{ClutterMesh(shape, size, colour, own), T_world_place, shape, NextId(*room, shape)};
  const Solid solid = MakeSolid(piece.mesh, T_world_place);
  if (!IsFreeIn(*room, solid, at.group)) return false;
  room->solids.push_back(solid);
  room->groups.push_back(at.group);
  room->scene.clutter.push_back(std::move(piece));
  room->clutter.push_back(at);
  room->clutter_sizes.push_back(size);
  return true;
}

// Before some furniture, on the side of the room's middle, or anywhere around it.
FloorPlace BeforeFurniture(const DrawnRoom& room, const Vector3d& size, Random& random) {
  const auto i = static_cast<size_t>(random.Uniform(0, static_cast<double>(room.scene.objects.size())));
  const Vector2d there = room.scene.objects[i].T_world_object.translation().head<2>();
  const double angle = std::atan2(-there.y(), -there.x()) + random.Normal(0, 0.9);
  const double reach =
      0.5 * room.scene.objects[i].instance.size.z() + 0.5 * size.y() + random.Uniform(0.25, 0.9);
  const Vector2d away(std::cos(angle), std::sin(angle));
  return {there + reach * away, YawTowards(away) + random.Normal(0, 25)};
}

void PlaceDistractor(const Recipe& recipe, Random& random, DrawnRoom* room) {
  const std::string shape = DrawWord(recipe.distractors.shape, random);
  const Vector3d size = DrawDistractorSize(shape, random).unaryExpr(&RoundDrawn);
  const bool hides =
      !room->scene.objects.empty() && random.Uniform(0, 1) < DrawNumber(recipe.distractors.hiding, random);
  for (int i = 0; i < kTries; ++i) {
    const FloorPlace place =
        hides ? BeforeFurniture(*room, size, random) : AtSomeWall(room->scene.room, size.head<2>(), random);
    const Placement at{Rounded(place.position), RoundDrawn(place.yaw_deg), "", -1};
    if (TryPiece(shape, size, at, PlaceFrame(at.position, at.yaw_deg), room)) return;
  }
}

// Books, a box or paper on some seats.
void FillSeats(double share, Random& random, DrawnRoom* room) {
  for (size_t i = 0; i < room->scene.objects.size(); ++i) {
    const SceneObject& chair = room->scene.objects[i];
    if (chair.instance.category != "chair" || random.Uniform(0, 1) >= share || !IsSupport(chair)) continue;
    const double kind = random.Uniform(0, 1);
    const std::string shape = kind < 0.5 ? "books" : "box";
    Vector3d size(random.Uniform(0.14, 0.22), random.Uniform(0.18, 0.26), random.Uniform(0.03, 0.14));
    size = size.unaryExpr(&RoundDrawn).eval();
    const Placement at{{0, 0}, RoundDrawn(random.Uniform(-40, 40)), chair.id, room->objects[i].group};
    TryPiece(shape, size, at, FindTop(chair) * PlaceFrame({0, 0}, at.yaw_deg), room);
  }
}

}  // namespace

void DrawLayout(const Recipe& recipe, const Furniture& furniture, std::uint64_t seed, DrawnRoom* room) {
  GroupPlacing placing(recipe, furniture, room);
  std::uint64_t stream = kGroups;
  for (const GroupRecipe& group : recipe.layout) {
    Random random(StreamSeed(seed, stream++));
    const int count = DrawInteger(group.count, random);
    for (int i = 0; i < count; ++i) {
      Random own(StreamSeed(seed, stream++));
      placing.Place(group, own);
    }
  }
  Random random(StreamSeed(seed, kDistractors));
  const int count = DrawInteger(recipe.distractors.count, random);
  for (int i = 0; i < count; ++i) {
    Random own(StreamSeed(seed, kDistractors + 1 + static_cast<std::uint64_t>(i)));
    PlaceDistractor(recipe, own, room);
  }
  Random seats(StreamSeed(seed, kSeats));
  FillSeats(DrawNumber(recipe.room.seat_clutter, seats), seats, room);
}

}  // namespace armature
