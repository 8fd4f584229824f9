#include "sensors_models/base/files.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>

#include <fcntl.h>
#include <fmt/ranges.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

#include "sensors_models/base/check.h"

namespace drydock {
namespace fs = std::filesystem;
namespace {

/// The pattern of a name beside `target` for mkstemp and mkdtemp, which make it unique.
std::string TemporaryPattern(const fs::path& target) {
  return (target.parent_path() / ("." + target.filename().string() + ".part-XXXXXX")).string();
}

/// Makes the missing folders above `path` and returns the uppermost of them; empty if there was
/// none to make.
fs::path MakeParent(const fs::path& path) {
  fs::path made;
  std::error_code error;
  for (fs::path folder = path.parent_path(); !folder.empty() && !fs::exists(folder, error);
       folder = folder.parent_path()) {
    made = folder;
  }
  error.clear();
  if (!path.parent_path().empty()) fs::create_directories(path.parent_path(), error);
  RequireInput(!error, "{}: cannot make the folder: {}", path.parent_path().string(),
               error.message());
  return made;
}

/// A new folder beside `target`, readable by everybody as an ordinary one.
fs::path MakeTemporaryFolder(const fs::path& target) {
  std::string name = TemporaryPattern(target);
  RequireInput(::mkdtemp(name.data()) != nullptr, "{}: cannot make a folder: {}",
               target.parent_path().string(), std::strerror(errno));
  fs::permissions(name,
                  fs::perms::group_read | fs::perms::group_exec | fs::perms::others_read |
                      fs::perms::others_exec,
                  fs::perm_options::add);
  return name;
}

/// A new empty file beside `target`.
fs::path MakeTemporaryFile(const fs::path& target) {
  std::string name = TemporaryPattern(target);
  const int descriptor = ::mkstemp(name.data());
  RequireInput(descriptor >= 0, "{}: cannot be written: {}", target.string(), std::strerror(errno));
  ::close(descriptor);
  fs::permissions(name, fs::perms::group_read | fs::perms::others_read, fs::perm_options::add);
  return name;
}

/// "a/b/" and "a/b" are the same folder; only the latter has a file name.
fs::path WithoutTrailingSlash(const fs::path& path) {
  const fs::path absolute = fs::absolute(path).lexically_normal();
  return absolute.has_filename() ? absolute : absolute.parent_path();
}

}  // namespace

std::string ReadFile(const fs::path& path, std::size_t max_bytes) {
  std::error_code error;
  const fs::file_type type = fs::status(path, error).type();
  RequireInput(type != fs::file_type::not_found, "{}: no such file", path.string());
  RequireInput(type == fs::file_type::regular, "{}: {}", path.string(),
               type == fs::file_type::directory ? "is a folder, must be a file"
               : error                          ? "cannot be read: " + error.message()
                                                : "is no ordinary file");
  const auto size = fs::file_size(path, error);
  RequireInput(!error && size <= max_bytes, "{}: larger than the {} bytes allowed", path.string(),
               max_bytes);
  std::ifstream stream(path, std::ios::binary);
  RequireInput(stream.is_open(), "{}: cannot be read: {}", path.string(), std::strerror(errno));
  std::string content(size, '\0');
  stream.read(content.data(), static_cast<std::streamsize>(size));
  RequireInput(stream.gcount() == static_cast<std::streamsize>(size), "{}: cannot be read",
               path.string());
  return content;
}

void WriteFileAtomically(const fs::path& path, std::string_view content) {
  MakeParent(path);
  const fs::path temporary = MakeTemporaryFile(path);
  std::ofstream stream(temporary, std::ios::binary);
  stream.write(content.data(), static_cast<std::streamsize>(content.size()));
  stream.close();
  std::error_code error;
  if (stream) fs::rename(temporary, path, error);
  if (!stream || error) {
    std::error_code ignored;
    fs::remove(temporary, ignored);
    RequireInput(false, "{}: cannot be written{}{}", path.string(), error ? ": " : "",
                 error ? error.message() : "");
  }
}

AtomicDirectory::AtomicDirectory(const fs::path& target) : target_(WithoutTrailingSlash(target)) {
  std::error_code ignored;
  RequireInput(!fs::exists(target_, ignored) || fs::is_directory(target_, ignored),
               "{}: is a file, must be a folder or free", target_.string());
  made_parent_ = MakeParent(target_);
  temporary_ = MakeTemporaryFolder(target_);
}

AtomicDirectory::~AtomicDirectory() {
  if (committed_) return;
  std::error_code error;
  fs::remove_all(temporary_, error);
  if (made_parent_.empty()) return;
  // Folders above that were made for this one go too, as far as nobody else uses them.
  for (fs::path folder = target_.parent_path();
       fs::remove(folder, error) && folder != made_parent_;)
    folder = folder.parent_path();
}

void RequireReplaceable(const fs::path& folder, const std::vector<std::string>& marks) {
  std::error_code error;
  if (!fs::is_directory(folder, error) || fs::is_empty(folder, error)) return;
  const bool ours = std::any_of(marks.begin(), marks.end(), [&](const std::string& mark) {
    return fs::exists(folder / mark, error);
  });
  RequireInput(ours, "{}: holds other things (no {}): remove it or name another folder",
               folder.string(), fmt::join(marks, ", no "));
}

void AtomicDirectory::Commit(IfExists if_exists) {
  Check(!committed_, "AtomicDirectory for {} is committed twice", target_.string());
  std::error_code error;
  fs::rename(temporary_, target_, error);
  if (error && fs::is_directory(target_)) {
    // Somebody else made the same folder meanwhile: theirs is complete too.
    if (if_exists == IfExists::kKeepTheirs) return;
    // Swap the two names in one step, so that there is no moment without the folder; what was there
    // before is then removed under the temporary name.
    error = {};
    if (::renameat2(AT_FDCWD, temporary_.c_str(), AT_FDCWD, target_.c_str(), RENAME_EXCHANGE) !=
        0) {
      error = std::error_code(errno, std::generic_category());
    } else {
      fs::remove_all(temporary_, error);
    }
  }
  RequireInput(!error, "{}: cannot be made: {}", target_.string(), error.message());
  committed_ = true;
}

}  // namespace drydock
