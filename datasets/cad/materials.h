// SPDX-License-Identifier: BSD-3-Clause
// What furniture is made of: woods, paint, fabric, metal, plastic in the colours that shops have.
#pragma once

#include "datasets/cad/chair.h"
#include "datasets/cad/laptop.h"
#include "datasets/cad/table.h"
#include "geometry/random.h"

namespace armature {

Material DrawWood(Random& random);
Material DrawPaint(Random& random);
Material DrawFabric(Random& random);
Material DrawMetal(Random& random);
Material DrawPlastic(Random& random);

// Such as go together, and with the shape: thin legs are of metal, cushions of fabric.
ChairMaterials DrawChairMaterials(Random& random, const ChairParameters& chair);
TableMaterials DrawTableMaterials(Random& random, const TableParameters& table);
LaptopMaterials DrawLaptopMaterials(Random& random);

}  // namespace armature
