// SPDX-License-Identifier: BSD-3-Clause
// The CAD models that a sequence's objects are made of. For evaluation only.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "category/cad_model.h"
#include "truth/ground_truth.h"

namespace armature {

class CadLibrary {
 public:
  // Without any model: no object has known edges.
  CadLibrary() = default;

  // The models of a folder, see io/cad_folder.h. Throws InputError as ReadCadFolder.
  CadLibrary(const std::filesystem::path& folder, const std::vector<CategorySpec>& specs);

  // The object's own edges in its frame, metres: scaled along each axis so that the CAD model's bounding box
  // gets the object's size, and moved so that the box's centre is the origin. None where the instance is not
  // in the library.
  std::optional<Wireframe> FindEdges(const TrueObject& object) const;

 private:
  std::map<std::string, CadModel> models_;  // by instance
};

// A box (any origin, any unit) brought to the given size and centred at the origin, with the wireframe in it.
Wireframe FittedToSize(const CadModel& model, const Eigen::Vector3d& size);

}  // namespace armature
