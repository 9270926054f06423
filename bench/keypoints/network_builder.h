// SPDX-License-Identifier: BSD-3-Clause
// Puts a convolutional network together layer by layer, with random weights, and counts what it costs.
#pragma once

#include <cstdint>
#include <opencv2/dnn.hpp>
#include <string>
#include <vector>

#include "geometry/random.h"

namespace armature {

// What one layer hands to the next: channels of size x size values.
struct Tensor {
  int layer = 0;  // that it comes out of, the network's own number; 0: the input
  int channels = 0;
  int size = 0;
};

struct NetworkCost {
  std::int64_t parameters = 0;     // that training would learn: weights, biases, scales and shifts
  std::int64_t multiply_adds = 0;  // of the convolutions in one forward pass
};

class NetworkBuilder {
 public:
  explicit NetworkBuilder(std::uint64_t seed) : random_(seed) {}

  // Square kernel of odd size, padded so that stride 1 keeps the size. Weights are uniform with the variance
  // of He et al. 2015, 2 / inputs of a neuron, so that layers followed by ReLU neither swell nor fade.
  Tensor Convolution(const Tensor& in, int channels, int kernel, int stride = 1);
  // Batch normalisation as it is once trained: by fixed means and variances, then scale and shift.
  Tensor BatchNorm(const Tensor& in);
  Tensor Relu(const Tensor& in);
  Tensor MaxPool(const Tensor& in);   // 2 x 2: half the size
  Tensor Upsample(const Tensor& in);  // nearest neighbour: twice the size
  Tensor Sum(const std::vector<Tensor>& terms);

  const cv::dnn::Net& net() const { return net_; }
  const NetworkCost& cost() const { return cost_; }

 private:
  Tensor Add(const std::string& type, cv::dnn::LayerParams& parameters, const std::vector<Tensor>& inputs,
             int channels, int size);
  // Uniform in [low, high).
  cv::Mat Uniform(const std::vector<int>& shape, double low, double high);

  cv::dnn::Net net_;
  Random random_;
  NetworkCost cost_;
};

}  // namespace armature
