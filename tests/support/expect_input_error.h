// SPDX-License-Identifier: BSD-3-Clause
// Checks of the messages of bad input.
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

#include "base/errors.h"

namespace armature::testing {

// `action` has to throw an InputError of exactly one line in which each of the texts occurs.
inline void ExpectInputError(const std::function<void()>& action, const std::vector<std::string>& texts) {
  try {
    action();
  } catch (const InputError& error) {
    const std::string message = error.what();
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    for (const std::string& text : texts) {
      EXPECT_NE(message.find(text), std::string::npos) << "no '" << text << "' in: " << message;
    }
    return;
  }
  ADD_FAILURE() << "no InputError was thrown";
}

}  // namespace armature::testing
