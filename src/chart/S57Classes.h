#pragma once

#include <string>

namespace seahex
{

/// True for every object class of S-57's catalogue (edition 3.1), those that the hazard catalogue judges and those that
/// it does not. Upper case, as S-57 writes them.
bool isS57Class(const std::string &acronym);

/// Why a class that is not in the hazard catalogue is not used: "meta object", "collection of objects", ...
std::string whyNotJudged(const std::string &acronym);

/// The layer's name in upper case, where that is an S-57 class; empty otherwise.
std::string s57ClassOf(const std::string &layerName);

}  // namespace seahex
