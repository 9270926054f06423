// SPDX-License-Identifier: BSD-3-Clause
// The dense arithmetic of a sparse Cholesky factorisation in 6x6 blocks (block_cholesky.h): nearly all of its
// time is spent here. The processor's AVX2 is used where it has it; the bits of the result depend on that,
// and on nothing else.
#pragma once

#include <vector>

namespace armature {

constexpr int kBlockSize = 6;
// Columns have this many rows more than the matrix, 0 in the panel: vectors reach over the end.
constexpr int kRowPadding = 8;

// Eliminates the first `pivots` unknowns of a symmetric matrix of `rows` unknowns, both multiples of 6. The
// matrix is given by its lower triangle, column-major: the first `pivots` columns in `panel`, rows +
// kRowPadding apart; the rest in `update`, rows - pivots + kRowPadding apart. On return the panel holds the
// columns of the factor L and `update` has L_2 L_2^T taken off. False when a pivot is not positive.
bool EliminatePivots(int rows, int pivots, double* panel, double* update);

}  // namespace armature
