// SPDX-License-Identifier: BSD-3-Clause
#include "io/annotation_tables.h"

namespace armature {
namespace {

// Rotation whose rows are the object frame's axes in the table's frame.
Eigen::Matrix3d Axes(const Eigen::Vector3d& x, const Eigen::Vector3d& y, const Eigen::Vector3d& z) {
  return (Eigen::Matrix3d() << x.transpose(), y.transpose(), z.transpose()).finished();
}

const Eigen::Vector3d kX(1, 0, 0), kY(0, 1, 0), kZ(0, 0, 1);

// y up, back at +z: turned by half a turn, so that s0, at +x in the table, is at the left.
AnnotationTable KeypointNetChair() {
  return {"keypointnet_chair",
          "model_id",
          "sane",
          1,
          Axes(-kX, kY, -kZ),
          {{"back_top", "s0", "s1"},
           {"back_left", "s0", "s2"},
           {"back_right", "s1", "s3"},
           {"seat_rear", "s2", "s3"},
           {"seat_front", "s4", "s5"},
           {"seat_left", "s2", "s4"},
           {"seat_right", "s3", "s5"},
           {"leg_front_left", "s4", "s17"},
           {"leg_rear_left", "s2", "s18"},
           {"leg_rear_right", "s3", "s19"},
           {"leg_front_right", "s5", "s20"}}};
}

// y up, long side along x; which long side is the front does not matter.
AnnotationTable ShapeAssemblyTable() {
  return {"shapeassembly_table",
          "partnet_anno_id",
          "duplicate_model",
          0,
          Axes(kX, kY, kZ),
          {{"top_rear", "t0", "t1"},
           {"top_right", "t1", "t2"},
           {"top_front", "t3", "t2"},
           {"top_left", "t0", "t3"},
           {"leg_rear_left", "lt0", "lb0"},
           {"leg_rear_right", "lt1", "lb1"},
           {"leg_front_right", "lt2", "lb2"},
           {"leg_front_left", "lt3", "lb3"}}};
}

// y up, the screen faces +x, width along z: k1, k4, k5 at -z are at the right.
AnnotationTable ModelNetLaptop() {
  return {"modelnet_laptop",
          "file",
          "",
          0,
          Axes(-kZ, kY, kX),
          {{"screen_top", "k2", "k1"},
           {"screen_left", "k2", "k3"},
           {"hinge", "k3", "k4"},
           {"screen_right", "k1", "k4"},
           {"base_left", "k3", "k6"},
           {"base_front", "k6", "k5"},
           {"base_right", "k4", "k5"}}};
}

}  // namespace

const std::vector<AnnotationTable>& AnnotationTables() {
  static const std::vector<AnnotationTable> tables = {KeypointNetChair(), ShapeAssemblyTable(),
                                                      ModelNetLaptop()};
  return tables;
}

}  // namespace armature
