// The files of the page, built into the program (cmake/EmbedFiles.cmake).

#ifndef GEODESIC_SERVER_WEB_PAGE_FILE_H_
#define GEODESIC_SERVER_WEB_PAGE_FILE_H_

#include <span>
#include <string_view>

namespace geodesic::server {

struct PageFile {
  std::string_view path;  // e.g. "/assets/main.js"
  std::string_view content_type;
  std::string_view etag;  // with its quotes
  std::string_view content;
};

// All there are. They live as long as the program.
std::span<const PageFile> PageFiles();

// The file at a path, where "/" stands for "/index.html"; null if there is
// none.
const PageFile* FindPageFile(std::string_view path);

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_WEB_PAGE_FILE_H_
