// SPDX-License-Identifier: BSD-3-Clause
// Laptops more or less open than their models have them.
#pragma once

#include "datasets/cad/cad_instance.h"

namespace armature {

// Between base and screen, degrees; of a laptop.
double LidAngle(const Wireframe& laptop);

// Turned about its hinge until the angle between base and screen is this one, centred again. What of the mesh
// is nearer to the plane of the screen than to that of the base is the lid. Of a loaded laptop.
CadInstance WithLid(CadInstance laptop, double degrees);

}  // namespace armature
