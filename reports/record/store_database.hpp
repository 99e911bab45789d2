#pragma once
// SQLite as the store needs it: prepared statements with bound parameters, transactions, and errors
// that name the file. For reports/record/store*.cpp alone.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

struct sqlite3;
struct sqlite3_stmt;

namespace alcove {

class Database {
  public:
    /// Opens or creates the file and its parent folder. Nothing is read yet. Throws FailureError if
    /// it cannot be opened.
    explicit Database(const std::filesystem::path& path);
    ~Database();
    Database(const Database&) = delete;
    Database& operator=(const Database&) = delete;

    /// Runs fixed SQL: one statement or several.
    void execute(const char* sql);
    /// The first column of the first row.
    [[nodiscard]] std::int64_t read_integer(const char* sql);
    [[nodiscard]] std::int64_t get_last_row() const;
    /// Throws InputError for what is wrong with the file (no database, damaged, a missing table),
    /// FailureError for what is wrong with the system (full disk, locked for 10 s).
    [[noreturn]] void throw_error() const;

    [[nodiscard]] const std::string& name() const noexcept { return m_name; }
    [[nodiscard]] sqlite3* handle() const noexcept { return m_handle; }

  private:
    std::string m_name;
    sqlite3* m_handle = nullptr;
};

/// One prepared statement. Parameters and columns count from 0.
class Statement {
  public:
    Statement(Database& database, const char* sql);
    ~Statement();
    Statement(const Statement&) = delete;
    Statement& operator=(const Statement&) = delete;

    Statement& bind(int parameter, std::string_view text);
    Statement& bind(int parameter, std::int64_t number);
    Statement& bind(int parameter, double number);
    /// None is NULL.
    Statement& bind(int parameter, const std::optional<double>& number);

    /// True: there is a row.
    [[nodiscard]] bool step();
    /// Runs a statement that gives no row, and makes it fit to be bound again.
    void run();
    /// Fit to be bound again.
    void reset();

    [[nodiscard]] std::string get_text(int column) const;
    [[nodiscard]] std::int64_t get_integer(int column) const;
    /// Throws InputError unless it is a finite number.
    [[nodiscard]] double get_number(int column) const;
    [[nodiscard]] std::optional<double> get_optional_number(int column) const;

  private:
    void check(int code) const;
    Database& m_database;
    sqlite3_stmt* m_handle = nullptr;
};

/// All or nothing: rolled back unless committed.
class Transaction {
  public:
    /// Takes the right to write at once, so that two writers wait for each other here.
    explicit Transaction(Database& database);
    ~Transaction();
    Transaction(const Transaction&) = delete;
    Transaction& operator=(const Transaction&) = delete;
    void commit();

  private:
    Database& m_database;
    bool m_is_open = true;
};

} // namespace alcove
