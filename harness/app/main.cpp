// The only place that catches: errors become one message and an exit code (DESIGN 4).

#include "core/base/error.hpp"
#include "harness/app/command_line.hpp"

#include <cstdio>
#include <exception>
#include <new>

int main(int argc, char** argv) {
    try {
        return alcove::run_command_line(argc, argv);
    } catch (const alcove::Error& error) {
        std::fprintf(stderr, "alcove: %s\n", error.what());
        return error.exit_code();
    } catch (const std::bad_alloc&) {
        std::fprintf(stderr, "alcove: out of memory\n");
    } catch (const std::exception& error) {
        std::fprintf(stderr, "alcove: %s\n", error.what());
    }
    return 1;
}
