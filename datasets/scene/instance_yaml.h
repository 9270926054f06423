// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "datasets/cad/cad_instance.h"
#include "datasets/random.h"
#include "io/yaml_support.h"

namespace armature {

// The instance that an object's `category`, `instance` and `at_most` choose: the named one, or one drawn
// among the held-out ones that are not larger. Throws InputError when there is none.
const CadInstance& ChosenInstance(const YamlMap& map, const std::vector<CadInstance>& collection,
                                  Random& random);

}  // namespace armature
