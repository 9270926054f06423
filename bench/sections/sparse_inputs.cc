// SPDX-License-Identifier: BSD-3-Clause
#include "bench/sections/sparse_inputs.h"

#include <algorithm>

namespace armature {

std::vector<size_t> SparseInputs(const std::function<bool(size_t input)>& is_used, size_t inputs,
                                 size_t warm_up, size_t count) {
  std::vector<size_t> used;
  for (size_t input = warm_up; input < inputs; ++input) {
    if (is_used(input)) used.push_back(input);
  }
  std::vector<size_t> sparse;
  for (size_t input = warm_up - std::min(warm_up, kSparseWarmUp); input < warm_up; ++input)
    sparse.push_back(input);
  const size_t step = std::max<size_t>(1, used.size() / std::max<size_t>(1, count));
  for (size_t i = 0; i < used.size(); i += step) sparse.push_back(used[i]);
  return sparse;
}

std::function<bool(size_t input)> PickOne(std::vector<size_t> inputs) {
  return [inputs = std::move(inputs)](size_t input) {
    return std::binary_search(inputs.begin(), inputs.end(), input);
  };
}

}  // namespace armature
