// SPDX-License-Identifier: BSD-3-Clause
// `armature learn`: a category model from annotated CAD models or from one of our families.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "io/training_models.h"

namespace armature {

struct LearnArguments {
  std::filesystem::path spec;  // category specification
  AnnotatedFile annotations;   // annotated models, or
  std::string family;          // chair, table or laptop
  int count = 2000;            // models drawn from the family
  std::uint64_t seed = 1;      // of the family
  int modes = 0;               // 0: as the specification says
  std::vector<double>
      padding;  // how these models reach beyond their edges, x y z in metres; empty: as specified
  std::optional<double> slab_drop;  // SlabOutline::drop, metres; none: as specified
  int held_out = 0;                 // 0: no held-out check, otherwise every n-th model is left out
  AnnotatedFile compare;            // another set, seen in the learnt modes
  std::string compare_family;       // the same, of a family
  std::string source;  // what the models are and their licence, written to the model; empty: from above
  std::filesystem::path out;      // model file to write; empty: none
  std::filesystem::path library;  // library of the CAD models in the annotations' folder; empty: none
  bool json = false;
};

// Draws members of a family. Throws InputError for an unknown one.
using SampleFamilyFunction = std::function<FamilyMembers(const FamilySample&)>;

// Learns, prints the explained variances (and the held-out errors), writes the model. Returns the exit
// status; throws InputError.
int RunLearn(const LearnArguments& arguments, const SampleFamilyFunction& sample_family);

// Adds the sub-command; once it is parsed, its callback runs RunLearn and stores the exit status.
void AddLearnCommand(CLI::App& app, const SampleFamilyFunction& sample_family, int& exit_status);

}  // namespace armature
