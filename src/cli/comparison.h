// SPDX-License-Identifier: BSD-3-Clause
// What `armature compare` shows of two results, whatever they are of.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "io/text_table.h"

namespace armature {

// What comes out of comparing B with A.
struct Comparison {
  std::vector<Table> tables;
  std::vector<std::string> warnings;  // also notes of the tables
  std::string raw;                    // rows a pair, see RawPairColumns
};

// Compares two folders, the first is A. Throws InputError.
using CompareFolders = std::function<Comparison(const std::filesystem::path&, const std::filesystem::path&)>;

}  // namespace armature
