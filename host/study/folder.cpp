#include "study/folder.h"

#include <fmt/format.h>

#include "core/file.h"
#include "core/version.h"
#include "image/exr.h"
#include "study/display.h"
#include "study/json.h"
#include "study/page.h"

namespace lacquer::study {

namespace fs = std::filesystem;

namespace {

void write_picture(const StudyResult& result, const Figure& figure, const Picture& picture,
                   const fs::path& folder) {
    if (picture.name.empty()) return;
    const std::string file = (folder / picture_file(figure, picture)).string();
    const Metadata metadata{{"suite", std::string{result.suite->name}},
                            {"figure", figure.id},
                            {"samples", std::to_string(result.samples)},
                            {"seed", std::to_string(result.seed)},
                            {"version", kVersion}};
    write_file(file + ".png", png_of(picture));
    write_file(file + ".exr", encode_exr(picture.numbers, metadata));
}

}  // namespace

void write_study(const StudyResult& result, const fs::path& folder) {
    write_file(folder / "study.json", study_json(result));
    write_file(folder / "report.html", page_html(result));
    for (const Figure& figure : result.figures) {
        fs::create_directories(folder / "pictures" / figure.id);
        for (const Panel& panel : figure.panels) {
            if (const auto* table = std::get_if<PictureTable>(&panel))
                for (const PictureRow& row : table->rows)
                    for (const Picture& picture : row.pictures)
                        write_picture(result, figure, picture, folder);
            if (const auto* maps = std::get_if<Maps>(&panel))
                for (const Map& map : maps->maps)
                    write_picture(result, figure, map.picture, folder);
        }
    }
}

}  // namespace lacquer::study
