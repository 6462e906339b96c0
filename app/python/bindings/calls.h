/// Calls from Python: errors as exceptions, and long work without the lock of the interpreter.
#pragma once

#include <pybind11/pybind11.h>

#include <algorithm>
#include <chrono>
#include <exception>
#include <optional>
#include <stdexcept>
#include <thread>
#include <utility>

#include "spiraling_edge/base/result.h"
#include "spiraling_edge/stepper/state.h"

namespace se::python {

namespace py = pybind11;

/// A file, a scene or points that cannot be used: se.InputError.
struct InputError : std::runtime_error {
    using std::runtime_error::runtime_error;
};
/// The callback of `progress=` returned a false value: se.Cancelled.
struct Cancelled : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// The value of a result. Throws Exception with its sentence.
template <typename Exception, typename Value>
Value require(Result<Value> result) {
    if (!result) throw Exception(result.error().message);
    return std::move(result).value();
}

/// Keeps a thread that would take the lock while Python ends: Python would unwind it through code
/// that cannot throw, and abort the process.
inline void waitWherePythonEnds() {
#if PY_VERSION_HEX >= 0x030D0000
    while (Py_IsFinalizing())
#else
    while (_Py_IsFinalizing())
#endif
        std::this_thread::sleep_for(std::chrono::hours(1));
}

/// The lock of the interpreter, taken for code of Python.
struct Locked {
    struct Wait {
        Wait() { waitWherePythonEnds(); }
    } wait;
    py::gil_scoped_acquire lock;
};

/// Work without the lock of the interpreter, which is taken again after it.
struct Unlocked {
    py::gil_scoped_release free;
    struct Wait {
        ~Wait() { waitWherePythonEnds(); }
    } wait;
};

/// A call that runs code of Python on its way: the first exception, also of Ctrl+C, ends it.
class Call {
  public:
    /// `report`: a function of the share done, or None.
    explicit Call(py::object report = py::none()) : report_(std::move(report)) {}

    /// Called without the lock. False if the work has to end.
    bool goOn(double share) {
        const Locked locked;
        return attempt([&] {
            if (PyErr_CheckSignals() != 0) throw py::error_already_set();
            if (report_.is_none()) return true;
            const py::object answer = report_(share);
            if (!answer.is_none() && !py::bool_(answer)) throw Cancelled("Cancelled.");
            return true;
        });
    }
    /// The value of work(); false, with the exception kept, if that throws.
    template <typename Work>
    bool attempt(const Work& work) {
        try {
            return work();
        } catch (...) {
            if (!error_) error_ = std::current_exception();
            return false;
        }
    }
    bool isOver() const { return error_ != nullptr; }
    /// Throws what ended the work.
    void finish() {
        if (error_) std::rethrow_exception(std::exchange(error_, nullptr));
    }

  private:
    py::object report_;
    std::exception_ptr error_;
};

/// The value of work(progress), made without the lock. Throws what ended it.
template <typename Work>
auto longCall(const py::object& report, const Work& work) {
    Call call(report);
    const auto progress = [&call](double share) { return call.goOn(share); };
    std::optional<decltype(work(progress))> value;
    {
        const Unlocked unlocked;
        call.attempt([&] { return value.emplace(work(progress)), true; });
    }
    call.finish();
    return std::move(*value);
}

/// True if a run may go on: asked at every 256th pivot, with the share of the points that are DONE.
template <typename GoOn>
bool goOnAt(const State& state, const GoOn& goOn) {
    constexpr std::uint32_t kAskEvery = 256;
    if (state.counters.pivots % kAskEvery != 0) return true;
    const auto points = static_cast<double>(std::max<std::size_t>(1, state.status.size()));
    return goOn(static_cast<double>(state.done.size()) / points);
}

/// The thread that moves an object without the lock, if one does. Read and written under the lock.
class Turn {
  public:
    /// Throws if another thread is at work.
    void requireReadable() const {
        if (owner_ && *owner_ != std::this_thread::get_id())
            throw std::runtime_error("Another thread is at work with this run.");
    }
    /// The value of work(), which nothing else may disturb. Throws if something is at work.
    template <typename Work>
    auto take(const Work& work) {
        requireReadable();
        if (owner_) throw std::runtime_error("An observer or condition cannot move its own run.");
        struct Release {
            std::optional<std::thread::id>& owner;
            ~Release() { owner.reset(); }
        } const release{owner_};
        owner_ = std::this_thread::get_id();
        return work();
    }

  private:
    std::optional<std::thread::id> owner_;
};

}  // namespace se::python
