#pragma once

#include "Study.h"
#include "Table.h"

#include <string>
#include <vector>

namespace reproduce_papers
{

/// The folder that figures and report go into.
class Output
{
public:
    /// The folder is made when there is something to put into it.
    /// @param format  of figures: "png" or "svg"
    /// @throws demos::Failure (Exit::Usage) if something else is in its place
    Output(const std::string &folder, const std::string &format);

    /// @throws demos::Failure (Exit::Usage) if it can't be written
    void draw(const Figure &figure) const;
    void draw(const SeabedFigure &figure) const;

    /// Writes report.json and returns what it holds.
    /// @throws demos::Failure (Exit::Usage) if it can't be written
    nlohmann::ordered_json writeReport(const std::vector<Table> &tables, const nlohmann::ordered_json &claims) const;

    /// "reproduction/report.json and 12 figures".
    std::string summary() const;

private:
    void makeFolder() const;
    std::string pathOf(const std::string &figure) const;

    std::string folder_;
    std::string format_;
    mutable std::vector<std::string> figures_;
};

}  // namespace reproduce_papers
