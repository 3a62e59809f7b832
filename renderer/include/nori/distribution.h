// SPDX-License-Identifier: MIT
#pragma once

#include <nori/common.h>

NORI_NAMESPACE_BEGIN

// Nori 2 declares these two and defines neither, so nothing can use them. The names are kept for
// files that include this header.
struct Distribution1D;
struct Distribution2D;

NORI_NAMESPACE_END
