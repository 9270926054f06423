// SPDX-License-Identifier: BSD-3-Clause
// The parametric families of furniture by name, as `armature learn --family` draws from them.
#pragma once

#include <string>

#include "io/training_models.h"

namespace armature {

// Throws InputError for another family than chair, table, laptop.
FamilyMembers SampleFamily(const FamilySample& sample);

}  // namespace armature
