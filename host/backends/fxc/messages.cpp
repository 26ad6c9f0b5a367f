#include "messages.h"

#include <fcntl.h>
#include <io.h>

#include <cstdint>
#include <cstdio>
#include <stdexcept>
#include <string>

void use_binary_streams() {
    _setmode(_fileno(stdin), _O_BINARY);
    _setmode(_fileno(stdout), _O_BINARY);
}

std::optional<nlohmann::json> read_request() {
    std::uint32_t size = 0;
    if (std::fread(&size, sizeof(size), 1, stdin) != 1) return std::nullopt;
    const Bytes text = read_bytes(size);
    const char* begin = reinterpret_cast<const char*>(text.data());
    return nlohmann::json::parse(begin, begin + text.size());
}

Bytes read_bytes(std::size_t size) {
    Bytes bytes(size);
    if (std::fread(bytes.data(), 1, size, stdin) != size)
        throw std::runtime_error{"the input ended within a request"};
    return bytes;
}

void write_answer(const nlohmann::json& answer, std::span<const std::byte> bytes) {
    const std::string text = answer.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
    const auto size = static_cast<std::uint32_t>(text.size());
    std::fwrite(&size, sizeof(size), 1, stdout);
    std::fwrite(text.data(), 1, text.size(), stdout);
    std::fwrite(bytes.data(), 1, bytes.size(), stdout);
    std::fflush(stdout);
}
