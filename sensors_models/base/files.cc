#include "sensors_models/base/files.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>

#include <fcntl.h>
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

void MakeParent(const fs::path& path) {
  std::error_code error;
  if (!path.parent_path().empty()) fs::create_directories(path.parent_path(), error);
  RequireInput(!error, "{}: cannot make the folder: {}", path.parent_path().string(),
               error.message());
}

}  // namespace

std::string ReadFile(const fs::path& path, std::size_t max_bytes) {
  std::error_code error;
  RequireInput(fs::is_regular_file(path, error), "{}: no such file", path.string());
  const auto size = fs::file_size(path, error);
  RequireInput(!error && size <= max_bytes, "{}: larger than the {} bytes allowed", path.string(),
               max_bytes);
  std::ifstream stream(path, std::ios::binary);
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
  MakeParent(target_);
  temporary_ = MakeTemporaryFolder(target_);
}

AtomicDirectory::~AtomicDirectory() {
  std::error_code ignored;
  if (!committed_) fs::remove_all(temporary_, ignored);
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
