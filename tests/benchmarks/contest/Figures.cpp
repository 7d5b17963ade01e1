#include "contest/Figures.h"

#include <nlohmann/json.hpp>

#include <fstream>
#include <iomanip>
#include <stdexcept>

namespace seahex::contest
{

std::map<std::string, double> readFigures(const std::string &file)
{
    std::ifstream in(file);
    if (!in)
        return {};
    try
    {
        return nlohmann::json::parse(in).get<std::map<std::string, double>>();
    }
    catch (const nlohmann::json::exception &error)
    {
        throw std::runtime_error(file + ": " + error.what());
    }
}

void writeFigures(const std::map<std::string, double> &figures, const std::string &file)
{
    std::ofstream out(file);
    out << std::setw(2) << nlohmann::json(figures) << '\n';
    if (!out.flush())
        throw std::runtime_error(file + " can't be written");
}

}  // namespace seahex::contest
