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

/// What stands in for parts of a scene's file, as if it said so itself.
struct SceneOverrides {
    Vector2i size{0, 0};    ///< of the camera's image [pixels]; 0: the file's
    std::string integrator; ///< type; empty: the file's, with its properties
};

/// As loadFromXML() above.
extern NoriObject *loadFromXML(const std::string &filename, const SceneOverrides &overrides);

NORI_NAMESPACE_END
