// SPDX-License-Identifier: MIT
#include "catalogue.h"

#include <grader/diagnosis/catalogue_text.h>
#include <grader/error.h>
#include <grader/toml_text.h>

#include <fmt/core.h>

#include <algorithm>

namespace grader {

namespace {

/// `en = [sentence, hint, hint, hint]`
DiagnosisText readText(const toml::table &entry, const std::string &id, Language language) {
    const toml::array *lines = entry[languageCode(language)].as_array();
    if (lines == nullptr || lines->size() != 1 + kHintSteps)
        throw GraderError(fmt::format("diagnosis {}: {} has to be a sentence and {} hints", id,
                                      languageCode(language), kHintSteps));
    const auto line = [&](std::size_t i) {
        const auto text = lines->get(i)->value_exact<std::string>();
        if (!text || text->empty())
            throw GraderError(fmt::format("diagnosis {}: {} has an element that is no text", id,
                                          languageCode(language)));
        return *text;
    };
    DiagnosisText text{line(0), {}};
    for (std::size_t step = 0; step < kHintSteps; ++step)
        text.hints[step] = line(step + 1);
    return text;
}

std::vector<Diagnosis> readCatalogue() {
    // A TOML table sorts its keys; the files' own order is that of the lines.
    std::vector<Diagnosis> all;
    for (const char *text : kCatalogueTexts) {
        const toml::table document = parseToml(text, "the catalogue of diagnoses");
        std::vector<std::pair<toml::source_index, Diagnosis>> entries;
        for (const auto &[key, node] : document) {
            const std::string id(key.str());
            const toml::table *entry = node.as_table();
            if (entry == nullptr || entry->size() != kLanguages.size())
                throw GraderError(fmt::format("diagnosis {}: needs en and es, nothing else", id));
            Diagnosis diagnosis{id, {}};
            for (const Language language : kLanguages)
                diagnosis.texts[static_cast<std::size_t>(language)] =
                    readText(*entry, id, language);
            entries.emplace_back(node.source().begin.line, std::move(diagnosis));
        }
        std::sort(entries.begin(), entries.end(),
                  [](const auto &a, const auto &b) { return a.first < b.first; });
        for (auto &[line, diagnosis] : entries)
            all.push_back(std::move(diagnosis));
    }
    return all;
}

} // namespace

const char *languageCode(Language language) {
    return language == Language::Spanish ? "es" : "en";
}

const std::vector<Diagnosis> &diagnosisCatalogue() {
    static const std::vector<Diagnosis> catalogue = readCatalogue();
    return catalogue;
}

const Diagnosis *findDiagnosis(std::string_view id) {
    const std::vector<Diagnosis> &all = diagnosisCatalogue();
    const auto found = std::find_if(all.begin(), all.end(),
                                    [=](const Diagnosis &diagnosis) { return diagnosis.id == id; });
    return found == all.end() ? nullptr : &*found;
}

} // namespace grader
