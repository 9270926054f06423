// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/rooms/room_sheet.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "datasets/scene/clutter.h"
#include "datasets/scene/solid.h"
#include "datasets/sequence_pictures.h"

namespace armature {
namespace {

constexpr int kCellWidth = 240, kCellHeight = 180, kGap = 4;  // pixels
constexpr int kCells = 3, kRoomsARow = 2;

class PlanDrawing {
 public:
  explicit PlanDrawing(const Room& room) : picture_(kCellHeight, kCellWidth, cv::Vec3b(255, 255, 255)) {
    scale_ = std::min((kCellWidth - 12) / room.size.x(), (kCellHeight - 12) / room.size.y());
    const Eigen::Vector2d half = 0.5 * room.size.head<2>();
    cv::rectangle(picture_, Pixel(-half), Pixel(half), {120, 120, 120}, 1, cv::LINE_AA);
  }

  void AddBox(const OrientedBox& box, const cv::Scalar& colour) {
    std::vector<cv::Point> corners;
    for (const Eigen::Vector3d& corner : Corners(box)) corners.push_back(Pixel(corner.head<2>()));
    std::vector<cv::Point> hull;
    cv::convexHull(corners, hull);
    cv::fillConvexPoly(picture_, hull, colour, cv::LINE_AA);
    cv::polylines(picture_, hull, true, {60, 60, 60}, 1, cv::LINE_AA);
  }

  void AddPath(const std::vector<Eigen::Isometry3d>& poses) {
    const size_t step = std::max<size_t>(1, poses.size() / 15);
    for (size_t i = 0; i < poses.size(); ++i) {
      const Eigen::Vector2d at = poses[i].translation().head<2>();
      if (i > 0)
        cv::line(picture_, Pixel(poses[i - 1].translation().head<2>()), Pixel(at), {0, 0, 0}, 1, cv::LINE_AA);
      if (i % step != 0) continue;
      const Eigen::Vector2d ahead = at + 0.3 * poses[i].linear().col(2).head<2>();
      cv::line(picture_, Pixel(at), Pixel(ahead), {40, 160, 40}, 1, cv::LINE_AA);
    }
    cv::circle(picture_, Pixel(poses.front().translation().head<2>()), 3, {0, 0, 0}, 1, cv::LINE_AA);
  }

  cv::Mat3b Labelled(const std::string& label) {
    cv::putText(picture_, label, {4, kCellHeight - 6}, cv::FONT_HERSHEY_SIMPLEX, 0.4, {0, 0, 0}, 1,
                cv::LINE_AA);
    return picture_;
  }

 private:
  cv::Point Pixel(const Eigen::Vector2d& world) const {
    return {cvRound(0.5 * kCellWidth + scale_ * world.x()), cvRound(0.5 * kCellHeight - scale_ * world.y())};
  }

  cv::Mat3b picture_;
  double scale_ = 1;  // pixels a metre
};

cv::Scalar PlanColour(const std::string& category) {
  if (category == "chair") return {220, 150, 90};
  return category == "table" ? cv::Scalar(110, 160, 200) : cv::Scalar(60, 60, 220);
}

// As large as fits, in the middle of a cell.
cv::Mat3b InCell(const cv::Mat& image) {
  const double scale =
      std::min(static_cast<double>(kCellWidth) / image.cols, static_cast<double>(kCellHeight) / image.rows);
  cv::Mat3b small, cell(kCellHeight, kCellWidth, cv::Vec3b(255, 255, 255));
  cv::resize(image, small, {cvRound(scale * image.cols), cvRound(scale * image.rows)}, 0, 0, cv::INTER_AREA);
  small.copyTo(cell({(kCellWidth - small.cols) / 2, (kCellHeight - small.rows) / 2, small.cols, small.rows}));
  return cell;
}

cv::Mat3b PictureAt(const SequencePictures& pictures, double share) {
  const auto index = static_cast<size_t>(share * static_cast<double>(pictures.size()));
  return InCell(pictures.Read(std::min(index, pictures.size() - 1)));
}

}  // namespace

cv::Mat3b RoomPlan(const Scene& scene, const std::string& label) {
  PlanDrawing plan(scene.room);
  for (const ClutterPiece& piece : scene.clutter) {
    if (IsDistractor(piece.shape))
      plan.AddBox(MakeSolid(piece.mesh, piece.T_world_mesh).around, {190, 190, 190});
  }
  for (const char* category : {"chair", "table", "laptop"}) {
    for (const SceneObject& object : scene.objects) {
      if (object.instance.category == category)
        plan.AddBox({object.T_world_object, object.instance.size}, PlanColour(category));
    }
  }
  plan.AddPath(CameraPoses(scene.path, scene.frames, scene.seed));
  return plan.Labelled(label);
}

cv::Mat3b RoomSheet(const std::vector<RoomPictures>& rooms) {
  const int rows = (static_cast<int>(rooms.size()) + kRoomsARow - 1) / kRoomsARow;
  const int step_x = kCellWidth + kGap, step_y = kCellHeight + kGap;
  cv::Mat3b sheet(rows * step_y + kGap, kRoomsARow * (kCells * step_x + 2 * kGap) + kGap,
                  cv::Vec3b(255, 255, 255));
  for (int i = 0; i < static_cast<int>(rooms.size()); ++i) {
    const RoomPictures& room = rooms[static_cast<size_t>(i)];
    const SequencePictures pictures(room.folder);
    const int x = kGap + i % kRoomsARow * (kCells * step_x + 2 * kGap), y = kGap + i / kRoomsARow * step_y;
    const std::vector<cv::Mat3b> cells{PictureAt(pictures, 0.25), PictureAt(pictures, 0.75), room.plan};
    for (int k = 0; k < kCells; ++k)
      cells[static_cast<size_t>(k)].copyTo(sheet({x + k * step_x, y, kCellWidth, kCellHeight}));
  }
  return sheet;
}

}  // namespace armature
