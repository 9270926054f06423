// SPDX-License-Identifier: BSD-3-Clause
// Generated folders are complete or absent.
#include <gtest/gtest.h>

#include <stdexcept>

#include "datasets/generate.h"
#include "datasets/generation_stamp.h"
#include "support/small_scene.h"

namespace armature {
namespace {

using testing::AllFiles;
using testing::ReadFile;
using testing::TempFolder;

struct Stopped : std::runtime_error {
  Stopped() : std::runtime_error("stopped") {}
};

TEST(GenerateSequence, AStopOnTheWayIsPassedOnAndLeavesNothing) {
  const TempFolder folder;
  const std::string scene = folder.Write("den.yaml", testing::kSmallScene);
  const std::vector<CadInstance> collection = DrawCollection({});
  int frames = 0;
  const GenerationProgress progress{[](const std::string&, int) {},
                                    [&] {
                                      if (++frames == 2) throw Stopped();
                                    }};
  EXPECT_THROW(
      GenerateSequence(scene, collection, folder / "out", {.frames = 3, .lines_only = true}, progress),
      Stopped);
  EXPECT_TRUE(AllFiles(folder / "out").empty());
}

TEST(GenerateSequence, WithoutOdometryHasNoFileOfItAndNoUp) {
  const TempFolder folder;
  const std::string scene =
      folder.Write("den.yaml", std::string(testing::kSmallScene) + "odometry: {kind: none}\n");
  GenerateSequence(scene, DrawCollection({}), folder / "out", {.frames = 1, .lines_only = true}, {});
  EXPECT_FALSE(std::filesystem::exists(folder / "out/den/odometry.txt"));
  EXPECT_EQ(ReadFile(folder / "out/den/sequence.yaml").find("up:"), std::string::npos);
  EXPECT_TRUE(std::filesystem::exists(folder / "out/den/groundtruth.txt"));
}

TEST(GenerationStamp, IsOfWhatTheFolderWasMadeFrom) {
  const TempFolder folder;
  const std::string stamp = GenerationStamp("scene a");
  EXPECT_FALSE(HasStamp(folder.path(), stamp));
  EXPECT_FALSE(GeneratedFolders().is(folder.path()));
  WriteStamp(folder.path(), stamp);
  EXPECT_TRUE(HasStamp(folder.path(), stamp));
  EXPECT_FALSE(HasStamp(folder.path(), GenerationStamp("scene b")));
  EXPECT_TRUE(GeneratedFolders().is(folder.path()));
}

}  // namespace
}  // namespace armature
