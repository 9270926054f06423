// SPDX-License-Identifier: BSD-3-Clause
// Instances in other sizes.
#pragma once

#include "datasets/cad/cad_instance.h"

namespace armature {

// Stretched along the axes of its object frame so that the mesh's bounding box has this size, metres; the
// edges with it. Textures keep their size. Of a loaded instance.
CadInstance Resized(CadInstance instance, const Eigen::Vector3d& size);

// With its mesh, which collections on disk read only now, centred. Throws InputError: a malformed file.
CadInstance Loaded(CadInstance instance);

}  // namespace armature
