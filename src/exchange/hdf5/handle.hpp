#pragma once
// Handles of HDF5's objects, and its errors as exceptions.

#include <hdf5.h>
#include <string>
#include <utility>

namespace signorini::exchange {

/// Throws Error with the innermost reason that HDF5 gives.
[[noreturn]] void fail_in_hdf5();

/// The result of a function of HDF5, which is negative after errors.
template <class Result> Result checked(Result result) {
  if (result < 0) fail_in_hdf5();
  return result;
}

/// Closes an object of HDF5 when destroyed.
class Handle {
public:
  using Close = herr_t (*)(hid_t);

  Handle(hid_t id, Close close) : id_(checked(id)), close_(close) {}
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
  Handle& operator=(Handle&&) = delete;
  ~Handle() {
    if (id_ >= 0) close_(id_);
  }

  operator hid_t() const { return id_; }

private:
  hid_t id_;
  Close close_;
};

} // namespace signorini::exchange
