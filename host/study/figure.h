// What a study shows: figures of pictures, curves, maps and numbers, and how far each model is from
// simulation in them. Knows no model and no writer.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "image/image.h"
#include "markup/plot.h"

namespace lacquer::study {

// A picture and the numbers behind it. With a `limit` the numbers are signed differences, shown in
// colours up to it, or where `to_the_eye` those of FLIP, from 0; without, they are radiance as a
// display shows it.
struct Picture {
    std::string
        name;  // of its files, unique in the figure; empty: nothing stands here but the note
    Image numbers{};
    std::optional<double> limit{};
    std::string note{};  // stands below it
    bool to_the_eye = false;
};

struct PictureRow {
    std::string label;
    std::vector<Picture> pictures;  // one per column
};

struct PictureTable {
    std::string title;
    std::vector<std::string> columns;
    std::vector<PictureRow> rows;
    int column_width = 178;  // of the page's pixels, at most
};

struct Plots {
    std::string title;
    std::vector<Plot> plots;
};

// A function of two variables in the frame of a plot, as signed differences.
struct Map {
    Plot frame;
    Picture picture;  // its upper left corner is (x_from, y_to) of the frame
    std::string below = "too dark", above = "too bright";  // what the signs mean
};

struct Maps {
    std::string title;
    std::vector<Map> maps;
};

struct NumberTable {
    std::string title;
    std::vector<std::string> columns;
    std::vector<std::vector<std::string>> rows;
};

using Panel = std::variant<PictureTable, Plots, Maps, NumberTable>;

// How far `model` is from simulation in `subject`, one part of a figure.
struct ModelError {
    std::string subject, model;
    double mean = 0.0, max = 0.0;
    double noise = 0.0;      // what the simulation's noise alone makes of the mean, on average
    std::string where = {};  // of the maximum
};

struct Figure {
    std::string id;       // "figure-4", for file names and links
    std::string title;    // what it is
    std::string caption;  // what it shows, and why a model is off where it is
    std::string measure;  // what its errors are
    std::vector<Panel> panels{};
    std::vector<ModelError> errors{};
};

}  // namespace lacquer::study
