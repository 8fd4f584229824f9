// Files that appear complete or not at all.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace drydock {

/// The whole file; InputError if it cannot be read or is larger than `max_bytes`.
std::string ReadFile(const std::filesystem::path& path,
                     std::size_t max_bytes = std::size_t{1} << 30);

/// Writes a temporary file beside `path` and renames it; makes missing parent folders. Throws
/// InputError if that fails, leaving nothing behind.
void WriteFileAtomically(const std::filesystem::path& path, std::string_view content);

/// InputError if `folder` is there, is not empty and holds none of the names in `marks`: for output
/// folders, which are replaced as a whole, so that a mistaken name destroys nothing.
void RequireReplaceable(const std::filesystem::path& folder, const std::vector<std::string>& marks);

/// A folder that is filled out of sight and appears under its name on Commit(). Without Commit()
/// the destructor removes what was written, with the folders above that were made for it.
class AtomicDirectory {
 public:
  /// What to do if `target` is there already when Commit() is called.
  enum class IfExists { kReplace, kKeepTheirs };

  /// `target`'s parent is made if missing; InputError if the folder cannot be made.
  explicit AtomicDirectory(const std::filesystem::path& target);
  ~AtomicDirectory();
  AtomicDirectory(const AtomicDirectory&) = delete;
  AtomicDirectory& operator=(const AtomicDirectory&) = delete;

  /// Where to write until Commit().
  const std::filesystem::path& path() const { return temporary_; }
  void Commit(IfExists if_exists);

 private:
  std::filesystem::path target_;
  std::filesystem::path temporary_;
  std::filesystem::path made_parent_;  ///< The uppermost folder that was made; empty if none was.
  bool committed_ = false;
};

}  // namespace drydock
