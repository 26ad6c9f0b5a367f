# Writes the C++ source that makes a generated Metal kernel callable by name.
# Usage: cmake -D METAL=FILE -D NAME=plain_eval -D OUTPUT=FILE -P wrap_kernel.cmake
file(READ ${METAL} text)

# The entry point's parameters by what they are bound to: buffer(0), ..., thread_position_in_grid.
string(REGEX MATCH "kernel void main0\\([^{]*" entry_point "${text}")
string(REPLACE "[[" "@" entry_point "${entry_point}")  # brackets would break the list
string(REGEX MATCHALL "@[a-z_]+(\\([0-9]+\\))?" attributes "${entry_point}")
if(NOT attributes)
    message(FATAL_ERROR "${METAL}: no entry point 'kernel void main0(...)' with bound parameters")
endif()

set(arguments)
foreach(attribute IN LISTS attributes)
    if(attribute MATCHES "buffer\\(([0-9]+)\\)")
        list(APPEND arguments "BoundBuffer{buffers[${CMAKE_MATCH_1}]}")
    elseif(attribute MATCHES "thread_position_in_grid")
        list(APPEND arguments "metal::uint3(thread, 0u, 0u)")
    else()
        message(FATAL_ERROR "${METAL}: the entry point takes ${attribute}, which nothing gives it")
    endif()
endforeach()
list(JOIN arguments ", " arguments)

configure_file(${CMAKE_CURRENT_LIST_DIR}/kernel.cpp.in ${OUTPUT} @ONLY)
