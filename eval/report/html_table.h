// SPDX-License-Identifier: BSD-3-Clause
// A table as a figure of an HTML page.
#pragma once

#include <string>

#include "io/text_table.h"

namespace armature {

// With the title as caption and the notes under it, folded when they are long. Cells of numbers have the
// class "number"; nothing is a dash. `id` is the figure's.
std::string TableHtml(const Table& table, const std::string& id);

}  // namespace armature
