// Values to bytes and back, between processes of the same build.
#pragma once
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace nicol {

using Parcel = std::vector<char>;

class BytesOut {
 public:
  template <class T>
  BytesOut& put(const T& value) {
    static_assert(std::is_trivially_copyable_v<T>, "bytes of plain values only");
    return put_bytes(&value, sizeof value);
  }
  template <class T>
  BytesOut& put_all(const T& values) {
    put<std::uint64_t>(values.size());
    return put_bytes(values.data(), values.size() * sizeof(values[0]));
  }
  BytesOut& put_bytes(const void* from, std::size_t size) {
    const char* bytes = static_cast<const char*>(from);
    bytes_.insert(bytes_.end(), bytes, bytes + size);
    return *this;
  }
  Parcel take() { return std::move(bytes_); }

 private:
  Parcel bytes_;
};

class BytesIn {
 public:
  explicit BytesIn(const Parcel& bytes) : bytes_(bytes) {}
  template <class T>
  T get() {
    T value;
    std::memcpy(&value, next(sizeof value), sizeof value);
    return value;
  }
  template <class T>
  void get_all(T& values) {
    const auto size = static_cast<std::size_t>(get<std::uint64_t>());
    const char* from = next(size * sizeof(values[0]));
    values.resize(size);
    if (size > 0) std::memcpy(values.data(), from, size * sizeof(values[0]));
  }
  template <class T>
  T get_all() {
    T values;
    get_all(values);
    return values;
  }
  const char* next(std::size_t size) {
    if (size > bytes_.size() - at_) throw std::runtime_error("a message between ranks is cut short");
    const char* here = bytes_.data() + at_;
    at_ += size;
    return here;
  }

 private:
  const Parcel& bytes_;
  std::size_t at_ = 0;
};

}  // namespace nicol
