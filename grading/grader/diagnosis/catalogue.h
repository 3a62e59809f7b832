// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace grader {

/// What students read is in both.
enum class Language { English, Spanish };

constexpr std::array<Language, 2> kLanguages = {Language::English, Language::Spanish};

/// `en`, `es`: as in the `lang` attribute, and on the command line.
const char *languageCode(Language language);

/// Steps of a hint ladder, from a nudge to almost the answer.
constexpr std::size_t kHintSteps = 3;

/// A mistake as it is told in one language.
struct DiagnosisText {
    std::string sentence;
    std::array<std::string, kHintSteps> hints;
};

/// A known mistake; its id is stable: it stands in results and in the exam's hand-ins.
struct Diagnosis {
    std::string id; ///< `disk.missing_sqrt`
    std::array<DiagnosisText, kLanguages.size()> texts;

    const DiagnosisText &in(Language language) const {
        return texts[static_cast<std::size_t>(language)];
    }
};

/// All of them, in the order of the files in grading/grader/diagnosis.
/// \throws GraderError  if a file is not as it must be (tested)
const std::vector<Diagnosis> &diagnosisCatalogue();

/// \return  nullptr if there is none
const Diagnosis *findDiagnosis(std::string_view id);

} // namespace grader
