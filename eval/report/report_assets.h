// SPDX-License-Identifier: BSD-3-Clause
// The files of eval/report/assets and the libraries that the page's scripts use, as they were when the
// program was built.
#pragma once

#include <string_view>

namespace armature {

std::string_view ReportStyle();
std::string_view ReportD3();     // https://d3js.org
std::string_view ReportThree();  // https://threejs.org with its OrbitControls
std::string_view ReportScripts();
std::string_view ReportLicences();  // of the two libraries

}  // namespace armature
