// SPDX-License-Identifier: MIT
// Type-safe printf() under the names of the tinyformat library, which Nori's code calls. Any type
// with operator<< can be printed, whatever the conversion letter says.
#pragma once

#include <algorithm>
#include <cstdlib>
#include <iomanip>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <type_traits>

namespace tinyformat {
namespace detail {

/// One printf conversion such as "%-8.3f".
struct Conversion {
    bool left = false, plus = false, blank = false, zero = false, alternate = false;
    int width = 0;
    int precision = -1;
    char letter = 's';
};

/// The value as printf() would show it without padding; numbers keep their sign in front.
template <typename T>
std::string convert(const T &value, const Conversion &conversion) {
    std::ostringstream out;
    const char lower = conversion.letter | 0x20; // ASCII: capitals differ in this bit
    if (conversion.letter != lower)
        out << std::uppercase;
    if (lower == 'x')
        out << std::hex;
    if (lower == 'o')
        out << std::oct;
    if (lower == 'f')
        out << std::fixed;
    if (lower == 'e')
        out << std::scientific;
    if (lower == 's')
        out << std::boolalpha;
    if (conversion.alternate)
        out << std::showbase << std::showpoint;
    if (conversion.plus)
        out << std::showpos;
    if (conversion.precision >= 0)
        out << std::setprecision(conversion.precision);

    constexpr bool isCharacter = std::is_same<T, char>::value ||
                                 std::is_same<T, signed char>::value ||
                                 std::is_same<T, unsigned char>::value;
    if constexpr (isCharacter) {
        if (lower == 'd' || lower == 'i' || lower == 'u' || lower == 'x' || lower == 'o')
            out << static_cast<int>(value);
        else
            out << static_cast<char>(value);
    } else if constexpr (std::is_integral<T>::value && !std::is_same<T, bool>::value) {
        if (lower == 'c')
            out << static_cast<char>(value);
        else
            out << value;
    } else {
        out << value;
    }

    std::string text = out.str();
    if (lower == 's' && conversion.precision >= 0 && !std::is_arithmetic<T>::value)
        text.resize(std::min(text.size(), static_cast<size_t>(conversion.precision)));
    if (conversion.blank && std::is_arithmetic<T>::value && !text.empty() && text[0] != '-')
        text.insert(0, 1, ' ');
    return text;
}

inline std::string pad(std::string text, const Conversion &conversion) {
    const auto width = static_cast<size_t>(std::max(conversion.width, 0));
    if (text.size() >= width)
        return text;
    const size_t missing = width - text.size();
    if (conversion.left)
        return text.append(missing, ' ');
    if (!conversion.zero)
        return text.insert(0, missing, ' ');
    const bool hasSign = !text.empty() && (text[0] == '-' || text[0] == '+' || text[0] == ' ');
    return text.insert(hasSign ? 1 : 0, missing, '0');
}

/// One argument, its type forgotten.
class Argument {
public:
    template <typename T>
    explicit Argument(const T &value)
        : m_value(&value),
          m_show([](const void *p, const Conversion &conversion) {
              return pad(convert(*static_cast<const T *>(p), conversion), conversion);
          }),
          m_toInt([](const void *p) {
              if constexpr (std::is_integral<T>::value)
                  return static_cast<int>(*static_cast<const T *>(p));
              else
                  return static_cast<void>(p), 0;
          }) {}

    std::string show(const Conversion &conversion) const { return m_show(m_value, conversion); }

    int toInt() const { return m_toInt(m_value); }

private:
    const void *m_value;
    std::string (*m_show)(const void *, const Conversion &);
    int (*m_toInt)(const void *);
};

class Formatter {
public:
    Formatter(const char *fmt, const Argument *arguments, size_t count)
        : m_position(fmt), m_next(arguments), m_end(arguments + count) {}

    std::string run() {
        std::string result;
        while (*m_position != '\0') {
            if (*m_position != '%') {
                result += *m_position++;
            } else if (m_position[1] == '%') {
                result += '%';
                m_position += 2;
            } else {
                ++m_position;
                result += next();
            }
        }
        return result;
    }

private:
    std::string next() {
        Conversion conversion;
        for (;; ++m_position) {
            if (*m_position == '-')
                conversion.left = true;
            else if (*m_position == '+')
                conversion.plus = true;
            else if (*m_position == ' ')
                conversion.blank = true;
            else if (*m_position == '0')
                conversion.zero = true;
            else if (*m_position == '#')
                conversion.alternate = true;
            else
                break;
        }
        conversion.width = number(0);
        if (conversion.width < 0) {
            conversion.left = true;
            conversion.width = -conversion.width;
        }
        if (*m_position == '.') {
            ++m_position;
            conversion.precision = number(0);
        }
        while (*m_position != '\0' && std::string("hlLjzt").find(*m_position) != std::string::npos)
            ++m_position;
        if (*m_position != '\0')
            conversion.letter = *m_position++;
        // a message that lacks an argument is still worth more than an abort while reporting it
        return m_next == m_end ? "(missing)" : (m_next++)->show(conversion);
    }

    int number(int fallback) {
        if (*m_position == '*') {
            ++m_position;
            return m_next == m_end ? fallback : (m_next++)->toInt();
        }
        int result = fallback;
        for (; *m_position >= '0' && *m_position <= '9'; ++m_position)
            result = std::min(10 * result + (*m_position - '0'), 4096);
        return result;
    }

    const char *m_position;
    const Argument *m_next;
    const Argument *m_end;
};

} // namespace detail

/// The text that printf() would print.
template <typename... Args>
std::string format(const char *fmt, const Args &...args) {
    const detail::Argument arguments[] = {detail::Argument(args)..., detail::Argument(0)};
    return detail::Formatter(fmt, arguments, sizeof...(args)).run();
}

template <typename... Args>
void format(std::ostream &out, const char *fmt, const Args &...args) {
    out << format(fmt, args...);
}

template <typename... Args>
void printf(const char *fmt, const Args &...args) {
    format(std::cout, fmt, args...);
}

template <typename... Args>
void printfln(const char *fmt, const Args &...args) {
    format(std::cout, fmt, args...);
    std::cout << '\n';
}

} // namespace tinyformat

namespace tfm = tinyformat;
