// Changes text token by token: numbers, words, whole { } blocks. Bytes changed at random hardly ever
// get past a parser.
#pragma once
#include <random>
#include <string>
#include <vector>

namespace nicol::fuzz {

using Random = std::minstd_rand;

// `text` with one to four changes; `other` lends blocks, `words` lend words.
std::string mutated(const std::string& text, const std::string& other, const std::vector<std::string>& words,
                    Random& random);

// What libFuzzer's hooks LLVMFuzzerCustomMutator and LLVMFuzzerCustomCrossOver do in both fuzzers.
std::size_t mutate_input(std::uint8_t* data, std::size_t size, std::size_t most, unsigned seed,
                         const std::vector<std::string>& words);
std::size_t cross_over(const std::uint8_t* one, std::size_t one_size, const std::uint8_t* two, std::size_t two_size,
                       std::uint8_t* out, std::size_t most, unsigned seed, const std::vector<std::string>& words);

}  // namespace nicol::fuzz
