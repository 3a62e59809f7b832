// SPDX-License-Identifier: MIT
#pragma once

#include <nori/render.h>

#include <map>
#include <string>

/// \throws nori::NoriException  if writeImage() could not make its files: to be asked before hours
/// of rendering
void requireWritable(const std::string &stem);

/// Writes `stem`.exr and `stem`.png, each below a temporary name first, so that nothing half
/// written ever has the final one.
///
/// \param header  attributes of the .exr, as text
/// \throws nori::NoriException  if a file cannot be written, on a full disk for one
void writeImage(const nori::RenderResult &result, const std::string &stem,
                const std::map<std::string, std::string> &header);
