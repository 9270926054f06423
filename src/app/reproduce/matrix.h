// SPDX-License-Identifier: BSD-3-Clause
// What `armature reproduce` is to run: sequences under variants, timings, retrieval. configs/reproduce.yaml
// says what each of these is in the file.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace armature {

// A category that is learnt from the rendered CAD models (`armature learn`).
struct LearntCategory {
  std::string name{};
  std::array<double, 3> padding{0, 0, 0};  // metres, --padding
  std::optional<double> slab_drop{};       // metres, --slab-drop
};

// A way of running the pipeline.
struct Variant {
  std::string name{};   // of its folder, too
  std::string about{};  // as the tables say it
  std::string preset = "default";
  std::filesystem::path config{};  // absolute; empty: none
  // Instead of the sequences' own; absolute: a folder of <name>.csv, empty: none.
  std::filesystem::path detections{};
  // No run of its own: the objects of that variant's runs, placed by odometry alone.
  std::string odometry_of{};

  bool IsRun() const { return odometry_of.empty(); }
};

// A call of `armature bench`, which has the machine for itself.
struct Timing {
  std::string name{};
  std::vector<std::string> sequences{};  // names; empty: none
  std::vector<std::string> tables{}, engines{};
  int frames = 0;            // of each sequence, 0: all of the matrix
  int baseline_frames = 12;  // about so many are given to a baseline
};

// Rooms that are drawn from a recipe (`armature generate --rooms`), numbered from 0.
struct RoomSet {
  std::filesystem::path recipe{};  // absolute
  std::string name{};              // the recipe's own
  int count = 40;
  std::string split = "development";                 // one of kRoomSplits, or a seed
  std::vector<std::filesystem::path> collections{};  // folders of CAD models to furnish them with
  bool lines_only = false;                           // without pictures
};

inline constexpr std::array kRoomSplits{"development", "check"};

struct Matrix {
  std::string name = "reproduce";                  // of the folder of results
  std::filesystem::path data{};                    // where scenes are rendered to
  std::vector<std::string> scenes{};               // shipped ones
  std::vector<std::filesystem::path> sequences{};  // folders of one's own
  std::optional<RoomSet> rooms{};
  int seeds = 1;                             // draws of each scene
  int frames = 0;                            // the first so many of each sequence; 0: all
  std::vector<LearntCategory> categories{};  // empty: those of `category_folder`
  std::filesystem::path category_folder{};   // category models; empty: those of CONFIGS
  std::vector<Variant> variants{};
  std::vector<std::string> retrieval{};  // variants whose objects get their nearest CAD models
  int library_every = 10;       // each so many-th of the library's instances is a query of its own, 0: none
  std::filesystem::path cad{};  // annotated CAD models for it; empty: those rendered with the scenes
  std::vector<Timing> timings{};
  int jitter = 0;  // repeats of each run with changes that must not matter (run --jitter)
};

// Names of scenes, then of the folders of one's own, then of the rooms' recipe.
std::vector<std::string> FamilyNames(const Matrix& matrix);

// Names of the variants that have runs of their own.
std::vector<std::string> RunVariants(const Matrix& matrix);

// Only what is named: sequences and variants (all where none is named), and timings. Throws InputError for a
// name that is none of them.
void KeepOnly(const std::vector<std::string>& names, Matrix& matrix);

// Sequences of one's own instead of those of the matrix, under the same variants, with the same timings.
// Nothing is rendered then: categories are those of CONFIGS, and there is retrieval only with `cad`. Throws
// InputError: a folder that is not there, two of one name.
void ReplaceSequences(const std::vector<std::filesystem::path>& folders, Matrix& matrix);

// Rooms instead of the matrix's sequences, under the same variants, without timings; the rest as above.
void ReplaceByRooms(const RoomSet& rooms, Matrix& matrix);

// Variants by name instead of the matrix's: its own, then presets, then ablations of CONFIGS. Throws
// InputError for another name, or one that is there twice.
void SelectVariants(const std::vector<std::string>& names, const std::filesystem::path& configs,
                    Matrix& matrix);

// Each variant with these boxes, too, folders of <name>.csv: as variants named VARIANT-FOLDER after the
// others. Throws InputError: no such folder, or two variants of one name.
void AddDetections(const std::vector<std::filesystem::path>& folders, Matrix& matrix);

// Folders are told apart by their names, results by the names in sequence.yaml. Throws InputError where two
// sequences have one name there.
void CheckNamesDiffer(const Matrix& matrix);

// A sequence of the matrix: rendered from a scene, or of one's own.
struct MatrixSequence {
  std::string name{};    // of its run folders
  std::string family{};  // the scene's name without the draw; else the name
  int draw = 1;
  std::filesystem::path folder{};  // absolute
  std::optional<int> room{};       // its number, of a room
};

// Where the sequences of a draw are rendered to; absolute.
std::filesystem::path LocateDraw(const Matrix& matrix, int draw);

// Where rooms are rendered to; absolute.
std::filesystem::path LocateRooms(const Matrix& matrix);

// What tells rooms of one name apart, as folders' names end: "", "-cad", "-cad-lines".
std::string KindOfRooms(const RoomSet& rooms);

// "mixed-development-007".
std::string NameRoom(const RoomSet& rooms, int number);

// Draw after draw, each in the order of the file.
std::vector<MatrixSequence> ListSequences(const Matrix& matrix);

}  // namespace armature
