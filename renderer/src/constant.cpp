// SPDX-License-Identifier: MIT
#include <nori/texture.h>

NORI_NAMESPACE_BEGIN

NORI_REGISTER_CLASS(ConstantSpectrumTexture, "constant")

NORI_NAMESPACE_END
