#pragma once
// Errors are part of the interface: what they name and what a process would end with.

#include "core/base/error.hpp"

#include <initializer_list>
#include <string>

#include <gtest/gtest.h>

namespace alcove {

/// `action` throws an Error with this exit code whose message holds every part.
template <class Action>
void expect_error(Action&& action, int exit_code, std::initializer_list<const char*> parts) {
    try {
        action();
        ADD_FAILURE() << "no error";
    } catch (const Error& error) {
        EXPECT_EQ(error.exit_code(), exit_code) << error.what();
        for (const char* part : parts) {
            EXPECT_NE(std::string(error.what()).find(part), std::string::npos)
                << "`" << part << "` is missing in: " << error.what();
        }
    }
}

} // namespace alcove
