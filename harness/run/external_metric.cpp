#include "harness/run/external_metric.hpp"

#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "harness/run/piped_process.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <unistd.h>

#include <nlohmann/json.hpp>

namespace alcove {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::string_view kPrefix = "exec:";
constexpr std::size_t kLongestName = 64;
/// Of what a program wrote, in an error.
constexpr std::size_t kLongestQuote = 300;

/// A folder of this process alone, gone at the end of the scope.
class PrivateFolder {
  public:
    PrivateFolder() : m_path((fs::temp_directory_path() / "alcove-exec-XXXXXX").string()) {
        if (::mkdtemp(m_path.data()) == nullptr) {
            throw FailureError(m_path, "cannot be made", std::strerror(errno));
        }
    }
    ~PrivateFolder() {
        std::error_code error;
        fs::remove_all(m_path, error);
    }
    PrivateFolder(const PrivateFolder&) = delete;
    PrivateFolder& operator=(const PrivateFolder&) = delete;
    [[nodiscard]] fs::path path() const { return m_path; }

  private:
    std::string m_path;
};

bool can_be_executed(const fs::path& path) {
    std::error_code error;
    return fs::is_regular_file(path, error) && ::access(path.c_str(), X_OK) == 0;
}

fs::path find_program(const std::string& name, std::string_view where) {
    if (name.find('/') != std::string::npos) {
        if (!can_be_executed(name)) {
            throw InputError(where, "not a program that can be executed", name, "exec:PROGRAM ...");
        }
        return name;
    }
    const char* path = std::getenv("PATH");
    for (const std::string& folder : split(path == nullptr ? "" : path, ':')) {
        if (!folder.empty() && can_be_executed(fs::path(folder) / name)) {
            return fs::path(folder) / name;
        }
    }
    throw InputError(where, "no such program along PATH", name, "./" + name + " for one in here");
}

/// Fit for one line of an error: printable ASCII, its end or its beginning.
std::string quote(std::string text, bool keeps_end) {
    std::replace_if(
        text.begin(), text.end(), [](char c) { return c < 0x20 || c > 0x7e; }, ' ');
    text.erase(text.find_last_not_of(' ') + 1);
    if (text.size() > kLongestQuote) {
        text = keeps_end ? "..." + text.substr(text.size() - kLongestQuote)
                         : text.substr(0, kLongestQuote) + "...";
    }
    return text;
}

bool is_name(std::string_view name) {
    const auto is_plain = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
               c == '_' || c == '.' || c == '-';
    };
    return !name.empty() && name.size() <= kLongestName &&
           std::all_of(name.begin(), name.end(), is_plain);
}

std::vector<ExternalValue> read_answer(const std::string& answer, const std::string& who) {
    const Json object = Json::parse(answer, nullptr, false);
    if (!object.is_object() || object.empty()) {
        throw FailureError(who, "its standard output is no JSON object", quote(answer, false),
                           "{\"name\": number, ...}");
    }
    std::vector<ExternalValue> values;
    for (const auto& [name, value] : object.items()) {
        if (!is_name(name)) {
            throw FailureError(who, "a key cannot be a metric's name", quote(name, false),
                               "1 to 64 of letters, digits, _ . -");
        }
        if (!value.is_number() && !value.is_null()) {
            throw FailureError(who, "the value of `" + name + "` is no number", value.type_name(),
                               "a number, or null for no value");
        }
        values.push_back(
            {name, value.is_null() ? std::nullopt : std::optional(value.get<double>())});
    }
    return values;
}

} // namespace

bool is_external_metric(std::string_view spec) {
    return spec.starts_with(kPrefix);
}

ExternalMetric parse_external_metric(std::string_view spec, std::string_view where) {
    std::vector<std::string> words = split(spec.substr(kPrefix.size()), ' ');
    std::erase(words, "");
    if (words.empty()) {
        throw InputError(where, "names no program", spec, "exec:PROGRAM ...");
    }
    ExternalMetric metric{std::string(spec), find_program(words.front(), where), {}};
    metric.arguments.assign(words.begin() + 1, words.end());
    return metric;
}

std::vector<ExternalValue> run_external_metric(const ExternalMetric& metric, const fs::path& test,
                                               const fs::path& reference,
                                               std::chrono::milliseconds time) {
    std::vector<std::string> arguments = metric.arguments;
    arguments.push_back(fs::absolute(test).string());
    arguments.push_back(fs::absolute(reference).string());
    const PrivateFolder folder;
    PipedProcess process(metric.program, arguments, folder.path() / "log", ProcessGroup::own);
    const std::string answer = process.run_to_end({time, kLongestAnswer, kLongestComplaint});
    const ProcessEnd end = process.finish();
    const std::string complaint = quote(process.read_log(), true);
    if (end.signal != 0) {
        throw FailureError(metric.text, "was ended by signal " + std::to_string(end.signal),
                           complaint);
    }
    if (end.exit_code != 0) {
        throw FailureError(metric.text, "exit code " + std::to_string(end.exit_code), complaint,
                           complaint.empty() ? "0; it said nothing on standard error" : "0");
    }
    return read_answer(answer, metric.text);
}

} // namespace alcove
