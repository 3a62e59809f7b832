// SPDX-License-Identifier: MIT
#pragma once

#include <battery/records.h>

#include <functional>
#include <span>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

namespace battery {

/// Thrown by a warp or density that is still a stub.
class NotImplemented : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// A function that is asked many things at once. Made from any callable for one element, or from
/// one that takes a span of them and returns a vector of the same shape.
template <typename In, typename Out>
class Batched {
public:
    /// Nothing that could be asked.
    Batched() = default;

    template <typename Callable>

    requires std::is_invocable_r_v<Out, Callable &, const In &> Batched(Callable each)
        : m_call([each = std::move(each)](std::span<const In> elements) {
              std::vector<Out> answers;
              answers.reserve(elements.size());
              for (const In &element : elements) {
                  answers.push_back(static_cast<Out>(each(element)));
              }
              return answers;
          }) {}

    template <typename Callable>

    requires std::is_invocable_r_v<std::vector<Out>, Callable &, std::span<const In>>
    Batched(Callable all) : m_call(std::move(all)) {}

    std::vector<Out> operator()(std::span<const In> elements) const { return m_call(elements); }

private:
    std::function<std::vector<Out>(std::span<const In>)> m_call;
};

/// Uniform numbers to points of the domain.
using Warp = Batched<Input, Output>;
/// Points to the density there, in the measure of the target (area or solid angle).
using Density = Batched<Output, float>;

} // namespace battery
