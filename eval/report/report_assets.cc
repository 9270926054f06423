// SPDX-License-Identifier: BSD-3-Clause
#include "eval/report/report_assets.h"

// Defined by report_assets.s, which eval/report/assets/CMakeLists.txt writes.
extern "C" {
extern const char armature_asset_style[], armature_asset_style_end[];
extern const char armature_asset_d3[], armature_asset_d3_end[];
extern const char armature_asset_three[], armature_asset_three_end[];
extern const char armature_asset_scripts[], armature_asset_scripts_end[];
extern const char armature_asset_licences[], armature_asset_licences_end[];
}

namespace armature {

std::string_view ReportStyle() { return {armature_asset_style, armature_asset_style_end}; }
std::string_view ReportD3() { return {armature_asset_d3, armature_asset_d3_end}; }
std::string_view ReportThree() { return {armature_asset_three, armature_asset_three_end}; }
std::string_view ReportScripts() { return {armature_asset_scripts, armature_asset_scripts_end}; }
std::string_view ReportLicences() { return {armature_asset_licences, armature_asset_licences_end}; }

}  // namespace armature
