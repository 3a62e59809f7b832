// SPDX-License-Identifier: MIT
// The old TBB had this header, and code written for Nori may ask for it; oneTBB keeps it elsewhere.
#pragma once

#include <oneapi/tbb/mutex.h>
