// SPDX-License-Identifier: BSD-3-Clause
// Which CAD model an object of a scene file is.
#pragma once

#include <vector>

#include "datasets/scene/scene.h"
#include "geometry/random.h"
#include "io/yaml_support.h"

namespace armature {

// The instance that an object's `category`, `collection`, `instance` and `at_most` choose: the named one, or
// one drawn among the held-out ones that are not larger, and not among the `others` while there are any
// besides. Throws InputError when there is none.
const CadInstance& ChosenInstance(const YamlMap& map, const std::vector<CadInstance>& collection,
                                  const std::vector<SceneObject>& others, Random& random);

}  // namespace armature
