// SPDX-License-Identifier: BSD-3-Clause
#include "bench/sparse_contender.h"

#include <algorithm>

namespace armature {

void MakeSparse(Contender& contender, const std::function<bool(size_t input)>& is_used, size_t inputs,
                size_t warm_up, size_t count) {
  size_t used = 0;
  for (size_t input = warm_up; input < inputs; ++input) used += is_used(input) ? 1 : 0;
  contender.every = std::max<size_t>(1, used / std::max<size_t>(1, count));
  contender.wants = [is_used, warm_up](size_t input) {
    return input < warm_up ? input + kSparseWarmUp >= warm_up : is_used(input);
  };
}

}  // namespace armature
