// SPDX-License-Identifier: BSD-3-Clause
#include "bench/keypoints/hourglass_network.h"

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

}  // namespace armature
