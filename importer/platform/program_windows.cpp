// SPDX-License-Identifier: MIT
#include <fcntl.h>
#include <io.h>
#include <windows.h>

#include <shellapi.h>

#include <array>
#include <cstdio>
#include <memory>
#include <string_view>

#include "importer/platform/program.h"

namespace sinew::platform {
namespace {

std::string utf8(std::wstring_view text) {
  const int length = static_cast<int>(text.size());
  const int bytes = ::WideCharToMultiByte(CP_UTF8, 0, text.data(), length, nullptr, 0, nullptr, nullptr);
  std::string out(static_cast<std::size_t>(bytes), '\0');
  ::WideCharToMultiByte(CP_UTF8, 0, text.data(), length, out.data(), bytes, nullptr, nullptr);
  return out;
}

std::wstring wide(std::string_view text) {
  const int bytes = static_cast<int>(text.size());
  const int length = ::MultiByteToWideChar(CP_UTF8, 0, text.data(), bytes, nullptr, 0);
  std::wstring out(static_cast<std::size_t>(length), L'\0');
  ::MultiByteToWideChar(CP_UTF8, 0, text.data(), bytes, out.data(), length);
  return out;
}

std::wstring wide_variable(const wchar_t* name) {
  std::wstring out(::GetEnvironmentVariableW(name, nullptr, 0), L'\0');  // room for the zero at the end, too
  out.resize(::GetEnvironmentVariableW(name, out.data(), static_cast<DWORD>(out.size())));
  return out;
}

HANDLE handle_of(int descriptor) noexcept { return reinterpret_cast<HANDLE>(::_get_osfhandle(descriptor)); }

/// A word of a command line as CommandLineToArgvW() reads it: backslashes before a quotation mark count twice.
std::wstring as_word(std::wstring_view word) {
  std::wstring out = L"\"";
  std::size_t backslashes = 0;
  for (const wchar_t c : word) {
    if (c == L'"') out.append(backslashes + 1, L'\\');
    backslashes = c == L'\\' ? backslashes + 1 : 0;
    out += c;
  }
  out.append(backslashes, L'\\');
  return out + L'"';
}

struct CloseHandle {
  void operator()(HANDLE handle) const noexcept { ::CloseHandle(handle); }
};
using Handle = std::unique_ptr<void, CloseHandle>;

std::string read_to_end(HANDLE from) {
  std::string text;
  std::array<char, 4096> part;
  for (DWORD count = 0; ::ReadFile(from, part.data(), static_cast<DWORD>(part.size()), &count, nullptr) && count > 0;)
    text.append(part.data(), count);
  return text;
}

}  // namespace

void prepare_standard_streams() {
  for (const int descriptor : {kStandardInput, kStandardOutput, kStandardError}) ::_setmode(descriptor, _O_BINARY);
  ::SetConsoleOutputCP(CP_UTF8);
  DWORD mode = 0;
  const HANDLE messages = handle_of(kStandardError);
  if (::GetConsoleMode(messages, &mode)) ::SetConsoleMode(messages, mode | ENABLE_VIRTUAL_TERMINAL_PROCESSING);
}

std::vector<std::string> arguments_of(int argc, const char* const* argv) {
  int count = 0;
  const std::unique_ptr<wchar_t*, decltype(&::LocalFree)> words(::CommandLineToArgvW(::GetCommandLineW(), &count),
                                                                &::LocalFree);
  if (words == nullptr) return {argv, argv + argc};
  std::vector<std::string> out;
  for (int i = 0; i < count; ++i) out.push_back(utf8(words.get()[i]));
  return out;
}

std::string environment_variable(const char* name) { return utf8(wide_variable(wide(name).c_str())); }

bool is_terminal(int descriptor) noexcept {
  DWORD mode = 0;
  return ::GetConsoleMode(handle_of(descriptor), &mode) && (mode & ENABLE_VIRTUAL_TERMINAL_PROCESSING) != 0;
}

std::uint64_t process_number() noexcept { return ::GetCurrentProcessId(); }

std::filesystem::path user_cache_folder() { return wide_variable(L"LOCALAPPDATA"); }

std::filesystem::path program_folder() {
  std::wstring path(MAX_PATH, L'\0');
  for (;;) {
    const DWORD length = ::GetModuleFileNameW(nullptr, path.data(), static_cast<DWORD>(path.size()));
    if (length == 0) return {};
    if (length < path.size()) return std::filesystem::path(path.substr(0, length)).parent_path();
    path.resize(2 * path.size());
  }
}

std::string program_file(const std::string& name) { return name + ".exe"; }

tl::expected<EndedProgram, std::string> run_program(const std::filesystem::path& program,
                                                    const std::vector<std::string>& arguments, bool with_messages) {
  SECURITY_ATTRIBUTES inherited{sizeof(SECURITY_ATTRIBUTES), nullptr, TRUE};
  HANDLE ends[2];
  if (!::CreatePipe(&ends[0], &ends[1], &inherited, 0)) return tl::unexpected(std::string("no pipe can be made"));
  const Handle from(ends[0]);
  Handle to(ends[1]);
  ::SetHandleInformation(from.get(), HANDLE_FLAG_INHERIT, 0);
  const Handle nothing(::CreateFileW(L"NUL", GENERIC_READ | GENERIC_WRITE, FILE_SHARE_READ | FILE_SHARE_WRITE,
                                     &inherited, OPEN_EXISTING, 0, nullptr));
  std::wstring line = as_word(program.wstring());
  for (const std::string& word : arguments) line += L' ' + as_word(wide(word));
  STARTUPINFOW start{};
  start.cb = sizeof start;
  start.dwFlags = STARTF_USESTDHANDLES;
  start.hStdInput = nothing.get();
  start.hStdOutput = to.get();
  start.hStdError = with_messages ? to.get() : nothing.get();
  PROCESS_INFORMATION started{};
  if (!::CreateProcessW(program.c_str(), line.data(), nullptr, nullptr, TRUE, 0, nullptr, nullptr, &start, &started))
    return tl::unexpected(program.string() + " cannot be started");
  const Handle process(started.hProcess), thread(started.hThread);
  to.reset();
  std::string text = read_to_end(from.get());
  ::WaitForSingleObject(process.get(), INFINITE);
  DWORD status = 0;
  ::GetExitCodeProcess(process.get(), &status);
  return EndedProgram{static_cast<int>(status), std::move(text)};
}

std::string processor_name() {
  const std::wstring name = wide_variable(L"PROCESSOR_IDENTIFIER");
  return name.empty() ? "unknown" : utf8(name);
}

std::string system_name() { return "Windows"; }

std::string load_average() { return "unknown"; }

}  // namespace sinew::platform
