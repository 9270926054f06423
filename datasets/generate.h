// SPDX-License-Identifier: BSD-3-Clause
// Makes the embedded data: annotated CAD models and rendered sequences. Folders are complete or absent, and
// are used again when they were made from the same.
#pragma once

#include <filesystem>
#include <functional>
#include <vector>

#include "datasets/cad/cad_instance.h"

namespace armature {

struct Generated {
  std::filesystem::path folder;
  bool is_new = false;  // false: it was there already
};

// Writes the collection (cad/collection_files.h). Throws InputError when something else is at `folder`.
Generated GenerateCad(const std::filesystem::path& folder, const CollectionOptions& options,
                      const std::vector<CadInstance>& collection);

struct SequenceOptions {
  int frames = 0;              // only the first so many of the path; 0: all
  double detection_noise = 1;  // factor of everything that the detections have wrong
  int draw = 1;                // see ReadScene
  bool lines_only = false;     // no pictures, but the lines that the detector would find in them
};

// Renders one scene into a sequence folder OUT/<name of the scene>, with a copy of the scene file beside it.
// The same bytes for the same scene, collection and options, whatever the number of threads. `on_start` is
// told the name and the number of frames, `on_frame` is called after each of them, by one thread at a time;
// what it throws ends the work. Throws InputError: the scene is wrong, or something else is at the folder.
struct GenerationProgress {
  std::function<void(const std::string& name, int frames)> on_start = [](const std::string&, int) {};
  std::function<void()> on_frame = [] {};
};
Generated GenerateSequence(const std::filesystem::path& scene_file,
                           const std::vector<CadInstance>& collection, const std::filesystem::path& out,
                           const SequenceOptions& options, const GenerationProgress& progress);

}  // namespace armature
