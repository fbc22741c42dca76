// File: magic, length of the identity, identity, length of the binary, binary, checksum of all before.
#include "host/opencl/binary_cache.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "host/opencl/cache_folder.hpp"

namespace nicol {
namespace {

constexpr std::string_view magic = "nicol kernel 1\n";

std::uint64_t fnv1a(std::string_view text) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (unsigned char c : text) hash = (hash ^ c) * 0x100000001b3u;
  return hash;
}

void put_number(std::string& out, std::uint64_t number) {
  out.append(reinterpret_cast<const char*>(&number), sizeof number);
}

// Takes `size` bytes off the front of `rest`; false if there are fewer.
bool take(std::string_view& rest, std::uint64_t size, std::string_view& part) {
  if (size > rest.size()) return false;
  part = rest.substr(0, size);
  rest.remove_prefix(size);
  return true;
}

bool take_number(std::string_view& rest, std::uint64_t& number) {
  std::string_view part;
  if (!take(rest, sizeof number, part)) return false;
  std::memcpy(&number, part.data(), sizeof number);
  return true;
}

bool take_sized(std::string_view& rest, std::string_view& part) {
  std::uint64_t size = 0;
  return take_number(rest, size) && take(rest, size, part);
}

}  // namespace

std::string hash_text(std::string_view text) { return fmt::format("{:016x}", fnv1a(text)); }

std::string binary_path(const std::string& folder, const std::string& identity) {
  return folder + "/" + hash_text(identity) + ".kernel";
}

std::optional<Bytes> load_binary(const std::string& folder, const std::string& identity) {
  std::ifstream in(binary_path(folder, identity), std::ios::binary);
  if (!in) return std::nullopt;
  const std::string content{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  std::string_view rest = content, head, kept_identity, binary;
  std::uint64_t checksum = 0;
  const bool whole = take(rest, magic.size(), head) && head == magic && take_sized(rest, kept_identity) &&
                     take_sized(rest, binary) && take_number(rest, checksum) && rest.empty();
  if (!whole || kept_identity != identity) return std::nullopt;
  if (checksum != fnv1a(std::string_view(content).substr(0, content.size() - sizeof checksum))) return std::nullopt;
  return Bytes(binary.begin(), binary.end());
}

bool save_binary(const std::string& folder, const std::string& identity, const Bytes& binary) {
  if (folder.empty() || !is_writable_folder(folder)) return false;
  std::string content{magic};
  put_number(content, identity.size());
  content += identity;
  put_number(content, binary.size());
  content.append(binary.begin(), binary.end());
  put_number(content, fnv1a(content));
  const std::string path = binary_path(folder, identity);
  const std::string temporary = fmt::format("{}.{}", path, ::getpid());
  {
    std::ofstream out(temporary, std::ios::binary);
    out.write(content.data(), static_cast<std::streamsize>(content.size()));
    out.close();
    if (!out) {
      std::remove(temporary.c_str());
      return false;
    }
  }
  std::error_code failed;
  std::filesystem::rename(temporary, path, failed);
  if (failed) std::remove(temporary.c_str());
  return !failed;
}

}  // namespace nicol
