/// Results of operations that can fail: no exceptions cross the borders of core.
#pragma once

#include <cassert>
#include <string>
#include <utility>
#include <variant>

namespace se {

/// A message for the user: the place (file, line or byte), what was expected, what to do.
struct Error {
    std::string message;
};

/// A value, or the reason why there is none.
template <typename T>
class Result {
  public:
    // Implicit on purpose: `return value;` and `return Error{...};` both read as they should.
    Result(T value) : content_(std::move(value)) {}      // NOLINT(google-explicit-constructor)
    Result(Error error) : content_(std::move(error)) {}  // NOLINT(google-explicit-constructor)

    bool ok() const { return std::holds_alternative<T>(content_); }
    explicit operator bool() const { return ok(); }

    /// Requires ok(). Of a temporary, the value itself, so that nothing refers to it afterwards.
    T& value() & {
        assert(ok());
        return *std::get_if<T>(&content_);
    }
    const T& value() const& {
        assert(ok());
        return *std::get_if<T>(&content_);
    }
    T value() && {
        assert(ok());
        return std::move(*std::get_if<T>(&content_));
    }
    /// Requires !ok().
    const Error& error() const {
        assert(!ok());
        return *std::get_if<Error>(&content_);
    }

  private:
    std::variant<T, Error> content_;
};

/// Success, or the reason of failure.
using Status = Result<std::monostate>;

inline Status success() { return std::monostate{}; }

}  // namespace se
