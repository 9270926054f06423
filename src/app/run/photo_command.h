// SPDX-License-Identifier: BSD-3-Clause
// `armature photo`: the objects of one photograph.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "cli/configuration.h"

namespace armature {

struct PhotoArguments {
  std::filesystem::path image;
  std::string camera;              // "fx,fy,cx,cy"
  std::string distortion;          // "k1,k2,p1,p2,k3", empty: none
  std::string up;                  // "x,y,z" in the camera frame, empty: estimated
  std::vector<std::string> boxes;  // "category,x,y,width,height[,azimuth_deg]"
  std::filesystem::path out;       // picture to write
  ConfigurationArguments configuration;
  bool json = false;
};

// Prints a row a box and writes the picture. Returns the exit status; throws InputError.
int RunPhoto(const PhotoArguments& arguments);

// Adds the sub-command; once it is parsed, its callback runs RunPhoto and stores the exit status.
void AddPhotoCommand(CLI::App& app, int& exit_status);

}  // namespace armature
