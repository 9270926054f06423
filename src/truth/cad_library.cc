// SPDX-License-Identifier: BSD-3-Clause
#include "truth/cad_library.h"

#include <utility>

#include "io/cad_folder.h"

namespace armature {

CadLibrary::CadLibrary(const std::filesystem::path& folder, const std::vector<CategorySpec>& specs) {
  for (CadModel& model : ReadCadFolder(folder, specs)) {
    std::string name = model.instance;
    models_[std::move(name)] = std::move(model);
  }
}

std::optional<Wireframe> CadLibrary::FindEdges(const TrueObject& object) const {
  const auto found = models_.find(object.instance);
  if (found == models_.end()) return std::nullopt;
  return FittedToSize(found->second, object.size);
}

Wireframe FittedToSize(const CadModel& model, const Eigen::Vector3d& size) {
  const Eigen::Vector3d scale = size.cwiseQuotient(model.box_max - model.box_min);
  const Eigen::Vector3d center = (model.box_min + model.box_max) / 2;
  return {scale.asDiagonal() * (model.wireframe.midpoints.colwise() - center),
          scale.asDiagonal() * model.wireframe.directions};
}

}  // namespace armature
