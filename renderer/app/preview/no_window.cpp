// SPDX-License-Identifier: MIT
#include <preview/show.h>

namespace preview {

bool canShow() {
    return false;
}

void show(ViewModel &, const WindowOptions &) {
    throw CannotShow(
        "this nori was built without windows (NORI_GUI=OFF). Without --window it works "
        "in the terminal alone");
}

} // namespace preview
