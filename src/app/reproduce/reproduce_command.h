// SPDX-License-Identifier: BSD-3-Clause
// `armature reproduce`: a whole matrix of sequences and variants, timed, evaluated and reported.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace armature {

struct ReproduceArguments {
  std::vector<std::filesystem::path> sequences;    // instead of the matrix's; empty: those
  std::filesystem::path rooms;                     // recipe of rooms, instead of sequences; empty: none
  int count = 0;                                   // of rooms; 0: as RoomSet has it
  std::string split;                               // empty: as RoomSet has it
  std::optional<std::uint32_t> seed{};             // instead of a split
  std::vector<std::filesystem::path> collections;  // of CAD models for rooms
  bool lines_only = false;                         // rooms without pictures
  std::vector<std::string> variants;               // by name, see SelectVariants; empty: the matrix's
  int jitter = 0;                                  // repeats; 0: the matrix's
  std::filesystem::path cad;                       // annotated CAD models, for retrieval; empty: the matrix's
  std::filesystem::path categories;                // folder of category models; empty: the matrix says
  std::filesystem::path config;                    // empty: CONFIGS/reproduce.yaml
  std::filesystem::path out = "results";           // gets a folder of the matrix's name
  std::string name;                                // empty: the matrix's
  std::filesystem::path data;                      // empty: the matrix's
  std::vector<std::filesystem::path> detections;   // folders of <sequence>.csv, see AddDetections
  std::vector<std::string> only;                   // sequences, variants, timings; empty: all
  bool fast = false;
  int seeds = 0;                  // 0: the matrix's
  int jobs = 0;                   // at once; 0: a core each
  std::filesystem::path configs;  // CONFIGS
  std::string format = "text";
  bool json = false;
};

// Returns 1 when a job has failed; the rest is there all the same. Throws InputError, Interrupted.
int RunReproduce(const ReproduceArguments& arguments);

// Adds the sub-command; once it is parsed, its callback runs RunReproduce and stores the exit status.
void AddReproduceCommand(CLI::App& app, int& exit_status);

}  // namespace armature
