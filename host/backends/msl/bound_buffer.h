// A buffer's address in the guise of whichever reference the kernel's parameter is.
#pragma once

struct BoundBuffer {
    void* address;

    template <typename T>
    operator T&() const {
        return *static_cast<T*>(address);
    }
};
