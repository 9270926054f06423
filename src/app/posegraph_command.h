// SPDX-License-Identifier: BSD-3-Clause
// `armature posegraph`: the poses that agree best with the measured motions between them.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>

namespace armature {

struct PoseGraphArguments {
  std::filesystem::path graph;   // g2o
  std::filesystem::path out;     // g2o file to write
  std::string init = "auto";     // start of the iterations: auto, file, odometry, chordal
  std::string weights = "full";  // information of the edges: full, isotropic
  std::string loss = "square";   // square, huber, cauchy
  double loss_scale = 1;         // standard deviations
  int max_iterations = 100;
  bool json = false;
};

// Writes the graph with its optimised poses and prints a row about it. Returns the exit status; throws
// InputError.
int RunPoseGraph(const PoseGraphArguments& arguments);

// Adds the sub-command; once it is parsed, its callback runs RunPoseGraph and stores the exit status.
void AddPoseGraphCommand(CLI::App& app, int& exit_status);

}  // namespace armature
