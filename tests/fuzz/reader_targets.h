// SPDX-License-Identifier: BSD-3-Clause
// All that the program reads, for the fuzzer: a row a kind of file.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace armature::fuzzing {

namespace fs = std::filesystem;

struct ReaderTarget {
  std::string name;
  std::string file;                    // in tests/fuzz/sample: the first input, and where each input is put
  void (*read)(const fs::path& file);  // throws InputError; that anything else is thrown is a fault
  // What is made of the fuzzer's bytes before; null: nothing.
  std::string (*seal)(std::string bytes) = nullptr;
};

const std::vector<ReaderTarget>& ReaderTargets();

}  // namespace armature::fuzzing
