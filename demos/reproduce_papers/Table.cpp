#include "Table.h"

#include <algorithm>
#include <cstdio>

namespace reproduce_papers
{
namespace
{

std::string numberOf(const std::optional<double> &value, int decimals)
{
    if (!value)
        return "-";
    char text[64];
    std::snprintf(text, sizeof text, "%.*f", decimals, *value);
    return text;
}

std::string textOf(const Table &table, const Table::Row &row, std::size_t column)
{
    const bool isOwn = column < table.decimals.size() && table.decimals[column];
    return numberOf(row.values[column], isOwn ? *table.decimals[column] : row.decimals);
}

std::string padded(const std::string &text, std::size_t width, bool toTheLeft)
{
    const std::string space(width > text.size() ? width - text.size() : 0, ' ');
    return toTheLeft ? text + space : space + text;
}

/// The words of a heading under each other, so that columns stay narrow; '_' is a blank that parts nothing.
std::vector<std::string> wordsOf(const std::string &heading)
{
    std::vector<std::string> words(1);
    for (const char c : heading)
        if (c == ' ')
            words.emplace_back();
        else
            words.back() += c == '_' ? ' ' : c;
    return words;
}

}  // namespace

std::string toText(const Table &table)
{
    std::vector<std::vector<std::string>> headings;
    std::size_t lines = 0;
    for (const std::string &column : table.columns)
    {
        headings.push_back(wordsOf(column));
        lines = std::max(lines, headings.back().size());
    }
    std::size_t nameWidth = 0;
    for (const Table::Row &row : table.rows)
        nameWidth = std::max(nameWidth, row.name.size());
    std::vector<std::size_t> widths;
    for (std::size_t i = 0; i < headings.size(); ++i)
    {
        std::size_t width = 0;
        for (const std::string &word : headings[i])
            width = std::max(width, word.size());
        for (const Table::Row &row : table.rows)
            width = std::max(width, textOf(table, row, i).size());
        widths.push_back(width);
    }

    std::string text = table.title + "\n";
    for (std::size_t line = 0; line < lines; ++line)
    {
        text += "  " + std::string(nameWidth, ' ');
        for (std::size_t i = 0; i < headings.size(); ++i)
        {
            const std::size_t skipped = lines - headings[i].size();
            text += "  " + padded(line < skipped ? "" : headings[i][line - skipped], widths[i], false);
        }
        text += "\n";
    }
    for (const Table::Row &row : table.rows)
    {
        text += "  " + padded(row.name, nameWidth, true);
        for (std::size_t i = 0; i < row.values.size(); ++i)
            text += "  " + padded(textOf(table, row, i), widths[i], false);
        text += "\n";
    }
    std::string note = table.note;
    for (std::size_t at = 0; (at = note.find('\n', at)) != std::string::npos; at += 3)
        note.replace(at, 1, "\n  ");
    return text + (note.empty() ? "" : "  " + note + "\n");
}

nlohmann::ordered_json toJson(const Table &table)
{
    nlohmann::ordered_json rows = nlohmann::ordered_json::array();
    for (const Table::Row &row : table.rows)
    {
        nlohmann::ordered_json values = nlohmann::ordered_json::object();
        for (std::size_t i = 0; i < table.columns.size(); ++i)
            values[table.columns[i]] =
                row.values[i] ? nlohmann::ordered_json(*row.values[i]) : nlohmann::ordered_json(nullptr);
        rows.push_back({{"name", row.name}, {"values", values}});
    }
    return {{"id", table.id}, {"title", table.title}, {"rows", rows}, {"note", table.note}};
}

}  // namespace reproduce_papers
