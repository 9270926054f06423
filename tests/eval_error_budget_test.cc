// SPDX-License-Identifier: BSD-3-Clause
// What each part of the error over rooms costs, of rooms made by hand.
#include <gtest/gtest.h>

#include "eval/rooms/error_budget.h"

namespace armature {
namespace {

// Objects "0", "1", ...; an error below 0: missed.
EvaluatedRoom BudgetRoom(const std::string& name, const std::string& setting,
                         const std::vector<double>& errors) {
  EvaluatedRoom room{.room = name, .folder = "runs/" + name};
  room.circumstances.detections = setting;
  for (size_t i = 0; i < errors.size(); ++i) {
    RoomObject object;
    object.of.true_id = std::to_string(i);
    if (errors[i] >= 0) {
      object.of.error = ObjectError{};
      object.of.error->centre_m = errors[i];
    }
    room.objects.push_back(object);
  }
  return room;
}

const Table& BudgetTable() {
  static const Table table = [] {
    RoomVariant none{"none", {}}, scale{"scale", {}};
    for (int i = 0; i < 8; ++i) {
      const std::string setting = i < 6 ? "network" : "simulated", name = "room-" + std::to_string(i);
      none.rooms.push_back(BudgetRoom(name, setting, {0.2, -1}));
      none.rooms.back().log_scale = -0.3;
      scale.rooms.push_back(BudgetRoom(name, setting, {i < 6 ? 0.1 : 0.2, -1}));
    }
    none.rooms[0].spurious = 4;
    return ErrorBudgetTable({none, scale}, 1);
  }();
  return table;
}

std::vector<std::string> Texts(const std::vector<Cell>& row) {
  std::vector<std::string> texts;
  for (const Cell& cell : row) texts.push_back(cell.text);
  return texts;
}

TEST(ErrorBudget, IsOfAllRoomsAndOfThoseOfEachSetting) {
  const Table& table = BudgetTable();
  ASSERT_EQ(table.rows.size(), 6u);
  // (0.2 + 1 + 4) / 2 in the first room, 0.6 in the others.
  EXPECT_EQ(Texts(table.rows[0]), (std::vector<std::string>{"all", "none", "8", "50.0", "0.50", "0.200",
                                                            "0.200", "0.300", "0.850", ""}));
  EXPECT_EQ(table.rows[2][0].text, "network");
  EXPECT_EQ(table.rows[2][2].text, "6");
  EXPECT_EQ(table.rows[5][0].text, "simulated");
}

TEST(ErrorBudget, GainsArePairedByRoom) {
  const Table& table = BudgetTable();
  // 2.05 m in the first room, 0.05 in five, nothing in two.
  EXPECT_EQ(table.rows[1][8].text, "0.562");
  EXPECT_TRUE(table.rows[1][9].text.starts_with("0.287 [0.0")) << table.rows[1][9].text;
  EXPECT_EQ(table.rows[5][9].text, "0.000 [0.000, 0.000] (too few rooms)");
}

TEST(ErrorBudget, JudgesTheObjectsThatCouldBeSeenWithoutTheTruth) {
  const EvaluatedRoom as_it_is = BudgetRoom("a", "", {0.2, 0.4, -1});
  EXPECT_DOUBLE_EQ(ErrorOfSameObjects(as_it_is, as_it_is, 1), 1.6 / 3);
  const EvaluatedRoom fewer = BudgetRoom("a", "", {0.1, 0.1});  // of the third no detection was left
  EXPECT_DOUBLE_EQ(ErrorOfSameObjects(as_it_is, fewer, 1), 1.2 / 3);
  EvaluatedRoom more = BudgetRoom("a", "", {0.1, 0.1, 0.1, 0.9});
  more.spurious = 2;
  EXPECT_DOUBLE_EQ(ErrorOfSameObjects(as_it_is, more, 2), 4.3 / 3);
}

TEST(ErrorBudget, OneSettingHasNoRowsOfItsOwn) {
  const RoomVariant none{"none", {BudgetRoom("a", "network", {0.2})}};
  EXPECT_EQ(ErrorBudgetTable({none, {"lines", none.rooms}}, 1).rows.size(), 2u);
}

}  // namespace
}  // namespace armature
