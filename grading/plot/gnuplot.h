// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

// What all plots do with gnuplot.
namespace plot {

/// A string of gnuplot: within single quotes only they themselves are special.
std::string quoted(const std::string &text);

/// \throws PlotError  if it cannot be written
void writeFile(const std::filesystem::path &file, const std::string &text);
std::string readFile(const std::filesystem::path &file);

/// Runs gnuplot in `folder` on commands given as an argument and a script there.
/// \throws PlotError  with what it complains of
void runGnuplot(const std::filesystem::path &folder, const std::string &commands,
                const std::string &script);

/// An SVG of gnuplot whose black becomes the colour of the text around it.
std::string withTextColour(std::string svg);

} // namespace plot
