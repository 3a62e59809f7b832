// SPDX-License-Identifier: MIT
#include "guess.h"

#include <algorithm>
#include <cmath>

namespace grader {

std::vector<Guess> bestGuesses(const std::vector<Guess> &guesses) {
    std::vector<Guess> best;
    for (const Guess &guess : guesses) {
        const auto known = std::find_if(best.begin(), best.end(),
                                        [&](const Guess &other) { return other.id == guess.id; });
        if (known == best.end())
            best.push_back(guess);
        else
            known->fit = std::max(known->fit, guess.fit);
    }
    std::stable_sort(best.begin(), best.end(), [](const Guess &a, const Guess &b) {
        return std::lround(10 * a.fit) > std::lround(10 * b.fit);
    });
    best.resize(std::min(best.size(), kMostGuesses));
    return best;
}

} // namespace grader
