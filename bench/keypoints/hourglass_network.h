// SPDX-License-Identifier: BSD-3-Clause
// A stacked hourglass (Newell, Yang, Deng: Stacked Hourglass Networks for Human Pose Estimation, ECCV 2016),
// the kind of network that finds keypoints, of its published size but with random weights: it knows nothing,
// and takes the time that one takes which does.
//
// Its layers are those of the authors' code (github.com/princeton-vl/pose-hg-train, src/models/hg.lua) in the
// widths of its PyTorch port, of which a two-stack model was published (github.com/bearpaw/pytorch-pose,
// pose/models/hourglass.py, hg_s2_b1). The two differ before the first hourglass, where the port's residuals
// have 256 channels one earlier, and after each, where the port has one residual more.
//
// Counted for the 16 maps of human joints, in our layers:
//   stacks  parameters   multiply-adds  known as
//     2      6 730 912   8 988 917 760  the port's hg_s2_b1, 6.73 M
//     8     25 594 624  28 094 496 768  the port's hg_s8_b1, of the eight stacks of Newell et al.
// The parameters are those of the port's code, layer by layer; for the multiply-adds no published figure was
// found, so OpenCV's own count stands against ours (a test).
// Parameters are weights and biases of convolutions, scales and shifts of batch normalisations.
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>
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

struct HourglassOptions {
  int stacks = 2;
  int depth = 4;       // halvings in an hourglass
  int features = 256;  // channels, even
  int maps = 16;       // heat maps out, one a keypoint
  int input = 256;     // pixels, of the square picture; the maps have a quarter of it
  std::uint64_t seed = 1;
};

class HourglassNetwork {
 public:
  explicit HourglassNetwork(const HourglassOptions& options);

  // `picture`: 8 bit, three channels, input x input pixels. Returns the last stack's maps, 1 x maps x input/4
  // x input/4 floats, which stay valid until the next call. On the CPU, in as many threads as OpenCV may use.
  cv::Mat Forward(const cv::Mat& picture);

  const NetworkCost& cost() const { return cost_; }
  // Additions and multiplications of all layers as OpenCV counts them.
  std::int64_t OperationsByOpenCv() const;

 private:
  HourglassOptions options_;
  cv::dnn::Net net_;
  NetworkCost cost_;
};

}  // namespace armature
