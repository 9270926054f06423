// SPDX-License-Identifier: BSD-3-Clause
#include "drawing/plots/gnuplot.h"

#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <memory>
#include <system_error>

#include "base/child_process.h"
#include "base/errors.h"

namespace armature {
namespace {

constexpr std::array<const char*, 8> kColours = {"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                                 "#e69f00", "#56b4e9", "#000000", "#999999"};

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

File TemporaryFile(const std::string& content) {
  File file(std::tmpfile());
  if (!file || std::fputs(content.c_str(), file.get()) < 0 || std::fflush(file.get()) != 0)
    throw InputError(
        fmt::format("cannot write a temporary file: {}; make room in /tmp", std::strerror(errno)));
  std::rewind(file.get());
  return file;
}

std::string Content(std::FILE* file) {
  std::string content;
  std::array<char, 4096> part;
  std::rewind(file);
  while (const size_t size = std::fread(part.data(), 1, part.size(), file)) content.append(part.data(), size);
  return content;
}

// Reads the script and writes the picture through files that are open already. What is wrong; empty: nothing.
std::string Draw(std::FILE* script, std::FILE* svg) {
  try {
    // -d: no settings of the user's own.
    ChildProcess gnuplot(
        {.program = "gnuplot", .arguments = {"-d", "-"}, .input = fileno(script), .output = fileno(svg)});
    if (gnuplot.Wait() == 0) return "";
  } catch (const std::system_error& error) {
    return fmt::format(
        "cannot start gnuplot, which draws the plots: {}; install it (apt-get install gnuplot-nox)",
        error.code().message());
  }
  return "gnuplot failed, its reason is above; 5.4 or later is needed (apt-get install gnuplot-nox)";
}

}  // namespace

std::string GnuplotText(const std::string& text) {
  std::string quoted = "'";
  for (const char c : text) {
    if (c == '\'') quoted += '\'';
    quoted += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
  }
  return quoted + "'";
}

std::string GnuplotNumber(double value) { return std::isfinite(value) ? fmt::format("{}", value) : "NaN"; }

std::string PlotColour(size_t index) { return kColours[index % kColours.size()]; }

std::string SvgHeader(int height) {
  return "set encoding utf8\n"
         "set terminal svg size 900," +
         std::to_string(height) +
         " fixed noenhanced font 'sans-serif,15' background '#ffffff'\n"
         "set border 3 lc rgb '#404040'\n"
         "set tics nomirror out\n"
         "set key tmargin center horizontal Left reverse samplen 2\n"
         "set grid lt 1 lw 1 lc rgb '#dddddd'\n";
}

void CheckGnuplot() {
  const File script = TemporaryFile(""), picture = TemporaryFile("");
  const std::string failure = Draw(script.get(), picture.get());
  if (!failure.empty()) throw InputError(failure + ", or leave them out with --no-plots");
}

std::string RunGnuplot(const std::string& script) {
  const File input = TemporaryFile(script), output = TemporaryFile("");
  const std::string failure = Draw(input.get(), output.get());
  if (!failure.empty()) throw InputError(failure);
  return Content(output.get());
}

void RunGnuplot(const std::string& script, const std::filesystem::path& svg) {
  const File input = TemporaryFile(script);
  const File output(std::fopen(svg.c_str(), "wb"));
  if (!output) {
    throw InputError(fmt::format("{}: cannot write the picture: {}; choose a folder that can be written",
                                 svg.string(), std::strerror(errno)));
  }
  const std::string failure = Draw(input.get(), output.get());
  if (failure.empty()) return;
  std::error_code ignored;
  std::filesystem::remove(svg, ignored);
  throw InputError(svg.string() + ": " + failure);
}

}  // namespace armature
