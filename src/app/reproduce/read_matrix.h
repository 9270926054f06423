// SPDX-License-Identifier: BSD-3-Clause
// Reads the matrix that `armature reproduce` runs: configs/reproduce.yaml says what each key means.
#pragma once

#include <filesystem>
#include <string>

#include "app/reproduce/matrix.h"

namespace armature {

struct MatrixReading {
  bool fast = false;  // with what the file's key `fast` changes
  // The sequences of ReplaceSequences, or rooms, are to be run instead of the file's, which then need not
  // have any.
  bool has_own_sequences = false;
};

// A recipe of rooms with the name that it gives itself. Throws InputError: not there, malformed, no plain
// name.
RoomSet ReadRoomSet(const std::filesystem::path& recipe);

// Relative configurations of variants are looked for beside the file. Throws InputError naming file and line:
// an unknown key, a value of another type, a name that is used twice or not known, nothing to run.
Matrix ReadMatrix(const std::filesystem::path& file, const MatrixReading& reading);

}  // namespace armature
