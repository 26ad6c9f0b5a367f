// Table files.
//
// Little-endian. Bytes 0-7: magic; 8-11: version; 12-15: H, the bytes of the header; 16-23: P, the
// bytes of the payload; 24-55: SHA-256 of header and payload; then the header, a JSON object padded
// with spaces to a multiple of 8 bytes, which names quantity, samples, seed and arrays with their
// encoding and axes; then the payload: the arrays' numbers, one array after the other.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "tables/table.h"

namespace lacquer {

inline constexpr std::uint32_t kTableVersion = 1;

// The bytes of a file. The same table gives the same bytes on every machine.
std::string encode_table(const Table& table);

// Reads them back. Throws Error, naming `origin` and what is wrong with it, for bytes that are no
// table, end too soon, go on too long, are of another version, or do not have their checksum.
Table decode_table(std::string_view bytes, std::string_view origin);

Table read_table(const std::filesystem::path& file);

// The file appears whole or stays as it was.
void write_table(const std::filesystem::path& file, const Table& table);

}  // namespace lacquer
