// SPDX-License-Identifier: MIT
#pragma once

#include <nori/object.h>

NORI_NAMESPACE_BEGIN

/// Builds what an XML scene file describes; the caller owns the root object.
///
/// Depth first, for each element: read its properties and fully build each child; construct the
/// object from its properties; in document order addChild(child) and child->setParent(object);
/// activate(). So an area emitter is activated before its mesh exists, the mesh after its emitter
/// was attached, and the scene last.
///
/// \throws NoriException  naming file and line
extern NoriObject *loadFromXML(const std::string &filename);

NORI_NAMESPACE_END
