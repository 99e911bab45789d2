#include "tests/harness/temporary_folder.hpp"

#include "core/base/file.hpp"

#include <array>
#include <cstdlib>
#include <stdexcept>

namespace alcove {

namespace fs = std::filesystem;

TemporaryFolder::TemporaryFolder() {
    std::string pattern = (fs::temp_directory_path() / "alcove-test-XXXXXX").string();
    if (::mkdtemp(pattern.data()) == nullptr) {
        throw std::runtime_error("no temporary folder " + pattern);
    }
    m_path = pattern;
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored;
    fs::remove_all(m_path, ignored);
}

fs::path TemporaryFolder::write(const std::string& name, const std::string& bytes) const {
    write_file_atomically(m_path / name, bytes);
    return m_path / name;
}

ScopedVariable::ScopedVariable(std::string name, const std::string& value)
    : m_name(std::move(name)) {
    if (const char* previous = std::getenv(m_name.c_str()); previous != nullptr) {
        m_previous = previous;
        m_was_set = true;
    }
    ::setenv(m_name.c_str(), value.c_str(), 1);
}

ScopedVariable::~ScopedVariable() {
    if (m_was_set) {
        ::setenv(m_name.c_str(), m_previous.c_str(), 1);
    } else {
        ::unsetenv(m_name.c_str());
    }
}

} // namespace alcove
