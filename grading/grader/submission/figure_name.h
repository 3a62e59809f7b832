// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace grader {

/// What the name of a figure says: `SCENE_SPP`.
struct FigureName {
    std::string scene;   ///< in lower case, its words joined by `_`; may be empty
    int samples = 0;     ///< per pixel; 0: the name does not say
    bool asAsked = true; ///< false: the words or the number are joined in another way
};

/// \param stem  of the file, without folder and extension: `serapis_ems_64`, `Serapis-EMS 64spp`
FigureName parseFigureName(std::string_view stem);

} // namespace grader
