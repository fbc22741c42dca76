// Compiled kernels on disk. A file that is damaged, cut short or of another identity is as good as none.
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace nicol {

using Bytes = std::vector<unsigned char>;

// 64-bit FNV-1a (Fowler, Noll, Vo 1991), as 16 hexadecimal digits.
std::string hash_text(std::string_view text);

// Identity: all that the binary depends on, as text; it names the file and is kept and compared inside.
std::optional<Bytes> load_binary(const std::string& folder, const std::string& identity);

// Written under a temporary name, then renamed. False if the folder cannot be written.
bool save_binary(const std::string& folder, const std::string& identity, const Bytes& binary);

// The file of an identity.
std::string binary_path(const std::string& folder, const std::string& identity);

}  // namespace nicol
