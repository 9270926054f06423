// SPDX-License-Identifier: BSD-3-Clause
#include "retrieval/retrieval_options.h"

namespace armature {

std::vector<OptionEntry> RetrievalOptionTable(RetrievalOptions& o) {
  return {
      Option("retrieval.k", &o.k, "nearest instances that are listed", 1, 1000000),
      Option("retrieval.radius", &o.radius, "only instances at most this far, 0: however far", 0),
      Option("retrieval.space", &o.features.space,
             "distances of coefficients: in standard deviations, or metres"),
      Option("retrieval.modes", &o.features.modes, "only the first so many coefficients, 0: all", 0,
             kMaxModes),
      Option("retrieval.with_size", &o.features.with_size, "the box's size as three more dimensions"),
      Option("retrieval.size_sigma", &o.features.size_sigma,
             "metres of size that count as one standard deviation (space whitened)", 1e-3, 10),
      Option("retrieval.index", &o.index.kind, "how nearest neighbours are found, by FLANN"),
      Option("retrieval.leaf_size", &o.index.leaf_size, "kdtree_single: instances a leaf", 1, 1000),
      Option("retrieval.trees", &o.index.trees, "kdtree: how many", 1, 64),
      Option("retrieval.branching", &o.index.branching, "kmeans: branches of a node", 2, 1000),
      Option("retrieval.iterations", &o.index.iterations, "kmeans: at most", 1, 1000),
      Option("retrieval.checks", &o.index.checks, "kdtree, kmeans: instances looked at in a query", 1,
             1000000),
      Option("retrieval.covariance", &o.covariance, "weigh by the covariance of the estimated coefficients"),
      Option("retrieval.evidence_sigma", &o.evidence_sigma,
             "standard deviations that are added to that covariance", 0, 10),
      Option("retrieval.rerank", &o.rerank,
             "order the nearest by how well their own edges explain the images"),
      Option("retrieval.candidates", &o.candidates, "how many of the nearest are re-ranked", 1, 1000000),
      Option("retrieval.views", &o.views, "images at most that they are re-ranked by", 1, 100000),
      Option("retrieval.map_sigma", &o.fit.size_sigma, "of the logarithm of the map's scale, when re-ranking",
             0, 1),
      Option("retrieval.first_gate", &o.fit.refinement.first_gate_pixels,
             "pixels: an edge's first matches when re-ranking", 0.5, 100),
      Option("retrieval.last_gate", &o.fit.refinement.last_gate_pixels, "pixels: its last ones", 0.5, 100),
      Option("retrieval.score_gate", &o.fit.score_gate_pixels, "pixels: the matches that count", 0.5, 100),
      Option("retrieval.rounds", &o.fit.refinement.rounds, "of matching and fitting when re-ranking", 1, 100),
  };
}

}  // namespace armature
