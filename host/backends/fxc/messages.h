// Messages on standard input and output, as in host/backends/webgpu/messages.mjs: a 32-bit
// little-endian length, as many bytes of JSON, and the bytes that the JSON announces.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <vector>

using Bytes = std::vector<std::byte>;

// Makes standard input and output carry bytes instead of lines.
void use_binary_streams();

// The next request; nothing where the input has ended.
std::optional<nlohmann::json> read_request();

Bytes read_bytes(std::size_t size);

void write_answer(const nlohmann::json& answer, std::span<const std::byte> bytes = {});
