// What hostile text may use up: living bytes of strings and elements of arrays are charged and given back.
#pragma once
#include <cstddef>

namespace nicol::sdl {

// Thrown where a limit is met; the parse ends with its message.
struct LimitReached {
  const char* message;
};

class Budget {
 public:
  explicit Budget(std::size_t limit) : limit_(limit) {}
  void charge(std::size_t amount) {
    if (amount > limit_ || used_ > limit_ - amount) throw LimitReached{"Out of memory."};
    used_ += amount;
  }
  void release(std::size_t amount) { used_ -= amount; }

 private:
  std::size_t limit_, used_ = 0;
};

class Charge {
 public:
  Charge(Budget& budget, std::size_t amount) : budget_(budget), amount_(amount) {
    budget_.charge(amount_);
  }
  ~Charge() { budget_.release(amount_); }
  Charge(const Charge&) = delete;
  Charge& operator=(const Charge&) = delete;

 private:
  Budget& budget_;
  std::size_t amount_;
};

}  // namespace nicol::sdl
