// The compiled part of the package spiraling_edge.
#include "arrays.h"
#include "bindings.h"
#include "calls.h"

PYBIND11_MODULE(_core, module) {
    using namespace se::python;
    // They live as long as the process.
    static const py::handle inputError =
        py::exception<InputError>(module, "InputError", PyExc_ValueError).release();
    static const py::handle cancelled =
        py::exception<Cancelled>(module, "Cancelled", PyExc_RuntimeError).release();
    // Sentences name files, whose names need not be UTF-8.
    py::register_exception_translator([](std::exception_ptr thrown) {
        const auto raise = [](const py::handle& type, const std::exception& error) {
            PyErr_SetObject(type.ptr(), textOf(error.what()).ptr());
        };
        try {
            if (thrown) std::rethrow_exception(std::move(thrown));
        } catch (const InputError& error) {
            raise(inputError, error);
        } catch (const Cancelled& error) {
            raise(cancelled, error);
        } catch (const std::invalid_argument& error) {
            raise(PyExc_ValueError, error);
        }
    });
    module.attr("__version__") = SPIRALING_EDGE_VERSION;
    bindMeshes(module);
    bindStepping(module);
}
