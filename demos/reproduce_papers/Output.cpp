#include "Output.h"

#include "common/Failure.h"
#include "common/WholeFile.h"

#include <filesystem>

namespace reproduce_papers
{

namespace fs = std::filesystem;

namespace
{

template <class Write>
void orFail(const Write &write)
{
    try
    {
        write();
    }
    catch (const seahex::PictureError &error)
    {
        throw demos::Failure(demos::Exit::Usage, error.what());
    }
}

}  // namespace

Output::Output(const std::string &folder, const std::string &format) : folder_(folder), format_(format)
{
    std::error_code ignored;
    if (fs::exists(folder_, ignored) && !fs::is_directory(folder_, ignored))
        throw demos::Failure(demos::Exit::Usage, "--out: " + folder_ + " is there and is no folder");
}

void Output::makeFolder() const
{
    std::error_code error;
    fs::create_directories(folder_, error);
    if (error)
        throw demos::Failure(demos::Exit::Usage, "--out: the folder " + folder_ + " can't be made: " + error.message());
}

std::string Output::pathOf(const std::string &figure) const
{
    return (fs::path(folder_) / (figure + "." + format_)).string();
}

void Output::draw(const Figure &figure) const
{
    makeFolder();
    orFail([&] { seahex::writePicture(pathOf(figure.name), figure.content); });
    figures_.push_back(pathOf(figure.name));
}

void Output::draw(const SeabedFigure &figure) const
{
    makeFolder();
    orFail([&] { seahex::writeSeabedPicture(pathOf(figure.name), figure.content); });
    figures_.push_back(pathOf(figure.name));
}

nlohmann::ordered_json Output::writeReport(const std::vector<Table> &tables, const nlohmann::ordered_json &claims) const
{
    makeFolder();
    nlohmann::ordered_json report = {{"status", "success"}, {"exit", 0}, {"tables", nlohmann::ordered_json::array()}};
    for (const Table &table : tables)
        report["tables"].push_back(toJson(table));
    report["claims"] = claims;
    report["figures"] = figures_;
    demos::writeWhole(fs::path(folder_) / "report.json", report.dump(2) + "\n");
    return report;
}

std::string Output::summary() const
{
    return (fs::path(folder_) / "report.json").string() + " and " + std::to_string(figures_.size()) + " figures";
}

}  // namespace reproduce_papers
