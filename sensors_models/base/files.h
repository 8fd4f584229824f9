// Files that appear complete or not at all.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace drydock {

/// The whole file; InputError if it cannot be read or is larger than `max_bytes`.
std::string ReadFile(const std::filesystem::path& path,
                     std::size_t max_bytes = std::size_t{1} << 30);

/// Writes a temporary file beside `path` and renames it; makes missing parent folders. Throws
/// InputError if that fails, leaving nothing behind.
void WriteFileAtomically(const std::filesystem::path& path, std::string_view content);

/// A folder that is filled out of sight and appears under its name on Commit(). Without Commit()
/// the destructor removes what was written.
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
  bool committed_ = false;
};

}  // namespace drydock
