// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/rooms/draw_room.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <optional>

#include "base/errors.h"
#include "base/interrupt.h"
#include "datasets/rooms/room_layout.h"
#include "datasets/rooms/room_looks.h"
#include "datasets/rooms/room_path.h"
#include "datasets/rooms/room_sight.h"

namespace armature {
namespace {

constexpr int kRoomTries = 20;
constexpr int kPathTries = 150;    // a room, most of which end in some furniture
constexpr int kPathsCompared = 8;  // of those that do not
constexpr double kEnough = 0.7;    // share of the objects seen: no better path is looked for
constexpr int kFewest = 3;         // objects seen
constexpr double kBusy = 0.6;      // share of the poses from which some object is seen, at least
constexpr int kViewStep = 3;       // every third pose is looked at
constexpr int kSeedLimit = 1000000000;

enum RoomStream : std::uint64_t { kMixture = 1, kHead, kLooks, kLayout, kPathway, kSections };

// Draws within the tries of a room do not depend on how many numbers were drawn before.
std::uint64_t TrySeed(std::uint64_t room_seed, int attempt, RoomStream stream) {
  return StreamSeed(StreamSeed(room_seed, 1000 + static_cast<std::uint64_t>(attempt)), stream);
}

const Recipe& PickRecipe(const Recipe& recipe, std::uint64_t room_seed) {
  if (recipe.mixture.empty()) return recipe;
  std::vector<std::string> names(recipe.mixture.size());
  for (size_t i = 0; i < names.size(); ++i) names[i] = std::to_string(i);
  Random random(StreamSeed(room_seed, kMixture));
  return recipe.mixture[std::stoul(DrawWord(Choice(names, recipe.weights), random))];
}

void DrawHead(const Recipe& recipe, const RoomNumber& which, std::uint64_t seed, Scene* scene) {
  Random random(seed);
  scene->name = which.name;
  scene->about = fmt::format("Room {} of seed {} of the recipe {}", which.number, which.seed, recipe.name);
  scene->seed = static_cast<std::uint64_t>(random.Uniform(0, kSeedLimit));
  scene->frames = DrawInteger(recipe.frames, random);
  scene->fps = DrawNumber(recipe.fps, random);
  scene->light_grid = recipe.light_grid;
  const std::string size = DrawWord(recipe.camera.size, random);
  Camera& camera = scene->camera;
  camera.width = std::stoi(size);
  camera.height = std::stoi(size.substr(size.find('x') + 1));
  camera.fx = camera.fy =
      RoundDrawn(DrawNumber(recipe.camera.focal, random) * std::max(camera.width, camera.height));
  camera.cx = 0.5 * (camera.width - 1);
  camera.cy = 0.5 * (camera.height - 1);
}

std::string DrawSections(const Recipe& recipe, std::uint64_t seed) {
  Random effects(StreamSeed(seed, 0)), odometry(StreamSeed(seed, 1)), detections(StreamSeed(seed, 2));
  return DrawSectionText("effects", recipe.effects, effects) +
         DrawSectionText("odometry", recipe.odometry, odometry) +
         DrawSectionText("detections", recipe.detections, detections);
}

std::vector<Eigen::Isometry3d> SomePoses(const Scene& scene, const CameraPath& path) {
  const std::vector<Eigen::Isometry3d> all = CameraPoses(path, scene.frames, scene.seed);
  std::vector<Eigen::Isometry3d> some;
  for (size_t i = 0; i < all.size(); i += kViewStep) some.push_back(all[i]);
  return some;
}

struct SeenPath {
  CameraPath path;
  std::vector<bool> is_seen;  // of the objects
  int seen = 0;
  double busy = 0;  // share of the poses from which some object is seen

  // First whether it looks at furniture most of the time, then how much of it.
  bool IsBetterThan(const SeenPath& other) const {
    if ((busy >= kBusy) != (other.busy >= kBusy)) return busy >= kBusy;
    return seen > other.seen;
  }
};

SeenPath Look(const RoomSight& sight, const Scene& scene, const CameraPath& path) {
  const std::vector<Eigen::Isometry3d> poses = SomePoses(scene, path);
  const long fewest = std::max<long>(1, static_cast<long>(poses.size()) / 20);
  SeenPath seen{path, {}, 0, 0};
  std::vector<bool> is_busy(poses.size(), false);
  for (const std::vector<bool>& views : sight.FindViews(poses)) {
    const bool is_seen = std::count(views.begin(), views.end(), true) >= fewest;
    seen.is_seen.push_back(is_seen);
    seen.seen += is_seen ? 1 : 0;
    for (size_t i = 0; i < poses.size(); ++i) is_busy[i] = is_busy[i] || views[i];
  }
  seen.busy = static_cast<double>(std::count(is_busy.begin(), is_busy.end(), true)) /
              static_cast<double>(poses.size());
  return seen;
}

// Of some paths the one that shows the most objects.
std::optional<SeenPath> FindPath(const Recipe& recipe, const DrawnRoom& room, std::uint64_t seed) {
  const RoomSight sight(room.scene);
  std::optional<SeenPath> best;
  int compared = 0;
  for (int i = 0; i < kPathTries && compared < kPathsCompared; ++i) {
    ThrowIfInterrupted();
    Random random(StreamSeed(seed, static_cast<std::uint64_t>(i)));
    const std::optional<CameraPath> path = TryPath(recipe.path, room, random);
    if (!path) continue;
    ++compared;
    SeenPath seen = Look(sight, room.scene, *path);
    if (!best || seen.IsBetterThan(*best)) best = std::move(seen);
    if (best->busy >= kBusy && best->seen >= kEnough * static_cast<double>(room.scene.objects.size())) break;
  }
  return best;
}

// What carries something that is seen stays.
void LeaveOutUnseen(std::vector<bool> is_seen, DrawnRoom* room) {
  std::vector<SceneObject>& objects = room->scene.objects;
  const auto keep = [&](const Placement& at) {
    for (size_t k = 0; k < objects.size(); ++k) {
      if (!at.on.empty() && objects[k].id == at.on) is_seen[k] = true;
    }
  };
  for (size_t i = 0; i < objects.size(); ++i) {
    if (is_seen[i]) keep(room->objects[i]);
  }
  for (const Placement& at : room->clutter) keep(at);
  std::vector<SceneObject> kept;
  std::vector<Placement> places;
  for (size_t i = 0; i < objects.size(); ++i) {
    if (!is_seen[i]) continue;
    kept.push_back(objects[i]);
    places.push_back(room->objects[i]);
  }
  objects = std::move(kept);
  room->objects = std::move(places);
}

// What went wrong, if anything.
std::string TryRoom(const Recipe& recipe, const Furniture& furniture, const RoomNumber& which,
                    std::uint64_t room_seed, int attempt, DrawnRoom* room) {
  const auto seed = [&](RoomStream stream) { return TrySeed(room_seed, attempt, stream); };
  DrawHead(recipe, which, seed(kHead), &room->scene);
  DrawLooks(recipe.room, seed(kLooks), &room->scene);
  DrawLayout(recipe, furniture, seed(kLayout), room);
  if (static_cast<int>(room->scene.objects.size()) < kFewest)
    return fmt::format("{} objects find a place", room->scene.objects.size());
  const std::optional<SeenPath> path = FindPath(recipe, *room, seed(kPathway));
  if (!path) return "no path keeps away from walls and furniture";
  if (path->seen < kFewest) return fmt::format("{} objects are seen", path->seen);
  if (path->busy < kBusy) return "the camera mostly looks at no furniture";
  room->scene.path = path->path;
  LeaveOutUnseen(path->is_seen, room);
  room->sections = DrawSections(recipe, seed(kSections));
  return "";
}

}  // namespace

DrawnRoom DrawRoom(const Recipe& recipe, const Furniture& furniture, const RoomNumber& which) {
  const std::uint64_t room_seed = StreamSeed(which.seed, static_cast<std::uint64_t>(which.number));
  const Recipe& chosen = PickRecipe(recipe, room_seed);
  std::string fault;
  for (int attempt = 0; attempt < kRoomTries; ++attempt) {
    ThrowIfInterrupted();
    DrawnRoom room;
    fault = TryRoom(chosen, furniture, which, room_seed, attempt, &room);
    if (fault.empty()) return room;
  }
  throw InputError(
      fmt::format("{}: room {} of seed {} could not be drawn in {} tries, in the last of which {}; "
                  "allow larger rooms, other furniture or another path",
                  chosen.file.string(), which.number, which.seed, kRoomTries, fault));
}

}  // namespace armature
