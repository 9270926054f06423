// SPDX-License-Identifier: BSD-3-Clause
#include "app/failure.h"

#include <fmt/format.h>
#include <yaml-cpp/exceptions.h>

#include <filesystem>
#include <new>
#include <nlohmann/json.hpp>
#include <opencv2/core.hpp>
#include <stdexcept>

#include "base/errors.h"

namespace armature {
namespace {

constexpr int kFailed = 1, kBadInput = 2;

Failure OutOfMemory() {
  return {"there is not enough memory; give a smaller input, or run it on a larger machine", kFailed};
}

// What a name of a file can be blamed for; a full disk, say, it cannot.
bool IsOfTheName(const std::error_code& code) {
  for (const std::errc name :
       {std::errc::no_such_file_or_directory, std::errc::not_a_directory, std::errc::is_a_directory,
        std::errc::too_many_symbolic_link_levels, std::errc::filename_too_long, std::errc::permission_denied,
        std::errc::operation_not_permitted, std::errc::invalid_argument}) {
    if (code == name) return true;
  }
  return false;
}

Failure OfFile(const std::filesystem::filesystem_error& error) {
  const std::string file = error.path1().empty() ? "a file" : error.path1().string();
  const std::string remedy = IsOfTheName(error.code()) ? "; check that it exists and may be used" : "";
  return {fmt::format("{}: {}{}", file, error.code().message(), remedy),
          IsOfTheName(error.code()) ? kBadInput : kFailed};
}

}  // namespace

Failure DescribeFailure(const std::exception_ptr& exception) {
  try {
    std::rethrow_exception(exception);
  } catch (const InputError& error) {
    return {error.what(), kBadInput};
  } catch (const std::bad_alloc&) {
    return OutOfMemory();
  } catch (const std::length_error&) {  // of a container that was to be larger than there can be memory
    return OutOfMemory();
  } catch (const std::filesystem::filesystem_error& error) {
    return OfFile(error);
  } catch (const nlohmann::detail::exception& error) {
    return {fmt::format("a JSON file is not as it should be: {}", error.what()), kBadInput};
  } catch (const YAML::Exception& error) {
    return {fmt::format("a YAML file is not as it should be: {}", error.what()), kBadInput};
  } catch (const cv::Exception& error) {
    if (error.code == cv::Error::StsNoMem) return OutOfMemory();
    return {fmt::format("OpenCV failed: {}", error.err), kFailed};
  } catch (const std::exception& error) {
    const std::string what = error.what();
    return {what.empty() ? "failed, and did not say at what" : what, kFailed};
  } catch (...) {
    return {"failed, and did not say at what", kFailed};
  }
}

}  // namespace armature
