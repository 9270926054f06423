// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/cad/families.h"

#include <fmt/format.h>

#include <vector>

#include "base/errors.h"
#include "datasets/cad/cad_instance.h"
#include "datasets/cad/chair.h"
#include "datasets/cad/laptop.h"
#include "datasets/cad/table.h"

namespace armature {
namespace {

template <typename Parameters>
std::vector<Wireframe> Made(const std::vector<Parameters>& members, Wireframe (*make)(const Parameters&)) {
  std::vector<Wireframe> wireframes;
  for (const Parameters& member : members) wireframes.push_back(make(member));
  return wireframes;
}

std::vector<Wireframe> FamilyWireframes(const FamilySample& sample) {
  const std::string& family = sample.family;
  if (family == "chair") return Made(SampleChairFamily(sample.count, sample.seed), ChairWireframe);
  if (family == "table") return Made(SampleTableFamily(sample.count, sample.seed), TableWireframe);
  if (family == "laptop") return Made(SampleLaptopFamily(sample.count, sample.seed), LaptopWireframe);
  throw InputError(fmt::format("unknown family '{}'; families: chair, table, laptop", family));
}

// In metres and centred.
}  // namespace

FamilyMembers SampleFamily(const FamilySample& sample) {
  return {FamilyWireframes(sample), EdgeNames(sample.family)};
}

}  // namespace armature
