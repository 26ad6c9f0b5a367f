// Windows calls that fail become exceptions.
#pragma once

#include <windows.h>

#include <cstdio>
#include <stdexcept>
#include <string>

// Throws naming `what` where `result` tells of a failure.
inline void check(HRESULT result, const char* what) {
    if (SUCCEEDED(result)) return;
    char number[16];
    std::snprintf(number, sizeof(number), "0x%08lx", static_cast<unsigned long>(result));
    throw std::runtime_error{std::string{what} + ": " + number};
}
