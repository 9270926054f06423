// SPDX-License-Identifier: BSD-3-Clause
// What may make an object, or a room, easy or hard: known from the truth alone, whatever a run did.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "category/category_model.h"
#include "truth/sequence_truth.h"

namespace armature {

// Views are the images in which the object was detected; where the truth knows no detections, those in which
// its centre is.
struct ObjectCircumstances {
  int views = 0;
  std::optional<double>
      distance_m{};  // median over the views, from the camera to its centre; none without views
  std::optional<double> parallax_deg{};  // between the two rays to its centre that are furthest apart
  std::optional<double>
      hidden_share{};         // of the length of its edges in the views, 0..1; none without true edges
  bool was_whole = false;     // all of its box was inside the image of some view
  double size_deviation = 0;  // mean over the axes of |ln(size / the category's mean size)|
};

struct RoomCircumstances {
  long images = 0;                          // with a true camera
  long objects = 0;                         // true ones
  std::optional<double> pitch_deg{};        // median angle of the cameras below the horizon
  std::optional<double> camera_height_m{};  // median, above the lowest object's base
  double path_m = 0;                        // length of the cameras' way
  std::string detections{};  // the setting that made them, as scene.yaml has it; empty: not known
  std::string path{};        // the kind of the camera's, as scene.yaml has it; empty: not known
};

// One an object of the truth. Throws InputError for a category without model.
std::vector<ObjectCircumstances> DescribeObjects(const SequenceTruth& sequence,
                                                 const std::vector<CategoryModel>& models);

// `folder`: of the sequence. Throws InputError: a malformed scene.yaml.
RoomCircumstances DescribeRoom(const SequenceTruth& sequence, const std::filesystem::path& folder);

}  // namespace armature
