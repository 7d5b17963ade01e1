#pragma once

#include <filesystem>
#include <string>

namespace demos
{

/// A name beside a file that no other process has, to write it under until it is whole.
std::filesystem::path partName(const std::filesystem::path &file);

/// Writes a file that others see whole or not at all.
/// @throws Failure (Exit::Usage) if it can't be written
void writeWhole(const std::filesystem::path &file, const std::string &text);

/// The same, but what is there already stays.
void writeWholeIfAbsent(const std::filesystem::path &file, const std::string &text);

/// @throws Failure (Exit::Usage) if it can't be read
std::string readWhole(const std::filesystem::path &file);

}  // namespace demos
