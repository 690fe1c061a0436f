// SPDX-License-Identifier: MIT
#include "importer/file/foreign_file.h"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <iterator>
#include <string_view>

#include "importer/issue_log.h"

namespace sinew {
namespace {

using namespace std::string_view_literals;

constexpr std::string_view kUnpack = "unpack it and import the .gltf or .glb inside";
constexpr std::string_view kExport = "export the model as glTF 2.0 from the program that made it, or convert it";
constexpr std::string_view kBlender = "open it in Blender and export glTF 2.0 (.glb)";
constexpr std::string_view kViaBlender = "convert it: Blender imports it and exports glTF 2.0 (.glb)";
constexpr std::string_view kImport = "`sinew import IN OUT.glb` makes a .glb of it";
constexpr std::string_view kPicture = "import the .gltf or .glb that uses it";
constexpr std::string_view kTables = "`sinew info` shows it; import the .gltf or .glb that it was made from";
constexpr std::string_view kTile = "import the .glb that it wraps";

/// A kind of file, recognised by fixed bytes at a fixed place.
struct FileSign {
  std::size_t at;
  std::string_view bytes;
  std::string_view kind, advice;
};
constexpr FileSign kFileSigns[] = {
    {0, "\x1f\x8b"sv, "gzip data", "unpack it (gunzip) and import what is inside"},
    {0, "\x28\xb5\x2f\xfd"sv, "Zstandard data, as of a compressed .blend", "unpack it (zstd -d) first"},
    {0,
     "\xfd"
     "7zXZ\0"sv,
     "xz data", "unpack it (unxz) and import what is inside"},
    {0, "BZh"sv, "bzip2 data", "unpack it (bunzip2) and import what is inside"},
    {0, "7z\xbc\xaf\x27\x1c"sv, "a 7z archive", kUnpack},
    {0, "Rar!\x1a"sv, "a RAR archive", kUnpack},
    {257, "ustar"sv, "a tar archive", kUnpack},
    {0, "SINEWAST"sv, "an asset file of sinew (.sinew)", kTables},
    {0, "SINEWCLP"sv, "a file of compiled clips of sinew (.sinew)", kTables},
    {0, "SINEWGEO"sv, "a geometry cache of sinew (.sgeo)", "it is shown beside a model; import the .gltf or .glb"},
    {0, "Kaydara FBX Binary"sv, "FBX", kImport},
    {0, "; FBX "sv, "FBX (as text)", kImport},
    {0, "BLENDER"sv, "a Blender file (.blend)", kBlender},
    {0, "#usda"sv, "USD (as text)", kViaBlender},
    {0, "PXR-USDC"sv, "USD", kViaBlender},
    {0, "ply\n"sv, "a PLY model", kViaBlender},
    {0, "ply\r\n"sv, "a PLY model", kViaBlender},
    {0, "solid "sv, "an STL model", kViaBlender},
    {0, "HIERARCHY"sv, "BVH motion", kImport},
    {0, "Ogawa"sv, "an Alembic cache", kViaBlender},
    {0, "MD5Version"sv, "an MD5 model or animation", kExport},
    {0, "PMX "sv, "an MMD model", kExport},
    {0, "Pmd"sv, "an MMD model", kExport},
    {0, "Vocaloid Motion Data"sv, "MMD motion", kExport},
    {0, "//Maya ASCII"sv, "a Maya scene", kExport},
    {0, "#VRML"sv, "a VRML model", kExport},
    {0, "xof 0"sv, "a DirectX model (.x)", kExport},
    {0, "\xd0\xcf\x11\xe0"sv, "a file of 3ds Max or of an office program", kExport},
    {0, "DRACO"sv, "a bare Draco mesh (.drc)", "import the .gltf or .glb that it belongs to"},
    {0, "b3dm"sv, "a tile of 3D Tiles", kTile},
    {0, "i3dm"sv, "a tile of 3D Tiles", kTile},
    {0, "\x89PNG"sv, "a PNG image", kPicture},
    {0, "\xff\xd8\xff"sv, "a JPEG image", kPicture},
    {0, "\xabKTX"sv, "a KTX texture", kPicture},
    {0, "RIFF"sv, "a RIFF file, such as a WebP image", kPicture},
    {0, "%PDF"sv, "a PDF document", kExport},
    {0, "\x93NUMPY"sv, "a NumPy array", "import the .gltf or .glb; `sinew verify` reads arrays of poses beside it"},
    {0, "Z2xURgIAAA"sv, "a .glb as base64 text", "decode it (base64 -d) first"},
    {0, "data:"sv, "a data URI", "decode what follows the comma (base64 -d) first"},
    {0, "[InternetShortcut]"sv, "a shortcut to a web page", "download the file that it names"},
};

constexpr std::string_view kLfs = "a Git LFS pointer, which stands for the file; fetch the file (git lfs pull)";
constexpr std::string_view kAnnex = "a git-annex pointer, which stands for the file; fetch the file (git annex get)";
constexpr std::string_view kWebPage = "a web page (HTML), as servers send in place of a file; download the file again";

std::string_view as_text(std::span<const std::byte> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

bool is_blank(char c) noexcept { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

std::string_view skip_blanks(std::string_view text) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  const auto first = std::find_if_not(text.begin(), text.end(), is_blank);
  return text.substr(static_cast<std::size_t>(first - text.begin()));
}

bool starts_with_any_case(std::string_view text, std::string_view lower) {
  return text.size() >= lower.size() && std::equal(lower.begin(), lower.end(), text.begin(), [](char a, char b) {
           return a == static_cast<char>(std::tolower(static_cast<unsigned char>(b)));
         });
}

std::optional<std::string_view> stand_in(std::string_view bytes) {
  const std::string_view text = skip_blanks(bytes);
  if (text.starts_with("version https://git-lfs.github.com/spec/")) return kLfs;
  if (text.starts_with("/annex/objects/") || text.starts_with("../.git/annex/") || text.starts_with(".git/annex/"))
    return kAnnex;
  if (starts_with_any_case(text, "<!doctype html") || starts_with_any_case(text, "<html")) return kWebPage;
  return std::nullopt;
}

/// Describes a ZIP archive by the name of its first entry. Bytes 26 to 30 have the length of that name.
std::string describe_zip(std::string_view file) {
  const auto name = file.substr(std::min<std::size_t>(file.size(), 30), 200);
  if (name.find(".usdc") < 100 || name.find(".usda") < 100) return std::string("a USDZ model; ").append(kViaBlender);
  if (name.find(".npy") < 100)
    return "NumPy arrays (.npz); import the .gltf or .glb, `sinew verify` reads poses beside it";
  return std::string("a ZIP archive; ").append(kUnpack);
}

std::string_view describe_xml(std::string_view text) {
  const std::string_view head = text.substr(0, 4096);
  if (head.find("<COLLADA") != head.npos) return "COLLADA (.dae); `sinew import IN OUT.glb` makes a .glb of it";
  if (starts_with_any_case(text, "<?xml") && head.find("<html") != head.npos) return kWebPage;
  if (head.find("<X3D") != head.npos) return "an X3D model; convert it to glTF 2.0";
  return "XML, as servers send in place of a file; see what it says, and download the file again";
}

/// UTF-16 and UTF-32, with a byte order mark or by the zero bytes around the first characters.
std::optional<std::string> wide_text(std::string_view bytes) {
  constexpr std::string_view kSave = "; save it as UTF-8";
  if (bytes.starts_with("\xff\xfe\0\0"sv) || bytes.starts_with("\0\0\xfe\xff"sv) || bytes.starts_with("{\0\0\0"sv) ||
      bytes.starts_with("\0\0\0{"sv))
    return std::string("text in UTF-32").append(kSave);
  if (bytes.starts_with("\xff\xfe") || bytes.starts_with("\xfe\xff") || bytes.starts_with("{\0"sv) ||
      bytes.starts_with("\0{"sv))
    return std::string("text in UTF-16").append(kSave);
  return std::nullopt;
}

/// The first line that is neither blank nor a comment of OBJ files.
std::string_view first_statement(std::string_view text) {
  text = skip_blanks(text);
  while (text.starts_with('#')) {
    const auto end = text.find('\n');
    text = skip_blanks(end == text.npos ? std::string_view() : text.substr(end));
  }
  return text;
}

std::optional<std::string> wavefront(std::string_view text) {
  constexpr std::string_view kObj[] = {"v ", "vn ", "vt ", "f ", "o ", "g ", "s ", "mtllib ", "usemtl "};
  const std::string_view line = first_statement(text);
  const auto begins = [&](std::string_view word) { return line.starts_with(word); };
  if (std::any_of(std::begin(kObj), std::end(kObj), begins))
    return std::string("a Wavefront OBJ model; ").append(kViaBlender);
  if (begins("newmtl ")) return "a material library of a Wavefront OBJ model; import the model as glTF 2.0";
  return std::nullopt;
}

/// A binary STL file has no signature, but its size follows from its count of triangles.
bool is_binary_stl(std::string_view file) {
  if (file.size() < 84 + 50) return false;
  std::uint64_t triangles = 0;
  for (std::size_t i = 84; i-- > 80;) triangles = triangles << 8 | static_cast<unsigned char>(file[i]);
  return file.size() == 84 + 50 * triangles;
}

bool is_text(std::string_view head) {
  return std::none_of(head.begin(), head.end(), [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte == 0x7f || (byte < 0x20 && !is_blank(c) && c != '\f');
  });
}

std::string describe_unknown(std::string_view file) {
  const std::string_view text = skip_blanks(file), head = text.substr(0, 24);
  constexpr std::string_view kNext = "; a .gltf starts with { and a .glb with glTF";
  if (is_text(head))
    return "text that is not JSON: it starts with " + in_quotes(head.substr(0, head.find('\n'))) + std::string(kNext);
  constexpr char kHexDigits[] = "0123456789abcdef";
  std::string bytes;
  for (const char c : file.substr(0, 8)) {
    const auto byte = static_cast<unsigned char>(c);
    bytes += {' ', kHexDigits[byte >> 4], kHexDigits[byte & 15]};
  }
  return "binary data of an unknown kind, starting with the bytes" + bytes + std::string(kNext);
}

}  // namespace

std::optional<std::string> describe_stand_in(std::span<const std::byte> file) {
  const auto known = stand_in(as_text(file));
  return known ? std::optional<std::string>(*known) : std::nullopt;
}

std::optional<std::string> describe_foreign_file(std::span<const std::byte> file) {
  const std::string_view bytes = as_text(file);
  if (bytes.empty()) return "empty; copy or download it again";
  for (const FileSign& sign : kFileSigns)
    if (bytes.size() >= sign.at && bytes.substr(sign.at).starts_with(sign.bytes))
      return std::string(sign.kind).append("; ").append(sign.advice);
  if (bytes.starts_with("PK\3\4") || bytes.starts_with("PK\5\6")) return describe_zip(bytes);
  if (auto wide = wide_text(bytes)) return wide;
  if (auto known = describe_stand_in(file)) return known;
  const std::string_view text = skip_blanks(bytes);
  if (text.starts_with('{') || text.starts_with('[') || text.starts_with("glTF")) return std::nullopt;
  if (text.empty()) return "blank: it holds nothing but spaces; copy or download it again";
  if (text.starts_with('<') && is_text(text.substr(0, 24))) return std::string(describe_xml(text));
  if (auto model = wavefront(text)) return model;
  if (is_binary_stl(bytes)) return std::string("an STL model; ").append(kViaBlender);
  if (std::all_of(bytes.begin(), bytes.end(), [](char c) { return c == '\0'; }))
    return "nothing but zero bytes, as an interrupted copy leaves them; copy or download it again";
  return describe_unknown(bytes);
}

}  // namespace sinew
