// SPDX-License-Identifier: BSD-3-Clause
// Tables larger than any that is meant: refused before they take time or memory.
#include <gtest/gtest.h>

#include "io/csv.h"
#include "support/expect_input_error.h"
#include "support/temp_folder.h"

namespace armature {
namespace {

class CsvLimits : public ::testing::Test {
 protected:
  void ExpectRefusedTable(const std::string& content, const std::vector<std::string>& texts) const {
    const auto file = folder_.Write("a.csv", content);
    testing::ExpectInputError([&] { CsvTable(file, {"x"}).CheckColumnsKnown({"x", "y"}); }, texts);
  }
  testing::TempFolder folder_;
};

TEST_F(CsvLimits, AHeaderOfManyColumnsIsRefused) {
  std::string header = "x";
  for (int i = 0; i < 300'000; ++i) header += ",c" + std::to_string(i);
  ExpectRefusedTable(header + "\n", {"a.csv:1", "300001 columns", "1000"});
}

TEST_F(CsvLimits, ALineOfCommasIsRefusedAsHeaderAndAsRow) {
  const std::string commas(20'000'000, ',');
  ExpectRefusedTable(commas, {"a.csv:1", "20000001 columns"});
  ExpectRefusedTable("x,y\n" + commas, {"a.csv:2", "20000001 fields"});
}

TEST_F(CsvLimits, AColumnWithAHugeNameIsNamedInShort) {
  const auto file = folder_.Write("a.csv", "x," + std::string(20'000'000, 'n') + "\n");
  try {
    CsvTable(file, {"x"}).CheckColumnsKnown({"x", "y"});
    FAIL() << "not refused";
  } catch (const InputError& error) {
    EXPECT_LT(std::string(error.what()).size(), 400u);
  }
}

TEST_F(CsvLimits, LinesOfOtherBlanksAreBlank) {
  const CsvTable table(folder_.Write("a.csv", "\f\nx,y\r\v\n\f\v\n1\f,+2.5D0\r"), {"x"});
  ASSERT_EQ(table.rows().size(), 1u);
  EXPECT_EQ(table.rows()[0].Number("x"), 1);
  EXPECT_EQ(table.rows()[0].Number("y"), 2.5);
  ExpectRefusedTable(std::string("x,y\n1,\0\n", 8), {"a.csv:2", "zero byte"});
}

}  // namespace
}  // namespace armature
