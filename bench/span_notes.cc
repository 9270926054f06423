// SPDX-License-Identifier: BSD-3-Clause
#include "bench/span_notes.h"

#include <fmt/format.h>

namespace armature {

std::string ClockNote(const BenchSettings& settings) {
  return fmt::format(
      "ms: milliseconds of a steady wall clock, {} thread{}; images are loaded and gray before; contenders "
      "and a calibration loop take turns on each frame; the first {} frames of each of {} repetition{} are "
      "warm-up and do not "
      "count.",
      settings.threads, settings.threads == 1 ? "" : "s", settings.harness.warm_up,
      settings.harness.repetitions, settings.harness.repetitions == 1 ? "" : "s");
}

std::vector<std::string> StageNotes() {
  return {"detection: line segments of a whole frame; of a baseline its network, one pass an object.",
          "association: hypotheses and matches of all objects; of a baseline keypoints from heat maps.",
          "optimization: pose and shape of all objects. mapping: what is kept between frames, and the map.",
          "total: around the whole call, with what a baseline counts without waiting; other: total less "
          "stages. A "
          "dash: there is no such stage."};
}

std::vector<std::string> EngineNotes(const std::vector<std::string>& names, const EngineParts& parts) {
  std::vector<std::string> notes;
  for (const std::string& name : names)
    notes.push_back(fmt::format("{}: {}.", name, MakeEngine(name, parts)->Description()));
  return notes;
}

}  // namespace armature
