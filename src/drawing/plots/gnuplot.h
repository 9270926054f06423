// SPDX-License-Identifier: BSD-3-Clause
// Pictures by gnuplot: scripts in, SVG files out. The same script gives the same bytes.
#pragma once

#include <filesystem>
#include <string>

namespace armature {

// Any text as a gnuplot string, on one line.
std::string GnuplotText(const std::string& text);

// A finite number with every digit, "NaN" (which gnuplot leaves out) otherwise.
std::string GnuplotNumber(double value);

// Colours that the colour-blind can tell apart (Okabe and Ito 2008, and grey), "#rrggbb"; begins again after
// the last.
std::string PlotColour(size_t index);

// Size (900 wide), fonts, white background, legend above and text that is taken literally: before every
// script.
std::string SvgHeader(int height = 560);

// Throws InputError when gnuplot is not there: to know before long work whose pictures would be missing.
void CheckGnuplot();

// Runs the script; returns its picture. Throws InputError when there is no gnuplot or it fails.
std::string RunGnuplot(const std::string& script);

// The picture becomes the file. Throws InputError also when the file cannot be written.
void RunGnuplot(const std::string& script, const std::filesystem::path& svg);

}  // namespace armature
