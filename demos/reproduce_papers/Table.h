#pragma once

#include <nlohmann/json.hpp>

#include <optional>
#include <string>
#include <vector>

namespace reproduce_papers
{

/// Numbers under headings, one quantity a row: for people as text, for programs as JSON.
struct Table
{
    struct Row
    {
        std::string name;
        std::vector<std::optional<double>> values;  ///< one a column; empty where nothing is known
        int decimals = 0;
    };

    std::string id;                            ///< for programs
    std::string title;                         ///< one line
    std::vector<std::string> columns;          ///< words stand under each other unless joined by '_'
    std::vector<std::optional<int>> decimals;  ///< of columns that have their own, whatever the row
    std::vector<Row> rows;
    std::string note;  ///< below; lines parted by '\n'
};

std::string toText(const Table &table);
nlohmann::ordered_json toJson(const Table &table);

}  // namespace reproduce_papers
