// Large arrays that start as zeros without being written: the system gives pages of zeros when they are first touched. For
// vectors that are sized once: one that shrinks and grows again keeps what was there.
#pragma once
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <new>
#include <utility>
#include <vector>

namespace nicol {

template <class T>
struct ZeroedAllocator {
  using value_type = T;
  ZeroedAllocator() = default;
  template <class U>
  ZeroedAllocator(const ZeroedAllocator<U>&) {}

  T* allocate(std::size_t count) {
    if (count > std::numeric_limits<std::size_t>::max() / sizeof(T)) throw std::bad_alloc();
    void* memory = std::calloc(count, sizeof(T));
    if (!memory && count > 0) throw std::bad_alloc();
    return static_cast<T*>(memory);
  }
  void deallocate(T* memory, std::size_t) { std::free(memory); }

  template <class U>
  void construct(U*) noexcept {}
  template <class U, class... Values>
  void construct(U* at, Values&&... values) {
    ::new (static_cast<void*>(at)) U(std::forward<Values>(values)...);
  }

  bool operator==(const ZeroedAllocator&) const { return true; }
  bool operator!=(const ZeroedAllocator&) const { return false; }
};

using ZeroedFloats = std::vector<float, ZeroedAllocator<float>>;

}  // namespace nicol
