// SPDX-License-Identifier: MIT
#include <nori/class_names.h>
#include <nori/color.h>
#include <nori/object.h>
#include <nori/parser.h>
#include <nori/proplist.h>
#include <nori/scene_text.h>
#include <nori/transform.h>

#include <Eigen/Geometry>
#include <pugixml.hpp>

#include <memory>
#include <set>

NORI_NAMESPACE_BEGIN

namespace {

/// Tags of objects and what an object under them must be.
const std::map<std::string, NoriObject::EClassType> kObjectTags = {
    {"scene", NoriObject::EScene},
    {"mesh", NoriObject::EMesh},
    {"bsdf", NoriObject::EBSDF},
    {"texture", NoriObject::ETexture},
    {"emitter", NoriObject::EEmitter},
    {"camera", NoriObject::ECamera},
    {"medium", NoriObject::EMedium},
    {"phase", NoriObject::EPhaseFunction},
    {"integrator", NoriObject::EIntegrator},
    {"sampler", NoriObject::ESampler},
    {"rfilter", NoriObject::EReconstructionFilter},
    {"test", NoriObject::ETest},
};

/// Tags of properties and how their `value` becomes one.
typedef void (*SetProperty)(PropertyList &list, const std::string &name, const std::string &value);
const std::map<std::string, SetProperty> kPropertyTags = {
    {"boolean",
     [](PropertyList &list, const std::string &name, const std::string &value) {
         list.setBoolean(name, toBool(value));
     }},
    {"integer",
     [](PropertyList &list, const std::string &name, const std::string &value) {
         list.setInteger(name, toInt(value));
     }},
    {"float",
     [](PropertyList &list, const std::string &name, const std::string &value) {
         list.setFloat(name, toFloat(value));
     }},
    {"string",
     [](PropertyList &list, const std::string &name, const std::string &value) {
         list.setString(name, value);
     }},
    {"point",
     [](PropertyList &list, const std::string &name, const std::string &value) {
         list.setPoint(name, Point3f(toVector3f(value)));
     }},
    {"vector",
     [](PropertyList &list, const std::string &name, const std::string &value) {
         list.setVector(name, Vector3f(toVector3f(value)));
     }},
    {"color",
     [](PropertyList &list, const std::string &name, const std::string &value) {
         list.setColor(name, Color3f(toVector3f(value).array()));
     }},
};

template <typename Table>
std::string keysOf(const Table &table) {
    std::vector<std::string> names;
    names.reserve(table.size());
    for (const auto &row : table)
        names.push_back(row.first);
    return joinNames(names);
}

/// Of elements within each other: far beyond any scene, far within the stack.
constexpr int kMaxDepth = 100;

class Parser {
public:
    explicit Parser(const std::string &fileName) : m_text(fileName) {
        const pugi::xml_parse_result result = m_document.load_buffer(
            m_text.bytes().data(), m_text.bytes().size(), pugi::parse_default, pugi::encoding_utf8);
        if (!result)
            throw NoriException("%s: %s", m_text.place(result.offset), result.description());
    }

    void apply(const SceneOverrides &overrides) {
        pugi::xml_node scene = m_document.document_element();
        pugi::xml_node camera = scene.child("camera");
        if (camera && overrides.size.x() > 0) {
            setInteger(camera, "width", overrides.size.x());
            setInteger(camera, "height", overrides.size.y());
        }
        pugi::xml_node integrator = scene.child("integrator");
        if (!overrides.integrator.empty()) {
            scene.remove_child(integrator); // with the properties of another class
            scene.prepend_child("integrator")
                .append_attribute("type")
                .set_value(overrides.integrator.c_str());
        }
    }

    NoriObject *parseRoot() {
        const pugi::xml_node root = m_document.document_element();
        if (!root)
            throw NoriException("%s: holds no element", m_text.name());
        for (pugi::xml_node node : m_document.children()) {
            if (node.type() == pugi::node_element && node != root)
                fail(node, "a second element at the top; a file holds one");
        }
        if (kObjectTags.find(root.name()) == kObjectTags.end())
            fail(root, "is no object; known: " + keysOf(kObjectTags));
        return parseObject(root, 0).release();
    }

private:
    typedef std::unique_ptr<NoriObject> ObjectPointer;

    static void setInteger(pugi::xml_node object, const char *name, int value) {
        pugi::xml_node property = object.find_child_by_attribute("integer", "name", name);
        if (!property) {
            property = object.append_child("integer");
            property.append_attribute("name").set_value(name);
        }
        property.remove_attribute("value");
        property.append_attribute("value").set_value(value);
    }

    /// `cbox.xml:31: <emitter type="area">: `
    std::string placeOf(pugi::xml_node node) const {
        const std::string type = node.attribute("type").value();
        const std::string name = node.attribute("name").value();
        std::string tag = "<" + std::string(node.name());
        if (!type.empty())
            tag += " type=\"" + type + "\"";
        else if (!name.empty())
            tag += " name=\"" + name + "\"";
        return m_text.place(node.offset_debug()) + ": " + tag + ">: ";
    }

    [[noreturn]] void fail(pugi::xml_node node, const std::string &message) const {
        throw NoriException("%s%s", placeOf(node), message);
    }

    std::string attribute(pugi::xml_node node, const char *name) const {
        const pugi::xml_attribute found = node.attribute(name);
        if (!found)
            fail(node, std::string("the attribute \"") + name + "\" is missing");
        return found.value();
    }

    /// Runs `action` and puts the element in front of what it throws.
    template <typename Action>
    auto within(pugi::xml_node node, const Action &action) const {
        try {
            return action();
        } catch (const std::exception &error) {
            throw NoriException("%s%s", placeOf(node), error.what());
        }
    }

    /// The elements in `node`, which may hold comments but no text.
    std::vector<pugi::xml_node> elementsOf(pugi::xml_node node) const {
        std::vector<pugi::xml_node> elements;
        for (pugi::xml_node child : node.children()) {
            if (child.type() == pugi::node_pcdata || child.type() == pugi::node_cdata)
                fail(node, "holds the text \"" + std::string(child.value()) + "\", not an element");
            if (child.type() == pugi::node_element)
                elements.push_back(child);
        }
        return elements;
    }

    void requireNothingIn(pugi::xml_node node) const {
        const std::vector<pugi::xml_node> elements = elementsOf(node);
        if (!elements.empty())
            fail(elements.front(),
                 "stands in a <" + std::string(node.name()) + ">, which holds no elements");
    }

    /// \param depth  number of elements around this one
    ObjectPointer parseObject(pugi::xml_node node, int depth) {
        if (depth > kMaxDepth)
            fail(node, "lies in more than " + std::to_string(kMaxDepth) + " elements");
        const NoriObject::EClassType kind = kObjectTags.at(node.name());
        PropertyList properties;
        std::set<std::string> names;
        std::vector<std::pair<pugi::xml_node, ObjectPointer>> children;
        for (pugi::xml_node child : elementsOf(node)) {
            const std::string tag = child.name();
            if (kObjectTags.find(tag) != kObjectTags.end()) {
                children.emplace_back(child, parseObject(child, depth + 1));
                continue;
            }
            parseProperty(child, properties);
            if (!names.insert(child.attribute("name").value()).second)
                fail(child, "the property is given twice");
        }

        ObjectPointer object = construct(node, kind, properties);
        for (auto &child : children) {
            within(child.first, [&] {
                NoriObject *raw = child.second.get();
                object->addChild(raw, child.first.attribute("name").value());
                (void)child.second.release(); // addChild() has taken it
                raw->setParent(object.get());
            });
        }
        within(node, [&] { object->activate(); });
        return object;
    }

    ObjectPointer construct(pugi::xml_node node, NoriObject::EClassType kind,
                            const PropertyList &properties) const {
        const std::string type = kind == NoriObject::EScene && !node.attribute("type")
                                     ? "scene"
                                     : attribute(node, "type");
        const std::vector<std::string> known = ClassNames::of(kind);
        ObjectPointer object;
        try {
            object.reset(NoriObjectFactory::createInstance(type, properties));
        } catch (const std::exception &error) {
            // A class that a submission registers may be of no kind we know of: ask the factory
            // first.
            const bool isKnown = std::find(known.begin(), known.end(), type) != known.end();
            if (!isKnown && endsWith(error.what(), "could not be found!"))
                fail(node, "unknown " + std::string(node.name()) + "; known: " + joinNames(known));
            fail(node, error.what());
        }
        if (object->getClassType() != kind)
            fail(node, "is of another kind (" + NoriObject::classTypeName(object->getClassType()) +
                           "); known: " + joinNames(known));
        const std::vector<std::string> unknown = properties.unqueried();
        if (!unknown.empty()) {
            const std::vector<std::string> meant = properties.queried();
            for (pugi::xml_node child : node.children()) {
                if (unknown.front() == child.attribute("name").value())
                    fail(child, "unknown property of " + std::string(node.name()) + " \"" + type +
                                    "\"; known: " + joinNames(meant));
            }
        }
        return object;
    }

    void parseProperty(pugi::xml_node node, PropertyList &properties) const {
        const std::string tag = node.name();
        if (tag == "transform") {
            const std::string name = attribute(node, "name");
            Transform transform;
            for (pugi::xml_node step : elementsOf(node)) {
                requireNothingIn(step);
                transform = within(step, [&] { return parseStep(step) * transform; });
            }
            properties.setTransform(name, transform);
            return;
        }
        const auto found = kPropertyTags.find(tag);
        if (found == kPropertyTags.end())
            fail(node, "unknown element; known: " + keysOf(kObjectTags) + ", " +
                           keysOf(kPropertyTags) + ", transform");
        requireNothingIn(node);
        const std::string name = attribute(node, "name");
        const std::string value = attribute(node, "value");
        within(node, [&] { found->second(properties, name, value); });
    }

    Transform parseStep(pugi::xml_node step) const {
        const std::string tag = step.name();
        const auto vector = [&](const char *name) {
            return Vector3f(toVector3f(get(step, name)));
        };
        Eigen::Affine3f result = Eigen::Affine3f::Identity();
        if (tag == "translate") {
            result = Eigen::Translation3f(vector("value"));
        } else if (tag == "scale") {
            result = Eigen::DiagonalMatrix<float, 3>(vector("value"));
        } else if (tag == "rotate") {
            // As in Nori 2 the axis is not normalised.
            result = Eigen::AngleAxisf(degToRad(toFloat(get(step, "angle"))), vector("axis"));
        } else if (tag == "lookat") {
            return lookAt(vector("origin"), vector("target"), vector("up"));
        } else if (tag == "matrix") {
            return matrix(get(step, "value"));
        } else {
            throw NoriException(
                "unknown transformation; known: lookat, matrix, rotate, scale, translate");
        }
        return Transform(result.matrix());
    }

    static std::string get(pugi::xml_node step, const char *name) {
        const pugi::xml_attribute found = step.attribute(name);
        if (!found)
            throw NoriException("the attribute \"%s\" is missing", name);
        return found.value();
    }

    static Transform matrix(const std::string &value) {
        const std::vector<std::string> tokens = tokenize(value);
        if (tokens.size() != 16)
            throw NoriException("a matrix has 16 numbers, not %d", static_cast<int>(tokens.size()));
        Eigen::Matrix4f result;
        for (int i = 0; i < 16; ++i)
            result(i / 4, i % 4) = toFloat(tokens[static_cast<size_t>(i)]);
        return Transform(result);
    }

    static Transform lookAt(const Vector3f &origin, const Vector3f &target, const Vector3f &up) {
        const Vector3f direction = (target - origin).normalized();
        const Vector3f left = up.normalized().cross(direction).normalized();
        const Vector3f newUp = direction.cross(left).normalized();
        if (!direction.allFinite() || !left.allFinite() || left.isZero())
            throw NoriException(
                "origin and target are the same point, or up points along the view");
        Eigen::Matrix4f result;
        result << left, newUp, direction, origin, 0, 0, 0, 1;
        return Transform(result);
    }

    SceneText m_text;
    pugi::xml_document m_document;
};

} // namespace

NoriObject *loadFromXML(const std::string &filename) {
    return loadFromXML(filename, SceneOverrides());
}

NoriObject *loadFromXML(const std::string &filename, const SceneOverrides &overrides) {
    Parser parser(filename);
    parser.apply(overrides);
    return parser.parseRoot();
}

NORI_NAMESPACE_END
