// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <string>
#include <utility>

namespace support {

/// The parts of JSON Schema that our schema uses.
class SchemaChecker {
public:
    /// \param name  of a schema, below the project's folder
    static SchemaChecker ofFile(const std::string &name) {
        std::ifstream file(std::string(NORI_SOURCE_DIR) + "/" + name);
        return SchemaChecker(nlohmann::json::parse(file));
    }

    explicit SchemaChecker(nlohmann::json schema) : m_schema(std::move(schema)) {}

    /// What is wrong with `value`, empty if nothing is.
    std::string check(const nlohmann::json &value) const { return check(value, m_schema, "$"); }

private:
    std::string check(const nlohmann::json &value, const nlohmann::json &rule,
                      const std::string &place) const {
        if (rule.contains("$ref")) {
            const std::string reference = rule["$ref"];
            return check(value, m_schema.at(nlohmann::json::json_pointer(reference.substr(1))),
                         place);
        }
        if (rule.contains("const") && value != rule["const"])
            return place + ": is not the constant";
        if (rule.contains("enum") &&
            std::find(rule["enum"].begin(), rule["enum"].end(), value) == rule["enum"].end())
            return place + ": is not one of the known values";
        if (rule.contains("type") && !hasType(value, rule["type"]))
            return place + ": has the wrong type";
        if (!value.is_object())
            return checkElements(value, rule, place);
        for (const auto &key : rule.value("required", nlohmann::json::array())) {
            if (!value.contains(key))
                return place + ": lacks " + std::string(key);
        }
        return checkMembers(value, rule, place);
    }

    std::string checkMembers(const nlohmann::json &value, const nlohmann::json &rule,
                             const std::string &place) const {
        for (const auto &[key, member] : value.items()) {
            const nlohmann::json properties = rule.value("properties", nlohmann::json::object());
            const nlohmann::json others = rule.value("additionalProperties", nlohmann::json(true));
            std::string wrong;
            if (properties.contains(key))
                wrong = check(member, properties[key], place + "." + key);
            else if (others == false)
                wrong = place + ": has an unknown member " + key;
            else if (others.is_object())
                wrong = check(member, others, place + "." + key);
            if (!wrong.empty())
                return wrong;
        }
        return {};
    }

    std::string checkElements(const nlohmann::json &value, const nlohmann::json &rule,
                              const std::string &place) const {
        if (!value.is_array())
            return {};
        if (value.size() < rule.value("minItems", std::size_t{0}) ||
            value.size() > rule.value("maxItems", value.size()))
            return place + ": has the wrong number of elements";
        if (!rule.contains("items"))
            return {};
        for (std::size_t i = 0; i < value.size(); ++i) {
            const std::string wrong =
                check(value[i], rule["items"], place + "[" + std::to_string(i) + "]");
            if (!wrong.empty())
                return wrong;
        }
        return {};
    }

    static bool hasType(const nlohmann::json &value, const nlohmann::json &type) {
        if (type.is_array())
            return std::any_of(type.begin(), type.end(),
                               [&](const nlohmann::json &one) { return hasType(value, one); });
        const std::string name = type;
        return (name == "object" && value.is_object()) || (name == "array" && value.is_array()) ||
               (name == "string" && value.is_string()) || (name == "number" && value.is_number()) ||
               (name == "boolean" && value.is_boolean()) ||
               (name == "integer" && value.is_number_integer()) ||
               (name == "null" && value.is_null());
    }

    nlohmann::json m_schema;
};

} // namespace support
