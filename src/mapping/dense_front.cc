// SPDX-License-Identifier: BSD-3-Clause
#include "mapping/dense_front.h"

#include <cmath>

namespace armature {
namespace {

#define ARMATURE_INLINE inline __attribute__((always_inline))

// Vectors of GCC and Clang: the same code for each width. They may start at any double.
struct TwoLanes {
  using Vector __attribute__((vector_size(16), aligned(8), may_alias)) = double;
};
struct FourLanes {
  using Vector __attribute__((vector_size(32), aligned(8), may_alias)) = double;
};

// C -= A B^T in six columns of C, rows first <= i < rows; B is the six rows of A from row `first` on. Column
// k of A starts at a + k * stride. A tile of two vectors times six columns stays in registers. Rows are taken
// up to the next multiple of the tile.
template <typename Lanes>
ARMATURE_INLINE void SubtractProduct(const double* a, long stride, int depth, int first, int rows, double* c,
                                     long c_stride) {
  using Vector = typename Lanes::Vector;
  constexpr int kLanes = sizeof(Vector) / sizeof(double);
  const double* b = a + first;
  for (int i = first; i < rows; i += 2 * kLanes) {
    Vector upper[kBlockSize] = {}, lower[kBlockSize] = {};
    for (int k = 0; k < depth; ++k) {
      const Vector a_upper = *reinterpret_cast<const Vector*>(a + k * stride + i);
      const Vector a_lower = *reinterpret_cast<const Vector*>(a + k * stride + i + kLanes);
#pragma GCC unroll 6
      for (int j = 0; j < kBlockSize; ++j) {
        upper[j] += a_upper * b[k * stride + j];
        lower[j] += a_lower * b[k * stride + j];
      }
    }
#pragma GCC unroll 6
    for (int j = 0; j < kBlockSize; ++j) {
      *reinterpret_cast<Vector*>(c + j * c_stride + i) -= upper[j];
      *reinterpret_cast<Vector*>(c + j * c_stride + i + kLanes) -= lower[j];
    }
  }
}

// Cholesky factorisation of a 6x6 block in place, and of what is below it: rows 0 <= i < rows of six columns.
ARMATURE_INLINE bool FactorizeColumns(int rows, double* c, long stride) {
  for (int j = 0; j < kBlockSize; ++j) {
    double* column = c + j * stride;
    for (int k = 0; k < j; ++k) {
      const double* earlier = c + k * stride;
      const double factor = earlier[j];
      for (int i = j; i < rows; ++i) column[i] -= factor * earlier[i];
    }
    if (!(column[j] > 0) || !std::isfinite(column[j])) return false;
    const double inverse = 1 / std::sqrt(column[j]);
    for (int i = j; i < rows; ++i) column[i] *= inverse;
  }
  return true;
}

template <typename Lanes>
ARMATURE_INLINE bool Eliminate(int rows, int pivots, double* panel, double* update) {
  const long stride = rows + kRowPadding;
  for (int j = 0; j < pivots; j += kBlockSize) {
    SubtractProduct<Lanes>(panel, stride, j, j, rows, panel + j * stride, stride);
    if (!FactorizeColumns(rows - j, panel + j * stride + j, stride)) return false;
  }
  const int rest = rows - pivots;
  const long update_stride = rest + kRowPadding;
  for (int j = 0; j < rest; j += kBlockSize) {
    SubtractProduct<Lanes>(panel + pivots, stride, pivots, j, rest, update + j * update_stride,
                           update_stride);
  }
  return true;
}

#ifdef __x86_64__
__attribute__((target("avx2,fma"))) bool EliminateAvx2(int rows, int pivots, double* panel, double* update) {
  return Eliminate<FourLanes>(rows, pivots, panel, update);
}

bool HasAvx2() { return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"); }
#endif

}  // namespace

bool EliminatePivots(int rows, int pivots, double* panel, double* update) {
#ifdef __x86_64__
  static const bool has_avx2 = HasAvx2();
  if (has_avx2) return EliminateAvx2(rows, pivots, panel, update);
#endif
  return Eliminate<TwoLanes>(rows, pivots, panel, update);
}

}  // namespace armature
