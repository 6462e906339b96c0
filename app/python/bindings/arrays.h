/// Lists of the library as arrays of NumPy, and back.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <cstring>
#include <memory>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "spiraling_edge/base/types.h"

namespace se::python {

namespace py = pybind11;

/// The numbers that an element is made of.
template <typename Element>
using ScalarOf =
    std::conditional_t<std::is_same_v<Element, Vec3>, double,
                       std::conditional_t<std::is_same_v<Element, Triangle>, Index, Element>>;

/// A read-only array over the memory of a list, which `owner` keeps alive: rows of the numbers of
/// each element, or of one dimension where it is a number itself. Nothing is copied.
template <typename Element>
py::array viewOf(const std::vector<Element>& list, const std::shared_ptr<const void>& owner) {
    constexpr py::ssize_t kColumns = std::is_same_v<Element, ScalarOf<Element>> ? 1 : 3;
    std::vector<py::ssize_t> shape{static_cast<py::ssize_t>(list.size())};
    if (kColumns > 1) shape.push_back(kColumns);
    const py::capsule base(new std::shared_ptr<const void>(owner), [](void* held) {
        delete static_cast<std::shared_ptr<const void>*>(held);
    });
    const void* const memory = list.data();
    py::array array(py::dtype::of<ScalarOf<Element>>(), std::move(shape), memory, base);
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
using ArrayOf = py::array_t<ScalarOf<Element>, py::array::c_style | py::array::forcecast>;

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
/// A text, of which bytes that are not UTF-8 are written as "\xff".
inline py::str textOf(std::string_view text) {
    PyObject* const decoded = PyUnicode_DecodeUTF8(
        text.data(), static_cast<py::ssize_t>(text.size()), "backslashreplace");
    if (decoded == nullptr) throw py::error_already_set();
    return py::reinterpret_steal<py::str>(decoded);
}
/// The bytes of a path: text, bytes or an object with __fspath__. Throws ValueError if it has a
/// NUL, TypeError if it is none of these.
inline std::string pathOf(const py::object& path) {
    PyObject* bytes = nullptr;
    if (PyUnicode_FSConverter(path.ptr(), &bytes) == 0) throw py::error_already_set();
    return py::reinterpret_steal<py::bytes>(bytes);
}

}  // namespace se::python
