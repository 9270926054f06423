// SPDX-License-Identifier: BSD-3-Clause
#include "app/retrieve/retrieve_run.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/errors.h"
#include "base/interrupt.h"
#include "cli/configuration.h"
#include "io/run_map.h"
#include "io/run_results.h"
#include "io/sequence.h"

namespace armature {
namespace {

namespace fs = std::filesystem;

// The views that re-ranking needs, found once for all objects.
class Looker {
 public:
  Looker(const RunRetrieval& retrieval, const fs::path& sequence, const fs::path& detections,
         const std::vector<CategoryModel>& models, const RetrievalOptions& options)
      : map_(retrieval.map),
        up_world_(EstimateUp(retrieval.map)),
        sequence_(LoadSequence(sequence, CategoryNames(models), {}, detections)) {
    std::vector<size_t> cameras;
    for (size_t o = 0; o < map_.objects.size(); ++o) {
      sightings_.push_back(SightingsToLookAt(map_, o, options.views));
      for (const Sighting& sighting : sightings_.back()) cameras.push_back(sighting.camera);
    }
    views_ = MakeViews(map_, cameras, sequence_, models, ReadRunOptions(retrieval.run));
  }

  ObjectSightings At(size_t object) const {
    return LookAt(map_, object, sightings_[object], views_, up_world_);
  }

 private:
  const Map& map_;
  Eigen::Vector3d up_world_;
  Sequence sequence_;  // the views point to its camera
  std::vector<std::vector<Sighting>> sightings_;
  ViewsOfCameras views_;
};

fs::path FindSequence(const RunResults& run, const fs::path& given) {
  fs::path folder = given.empty() ? run.sequence_folder : given;
  if (fs::exists(folder / "sequence.yaml")) return folder;
  throw InputError(
      fmt::format("{}: its sequence is not at '{}'; name its folder with --sequence, or do not re-rank "
                  "(--set retrieval.rerank=false)",
                  run.folder.string(), folder.string()));
}

}  // namespace

RunRetrieval RetrieveRun(const fs::path& run, const fs::path& sequence,
                         const std::vector<CategoryModel>& models, const OpenLibrary& library,
                         const RetrievalOptions& options) {
  const RunResults results = LoadRun(run);
  RunRetrieval retrieval{run, results.sequence, ReadRunMap(results, models), {}};
  std::optional<Looker> looker;
  if (options.rerank && !retrieval.map.objects.empty())
    looker.emplace(retrieval, FindSequence(results, sequence), results.detections, models, options);
  for (size_t o = 0; o < retrieval.map.objects.size(); ++o) {
    ThrowIfInterrupted();
    const MapObject& object = retrieval.map.objects[o];
    ObjectInstances& found = retrieval.objects.emplace_back();
    found.object = o;
    const InstanceRetrieval* nearest = library.Of(object.model->spec.name);
    if (nearest == nullptr) continue;
    found.library = &nearest->instances();
    const ShapeQuery query{object.coefficients, object.Size(), object.evidence};
    std::optional<ObjectSightings> sightings;
    if (looker) sightings = looker->At(o);
    found.instances = nearest->Retrieve(query, sightings ? &*sightings : nullptr);
  }
  return retrieval;
}

}  // namespace armature
