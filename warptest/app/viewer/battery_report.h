// SPDX-License-Identifier: MIT
#pragma once

#include <viewer/report.h>

namespace viewer {

/// battery::testWarp() of a subject at the settings' parameter. Without maps.
TestReport runBattery(const Subject &subject, const Settings &settings, const TestControl &control);

} // namespace viewer
