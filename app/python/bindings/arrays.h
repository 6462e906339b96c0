/// Lists of the library as arrays of NumPy, and back.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <cstring>
#include <memory>
#include <string_view>
#include <utility>
#include <vector>

#include "spiraling_edge/base/types.h"

namespace se::python {

namespace py = pybind11;

/// The scalar of an element and the number of its columns; 0: the array has one dimension.
template <typename Element>
struct Columns {
    using Scalar = Element;
    static constexpr py::ssize_t kCount = 0;
};
template <>
struct Columns<Vec3> {
    using Scalar = double;
    static constexpr py::ssize_t kCount = 3;
};
template <>
struct Columns<Triangle> {
    using Scalar = Index;
    static constexpr py::ssize_t kCount = 3;
};
static_assert(sizeof(Vec3) == 3 * sizeof(double) && sizeof(Triangle) == 3 * sizeof(Index));

/// A read-only array over the memory of a list, which `owner` keeps alive. Nothing is copied.
template <typename Element>
py::array viewOf(const std::vector<Element>& list, const std::shared_ptr<const void>& owner) {
    using Scalar = typename Columns<Element>::Scalar;
    std::vector<py::ssize_t> shape{static_cast<py::ssize_t>(list.size())};
    if constexpr (Columns<Element>::kCount > 0) shape.push_back(Columns<Element>::kCount);
    const py::capsule base(new std::shared_ptr<const void>(owner), [](void* held) {
        delete static_cast<std::shared_ptr<const void>*>(held);
    });
    const void* const memory = list.data();
    py::array array(py::dtype::of<Scalar>(), std::move(shape), memory, base);
    array.attr("setflags")(py::arg("write") = false);
    return array;
}

/// A list as an array that owns it.
template <typename Element>
py::array arrayOf(std::vector<Element> list) {
    const auto owner = std::make_shared<const std::vector<Element>>(std::move(list));
    return viewOf(*owner, owner);
}

/// An argument of rows of three numbers, or of single ones; converted where it is another array.
template <typename Element>
using ArrayOf =
    py::array_t<typename Columns<Element>::Scalar, py::array::c_style | py::array::forcecast>;

/// The elements of an array. Requires one of that shape.
template <typename Element>
std::vector<Element> listOf(const ArrayOf<Element>& array) {
    const auto bytes = static_cast<std::size_t>(array.nbytes());
    std::vector<Element> list(bytes / sizeof(Element));
    if (bytes > 0) std::memcpy(static_cast<void*>(list.data()), array.data(), bytes);
    return list;
}

/// A point, or None for kNone.
inline py::object indexOrNone(Index p) { return p == kNone ? py::none() : py::object(py::int_(p)); }
inline py::str textOf(std::string_view text) { return {text.data(), text.size()}; }

}  // namespace se::python
