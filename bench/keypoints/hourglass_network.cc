// SPDX-License-Identifier: BSD-3-Clause
#include "bench/keypoints/hourglass_network.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <opencv2/dnn.hpp>

namespace armature {
namespace {

// Pre-activation bottleneck (He et al. 2016); where the channels change, the input is brought along by a 1x1
// convolution.
Tensor Residual(NetworkBuilder& builder, const Tensor& in, int channels) {
  const auto activated = [&](const Tensor& tensor) { return builder.Relu(builder.BatchNorm(tensor)); };
  Tensor branch = builder.Convolution(activated(in), channels / 2, 1);
  branch = builder.Convolution(activated(branch), channels / 2, 3);
  branch = builder.Convolution(activated(branch), channels, 1);
  return builder.Sum({branch, in.channels == channels ? in : builder.Convolution(in, channels, 1)});
}

Tensor Hourglass(NetworkBuilder& builder, const Tensor& in, int depth) {
  const auto residual = [&](const Tensor& tensor) { return Residual(builder, tensor, in.channels); };
  const Tensor beside = residual(in);
  const Tensor low = residual(builder.MaxPool(in));
  const Tensor lower = depth > 1 ? Hourglass(builder, low, depth - 1) : residual(low);
  return builder.Sum({beside, builder.Upsample(residual(lower))});
}

// From the picture to a quarter of its size.
Tensor Stem(NetworkBuilder& builder, const Tensor& picture, int features) {
  const Tensor first = builder.Relu(builder.BatchNorm(builder.Convolution(picture, features / 4, 7, 2)));
  const Tensor pooled = builder.MaxPool(Residual(builder, first, features / 2));
  return Residual(builder, Residual(builder, pooled, features), features);
}

void Build(NetworkBuilder& builder, const HourglassOptions& options) {
  const int features = options.features;
  Tensor in = Stem(builder, {0, 3, options.input}, features);
  for (int stack = 1; stack <= options.stacks; ++stack) {
    const Tensor out = Residual(builder, Hourglass(builder, in, options.depth), features);
    const Tensor head = builder.Relu(builder.BatchNorm(builder.Convolution(out, features, 1)));
    const Tensor maps = builder.Convolution(head, options.maps, 1);
    if (stack == options.stacks) return;  // the network's output is that of its last layer
    in = builder.Sum({in, builder.Convolution(head, features, 1), builder.Convolution(maps, features, 1)});
  }
}

}  // namespace

HourglassNetwork::HourglassNetwork(const HourglassOptions& options) : options_(options) {
  NetworkBuilder builder(options.seed);
  Build(builder, options);
  net_ = builder.net();
  cost_ = builder.cost();
  net_.setPreferableBackend(cv::dnn::DNN_BACKEND_OPENCV);
  net_.setPreferableTarget(cv::dnn::DNN_TARGET_CPU);
}

cv::Mat HourglassNetwork::Forward(const cv::Mat& picture) {
  CV_Assert(picture.type() == CV_8UC3 && picture.size() == cv::Size(options_.input, options_.input));
  net_.setInput(cv::dnn::blobFromImage(picture, 1 / 255.0));
  return net_.forward();
}

std::int64_t HourglassNetwork::OperationsByOpenCv() const {
  return net_.getFLOPS(cv::dnn::MatShape{1, 3, options_.input, options_.input});
}

Tensor NetworkBuilder::Add(const std::string& type, cv::dnn::LayerParams& parameters,
                           const std::vector<Tensor>& inputs, int channels, int size) {
  parameters.type = type;
  parameters.name = fmt::format("{}_{}", type, net_.getLayerNames().size());
  const int layer = net_.addLayer(parameters.name, type, parameters);
  for (size_t i = 0; i < inputs.size(); ++i) net_.connect(inputs[i].layer, 0, layer, static_cast<int>(i));
  for (const cv::Mat& blob : parameters.blobs) cost_.parameters += static_cast<std::int64_t>(blob.total());
  return {layer, channels, size};
}

cv::Mat NetworkBuilder::Uniform(const std::vector<int>& shape, double low, double high) {
  cv::Mat values(shape, CV_32F);
  std::generate_n(values.ptr<float>(), values.total(),
                  [&] { return static_cast<float>(random_.Uniform(low, high)); });
  return values;
}

Tensor NetworkBuilder::Convolution(const Tensor& in, int channels, int kernel, int stride) {
  const std::int64_t fan_in = std::int64_t{in.channels} * kernel * kernel;
  const double bound = std::sqrt(6.0 / static_cast<double>(fan_in));  // variance bound^2 / 3
  cv::dnn::LayerParams parameters;
  parameters.set("kernel_size", kernel);
  parameters.set("stride", stride);
  parameters.set("pad", kernel / 2);
  parameters.set("num_output", channels);
  parameters.set("bias_term", true);
  parameters.blobs = {Uniform({channels, in.channels, kernel, kernel}, -bound, bound),
                      Uniform({channels}, -0.1, 0.1)};
  const int size = in.size / stride;
  cost_.multiply_adds += fan_in * channels * size * size;
  return Add("Convolution", parameters, {in}, channels, size);
}

Tensor NetworkBuilder::BatchNorm(const Tensor& in) {
  cv::dnn::LayerParams parameters;
  parameters.set("has_weight", true);
  parameters.set("has_bias", true);
  // Mean, variance, scale, shift. The first two are measured in training, not learnt: not parameters.
  const std::vector<int> shape = {in.channels};
  parameters.blobs = {Uniform(shape, -0.1, 0.1), Uniform(shape, 0.9, 1.1), Uniform(shape, 0.9, 1.1),
                      Uniform(shape, -0.1, 0.1)};
  cost_.parameters -= std::int64_t{2} * in.channels;
  return Add("BatchNorm", parameters, {in}, in.channels, in.size);
}

Tensor NetworkBuilder::Relu(const Tensor& in) {
  cv::dnn::LayerParams parameters;
  return Add("ReLU", parameters, {in}, in.channels, in.size);
}

Tensor NetworkBuilder::MaxPool(const Tensor& in) {
  cv::dnn::LayerParams parameters;
  parameters.set("pool", "max");
  parameters.set("kernel_size", 2);
  parameters.set("stride", 2);
  return Add("Pooling", parameters, {in}, in.channels, in.size / 2);
}

Tensor NetworkBuilder::Upsample(const Tensor& in) {
  cv::dnn::LayerParams parameters;
  parameters.set("interpolation", "nearest");
  parameters.set("zoom_factor", 2);
  return Add("Resize", parameters, {in}, in.channels, 2 * in.size);
}

Tensor NetworkBuilder::Sum(const std::vector<Tensor>& terms) {
  cv::dnn::LayerParams parameters;
  parameters.set("operation", "sum");
  return Add("Eltwise", parameters, terms, terms.front().channels, terms.front().size);
}

}  // namespace armature
