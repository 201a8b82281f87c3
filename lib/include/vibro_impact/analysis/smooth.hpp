/// \file
/// A value that exists only where a motion is smooth: its derivative, and what follows from it.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>

namespace vibro_impact {

/// A value, or the reason why it does not exist. Reading a value that does not exist throws
/// std::domain_error with the reason.
template <class T>
class Smooth {
 public:
  Smooth() : why_not_("not computed") {
  }
  Smooth(T value) : value_(std::move(value)) {
  }
  static Smooth none(std::string why_not) {
    Smooth nothing;
    nothing.why_not_ = std::move(why_not);
    return nothing;
  }

  bool exists() const {
    return why_not_.empty();
  }
  /// One line; empty if the value exists.
  const std::string &why_not() const {
    return why_not_;
  }
  const T &value() const & {
    if (!exists()) throw std::domain_error(why_not_);
    return value_;
  }
  T value() && {
    return T(std::as_const(*this).value());
  }
  const T &operator*() const & {
    return value();
  }
  T operator*() && {
    return T(std::as_const(*this).value());
  }
  const T *operator->() const {
    return &value();
  }

  /// The elements, if T is a container.
  auto begin() const {
    return value().begin();
  }
  auto end() const {
    return value().end();
  }
  auto size() const {
    return value().size();
  }
  bool empty() const {
    return value().empty();
  }
  const auto &front() const {
    return value().front();
  }
  const auto &operator[](std::size_t k) const {
    return value()[k];
  }

 private:
  T value_ = {};
  std::string why_not_ = {};
};

}  // namespace vibro_impact
