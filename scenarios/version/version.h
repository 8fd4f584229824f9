// Which Drydock this is.
#pragma once

#include <string_view>

namespace drydock {

inline constexpr std::string_view kVersion = "0.1.0";

/// The commit that this was built from, with "-dirty" where the tree differed; "unknown" outside a
/// checkout.
std::string_view Commit();

}  // namespace drydock
